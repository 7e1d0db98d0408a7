// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Numbers and characters survive being written and read, whatever is no number says why, and parts join to what was
// split.

#include "testbed/base/text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace testbed {
namespace {

std::u32string ReadUtf8(std::string_view text) {
    std::u32string read;
    while (!text.empty()) read += TakeUtf8(text);
    return read;
}

/// The bytes of one character, by the definition.
std::string WriteUtf8(char32_t c) {
    const auto byte = [](char32_t value) { return static_cast<char>(static_cast<unsigned char>(value)); };
    const auto next = [&](int shift) { return byte(0x80 | (c >> shift & 0x3F)); };
    if (c < 0x80) return {byte(c)};
    if (c < 0x800) return {byte(0xC0 | c >> 6), next(0)};
    if (c < 0x10000) return {byte(0xE0 | c >> 12), next(6), next(0)};
    return {byte(0xF0 | c >> 18), next(12), next(6), next(0)};
}

TEST(Text, Utf8ReadsBack) {
    EXPECT_TRUE(rc::check("UTF-8", [](const std::vector<uint32_t>& numbers) {
        std::u32string characters;
        std::string text;
        for (const uint32_t number : numbers) {
            const char32_t c = number % 0x110000;
            if (c >= 0xD800 && c < 0xE000) continue;  // surrogates are no characters
            characters += c;
            text += WriteUtf8(c);
        }
        RC_ASSERT(ReadUtf8(text) == characters);
    }));
}

TEST(Text, ControlCharactersBecomeTheirSymbols) {
    EXPECT_EQ(ToPrintable("M\u00FCller \u03BC<&\""), "M\u00FCller \u03BC<&\"");
    EXPECT_EQ(ToPrintable("two\nlines\x1B[31m\x7F"), "two\u240Alines\u241B[31m\u2421");
    EXPECT_EQ(ToPrintable(std::string(1, '\0')), "\u2400");
    EXPECT_EQ(ToPrintable("M\xFCller \xC2\x9B\uFFFE"), "M\uFFFDller \uFFFD\uFFFD");
}

TEST(Text, PathsInLinksKeepTheirMeaning) {
    EXPECT_EQ(QuoteForLink("../level 1/run#2?.html"), "../level%201/run%232%3F.html");
    EXPECT_EQ(QuoteForLink("100%.html"), "100%25.html");
    EXPECT_EQ(QuoteForLink("M\u00FCller_a-b.c,d.html"), "M\u00FCller_a-b.c,d.html");
}

TEST(Text, BytesThatAreNoUtf8AreReplaced) {
    // The examples of Unicode 15, tables 3-8 to 3-11.
    EXPECT_EQ(ReadUtf8("\xC0\xAF\xE0\x80\xBF\xF0\x81\x82\x41"), U"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFDA");
    EXPECT_EQ(ReadUtf8("\xED\xA0\x80\xED\xBF\xBF\xED\xAF\x41"), U"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFDA");
    EXPECT_EQ(ReadUtf8("\xF4\x91\x92\x93\xFF\x41\x80\xBF\x42"), U"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFDA\uFFFD\uFFFDB");
    EXPECT_EQ(ReadUtf8("\xE1\x80\xE2\xF0\x91\x92\xF1\xBF\x41"), U"\uFFFD\uFFFD\uFFFD\uFFFDA");
    EXPECT_EQ(ReadUtf8("\xE2\x82"), U"\uFFFD") << "cut off";
}

TEST(Text, WholeNumbersReadBack) {
    EXPECT_TRUE(rc::check("int", [](int value) {
        const Parsed<int> parsed = ParseNumber<int>(std::to_string(value));
        RC_ASSERT(static_cast<bool>(parsed));
        RC_ASSERT(*parsed == value);
    }));
}

TEST(Text, RealNumbersReadBack) {
    EXPECT_TRUE(rc::check("double", [](uint64_t bits) {
        const double value = std::bit_cast<double>(bits);
        const Parsed<double> parsed = ParseNumber<double>(fmt::format("{}", value));
        RC_ASSERT(static_cast<bool>(parsed) == std::isfinite(value));
        if (parsed) RC_ASSERT(*parsed == value);
    }));
}

TEST(Text, HashesReadBack) {
    EXPECT_TRUE(rc::check("hash", [](uint64_t hash) {
        RC_ASSERT(FormatHash(hash).size() == 16u);
        RC_ASSERT(*ParseHash(FormatHash(hash)) == hash);
    }));
    EXPECT_EQ(ParseHash("12g").problem, "'12g' is not a hash in hexadecimal digits");
}

TEST(Text, AShellReadsBackWhatWasQuoted) {
    EXPECT_EQ(QuoteForShell("out/a-b_1.zip"), "out/a-b_1.zip");
    for (const std::string word : {"", "a b", "it's", "^x$", "a\"b\\", "$(false)", "'", "äö", "~", "a\nb"}) {
        FILE* pipe = popen(("printf %s " + QuoteForShell(word)).c_str(), "r");
        ASSERT_NE(pipe, nullptr);
        std::string back;
        for (int c = 0; (c = std::fgetc(pipe)) != EOF;) back += static_cast<char>(c);
        pclose(pipe);
        EXPECT_EQ(back, word);
    }
}

TEST(Text, WhatIsNoNumberSaysWhy) {
    for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
             {"", "a whole number is missing"},
             {"x", "'x' is not a whole number"},
             {"12x", "'12x' is not a whole number"},
             {"1.5", "'1.5' is not a whole number"},
             {" 1", "' 1' is not a whole number"},
             {"+1", "'+1' is not a whole number"},
             {"99999999999", "'99999999999' is beyond the numbers that can be held"}}) {
        EXPECT_EQ(ParseNumber<int>(text).problem, problem);
    }
    EXPECT_EQ(ParseNumber<double>("").problem, "a number is missing");
    EXPECT_EQ(ParseNumber<float>("1e99").problem, "'1e99' is beyond the numbers that can be held");
    EXPECT_EQ(ParseNumber<double>("inf").problem, "'inf' is not finite");
    EXPECT_EQ(ParseNumber<double>("nan").problem, "'nan' is not finite");
    EXPECT_EQ(BeforeCure(ParseNumber<int>("x").problem), "'x' is not a whole number; ");
    EXPECT_EQ(BeforeCure(ParseNumber<int>("1").problem), "");
}

TEST(Text, PartsJoinToWhatWasSplit) {
    EXPECT_TRUE(rc::check("split", [] {
        const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,\n")));
        std::string joined;
        for (const std::string_view part : Split(text, ',')) {
            RC_ASSERT(part.find(',') == std::string_view::npos);
            joined += std::string(part) + ",";
        }
        RC_ASSERT(joined == text + ",");
    }));
}

TEST(Text, LinesKeepTheirNumbers) {
    std::vector<std::pair<std::size_t, std::string>> lines;
    ForEachLine("one\n\nthree\n", [&](std::size_t number, std::string_view line) { lines.emplace_back(number, line); });
    EXPECT_EQ(lines, (std::vector<std::pair<std::size_t, std::string>>{{1, "one"}, {3, "three"}}));
    ForEachLine("", [](std::size_t, std::string_view) { ADD_FAILURE() << "no line in nothing"; });
}

}  // namespace
}  // namespace testbed
