// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of text.h.

#include "testbed/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <type_traits>

namespace testbed {

namespace {

constexpr char32_t replacementCharacter = 0xFFFD;

/// Reads the whole text by from_chars with these arguments after the value; `kind` names what it should be.
template <typename Number, typename... Arguments>
Parsed<Number> ParseBy(std::string_view text, std::string_view kind, Arguments... arguments) {
    Parsed<Number> parsed;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, parsed.value, arguments...);
    if (error == std::errc::result_out_of_range && end == last) {
        parsed.problem = fmt::format("'{}' is beyond the numbers that can be held", text);
    } else if (text.empty()) {
        parsed.problem = fmt::format("{} is missing", kind);
    } else if (error != std::errc() || end != last) {
        parsed.problem = fmt::format("'{}' is not {}", text, kind);
    }
    return parsed;
}

}  // namespace

std::vector<std::string_view> Split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

void ForEachLine(std::string_view text, const std::function<void(std::size_t number, std::string_view line)>& visit) {
    std::size_t number = 0;
    for (const std::string_view line : Split(text, '\n')) {
        ++number;
        if (!line.empty()) visit(number, line);
    }
}

char32_t TakeUtf8(std::string_view& text) {
    const auto first = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    if (first < 0x80) return first;
    if (first < 0xC2 || first > 0xF4) return replacementCharacter;
    const int more = first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    char32_t character = first & (0x3Fu >> more);
    // The second byte alone tells longer spellings than needed, surrogates and what lies beyond U+10FFFF.
    unsigned least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    unsigned most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    for (int i = 0; i < more; ++i) {
        if (text.empty()) return replacementCharacter;
        const auto next = static_cast<unsigned char>(text.front());
        if (next < least || next > most) return replacementCharacter;
        text.remove_prefix(1);
        character = character << 6 | (next & 0x3Fu);
        least = 0x80, most = 0xBF;
    }
    return character;
}

std::string ToPrintable(std::string_view text) {
    std::string printable;
    while (!text.empty()) {
        const std::string_view before = text;
        const char32_t c = TakeUtf8(text);
        const bool hasSymbol = c < 0x20 || c == 0x7F, isOtherControl = c > 0x7F && c < 0xA0;
        if (hasSymbol) {
            // U+2400 and what follows, in the same order; U+2421 of U+007F.
            printable += {'\xE2', '\x90', static_cast<char>(c == 0x7F ? 0xA1 : 0x80 + c)};
        } else if (isOtherControl || c == replacementCharacter || c == 0xFFFE || c == 0xFFFF) {
            printable += "\uFFFD";
        } else {
            printable += before.substr(0, before.size() - text.size());
        }
    }
    return printable;
}

template <typename Number>
Parsed<Number> ParseNumber(std::string_view text) {
    if constexpr (std::is_integral_v<Number>) {
        return ParseBy<Number>(text, "a whole number");
    } else {
        Parsed<Number> parsed = ParseBy<Number>(text, "a number");
        if (parsed && !std::isfinite(parsed.value)) parsed.problem = fmt::format("'{}' is not finite", text);
        return parsed;
    }
}
template Parsed<int> ParseNumber(std::string_view text);
template Parsed<float> ParseNumber(std::string_view text);
template Parsed<double> ParseNumber(std::string_view text);

std::string BeforeCure(const std::string& problem) { return problem.empty() ? problem : problem + "; "; }

std::string QuoteForShell(std::string_view word) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
    if (!word.empty() && word.find_first_not_of(letters) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string QuoteForLink(std::string_view path) {
    constexpr std::string_view special = " %#?\"<>\\^`{|}";
    std::string quoted;
    for (const char c : path) {
        const bool isSpecial = special.find(c) != std::string_view::npos || static_cast<unsigned char>(c) < 0x20;
        quoted += isSpecial ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
    }
    return quoted;
}

std::string FormatHash(uint64_t hash) { return fmt::format("{:016x}", hash); }

Parsed<uint64_t> ParseHash(std::string_view text) {
    return ParseBy<uint64_t>(text, "a hash in hexadecimal digits", 16);
}

}  // namespace testbed
