// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text taken apart: parts between separators, lines, characters, and numbers, which say what is wrong with a text that
// is none.

#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace testbed {

/// The parts between separators: one more than there are separators, empty ones included.
[[nodiscard]] std::vector<std::string_view> Split(std::string_view text, char separator);
/// The parts of a text that is gone would be gone too.
template <typename Text>
requires std::same_as<Text, std::string> std::vector<std::string_view> Split(Text&& text, char separator)
= delete;

/// Calls visit(number, line) for every line that is not empty; numbers begin at 1 and count the empty ones too. A line
/// feed at the end begins no further line.
void ForEachLine(std::string_view text, const std::function<void(std::size_t number, std::string_view line)>& visit);

/// The character that UTF-8 text begins with, which it loses. What is none gives U+FFFD and loses one byte, or all
/// those that could begin a character (Unicode 15, section 3.9). The text is not empty.
[[nodiscard]] char32_t TakeUtf8(std::string_view& text);

/// UTF-8 for lines and for XML, which control characters would break: they become their symbols, such as \u241B for
/// escape, and what is no UTF-8 becomes U+FFFD.
[[nodiscard]] std::string ToPrintable(std::string_view text);

/// What a text says as a number, or why it says none: "'12x' is not a whole number".
template <typename Number>
struct Parsed {
    Number value{};
    std::string problem;  ///< empty: none

    explicit operator bool() const { return problem.empty(); }
    const Number& operator*() const { return value; }
};

/// The whole text as a number in decimal digits, without a plus or blanks. Real numbers are finite.
template <typename Number>
[[nodiscard]] Parsed<Number> ParseNumber(std::string_view text);
extern template Parsed<int> ParseNumber(std::string_view text);
extern template Parsed<float> ParseNumber(std::string_view text);
extern template Parsed<double> ParseNumber(std::string_view text);

/// "PROBLEM; " for a message that goes on with what to give instead; nothing for none.
[[nodiscard]] std::string BeforeCure(const std::string& problem);

/// A word as a shell takes it: quoted unless it consists of letters, digits and signs that mean nothing to a shell.
[[nodiscard]] std::string QuoteForShell(std::string_view word);

/// A path as the part of a link before "#": what has a meaning there is written as %20, %23 and so on.
[[nodiscard]] std::string QuoteForLink(std::string_view path);

/// 64 bits as they are written where numbers cannot hold them: 16 hexadecimal digits.
[[nodiscard]] std::string FormatHash(uint64_t hash);
[[nodiscard]] Parsed<uint64_t> ParseHash(std::string_view text);

}  // namespace testbed
