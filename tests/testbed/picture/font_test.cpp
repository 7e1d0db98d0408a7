// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text is as wide as GetTextWidth says, its capitals are as high as promised, and every character can be seen. Bytes
// that are no UTF-8 are replaced. The pixels are the same on every machine.

#include "testbed/picture/font.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "testbed/base/hash.h"

namespace testbed {
namespace {

constexpr Color fontPaper{0, 0, 0, 255}, fontInk{255, 255, 255, 255};

/// What is not paper, as a half-open box; empty boxes are all zero.
PixelBox FindInk(const Image& image) {
    PixelBox box{image.width, image.height, 0, 0};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.At(x, y) == fontPaper) continue;
            box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), std::max(box.y1, y + 1)};
        }
    }
    return box.x0 < box.x1 ? box : PixelBox{};
}

Image DrawOnPaper(std::string_view text, int scale, int x, int y, int width = 240, int height = 60) {
    Image image(width, height, fontPaper);
    DrawText(image, x, y, text, scale, fontInk);
    return image;
}

/// Characters that pictures use, names have, or fonts lack.
const std::vector<std::string> someCharacters{"a", "W",  "j",    "1",        "7",  ".", " ", "μ", "×",
                                              "²", "°",  "≥",    "−",        "–",  "Ä", "ß", "é", "λ",
                                              "Ж", "中", "\xFF", "\xE2\x82", "\n", "́",  "€", "f"};

TEST(Font, WidthIsTheDrawnExtent) {
    EXPECT_TRUE(rc::check("width", [] {
        const int scale = *rc::gen::inRange(1, 4);
        std::string text;
        const int count = *rc::gen::inRange(0, 8);
        for (int i = 0; i < count; ++i) text += *rc::gen::elementOf(someCharacters);
        const int x = *rc::gen::inRange(1, 30);
        const Image image = DrawOnPaper(text, scale, x, 40, 500, 100);
        const PixelBox ink = FindInk(image);
        RC_ASSERT(ink.x1 - ink.x0 == GetTextWidth(text, scale));
        if (ink.x1 > 0) RC_ASSERT(ink.x0 == x);
    }));
    EXPECT_EQ(GetTextWidth("", 1), 0);
    EXPECT_EQ(GetTextWidth("   ", 2), 0);
    EXPECT_EQ(GetTextWidth(" a ", 2), GetTextWidth("a", 2));
}

TEST(Font, CapitalsAreAsHighAsPromised) {
    for (const int scale : {1, 2, 3}) {
        for (const char* text : {"H", "E", "T", "HTI"}) {
            const PixelBox ink = FindInk(DrawOnPaper(text, scale, 3, 10));
            EXPECT_EQ(ink.y0, 10) << text << " at scale " << scale;
            EXPECT_EQ(ink.y1, 10 + capHeight * scale) << text << " at scale " << scale;
        }
        // A line's letters leave the next line's alone.
        const PixelBox ink = FindInk(DrawOnPaper("Äjgy|(Q_", scale, 3, 10));
        EXPECT_LE(ink.y1 - 10, lineHeight * scale);
        EXPECT_LE(ink.y1 - ink.y0, (lineHeight + 2) * scale) << "accents of capitals reach into the line's gap";
    }
}

TEST(Font, EveryCharacterIsSeenAndNoTwoAreAlike) {
    std::map<std::vector<uint8_t>, std::string> seen;
    std::vector<std::string> characters{"μ", "×", "²", "°", "≥", "−", "…", "Ä", "λ", "Ж", "\xFF", "中"};
    for (char character = '!'; character <= '~'; ++character) characters.emplace_back(1, character);
    for (const std::string& character : characters) {
        const Image image = DrawOnPaper(character, 1, 20, 20, 60, 60);
        std::vector<uint8_t> pixels;
        for (const Color& color : image.pixels) pixels.push_back(color.r);
        EXPECT_TRUE(std::ranges::any_of(pixels, [](uint8_t value) { return value > 128; })) << character;
        EXPECT_TRUE(seen.emplace(pixels, character).second) << character << " looks like " << seen[pixels];
    }
}

TEST(Font, BytesThatAreNoUtf8AreReplaced) {
    for (const char* bytes : {"\xFF", "\x80", "\xC3", "\xED\xA0"}) {
        const std::string replaced = bytes == std::string("\xED\xA0") ? "a\uFFFD\uFFFDb" : "a\uFFFDb";
        EXPECT_TRUE(DrawOnPaper(std::string("a") + bytes + "b", 2, 3, 10).pixels ==
                    DrawOnPaper(replaced, 2, 3, 10).pixels);
    }
    // What the font lacks is one visible box, whatever it is.
    EXPECT_TRUE(DrawOnPaper("中", 2, 3, 10).pixels == DrawOnPaper("語", 2, 3, 10).pixels);
    EXPECT_GT(GetTextWidth("中", 2), 0);
}

TEST(Font, ClipsAtAllEdges) {
    const Image whole = DrawOnPaper("Clip", 3, 60, 60, 240, 180);
    for (const auto& [x, y] : {std::pair{-10, -10}, std::pair{35, 10}, std::pair{10, 20}, std::pair{500, 500}}) {
        const Image part = DrawOnPaper("Clip", 3, x, y, 40, 30);
        for (int row = 0; row < 30; ++row) {
            for (int column = 0; column < 40; ++column) {
                const int fromX = column - x + 60, fromY = row - y + 60;
                const bool isInside = fromX >= 0 && fromX < 240 && fromY >= 0 && fromY < 180;
                EXPECT_EQ(part.At(column, row), isInside ? whole.At(fromX, fromY) : fontPaper);
            }
        }
    }
}

TEST(Font, BlendsInFewSteps) {
    std::set<uint8_t> values;
    for (const Color& color : DrawOnPaper("The quick brown fox @ 90°", 2, 3, 10, 600, 60).pixels)
        values.insert(color.r);
    EXPECT_LE(values.size(), 16u) << "pictures keep a palette";
    EXPECT_GE(values.size(), 8u) << "letters are antialiased";
    Image image(60, 40, {10, 20, 30, 255});
    DrawText(image, 3, 10, "HHH", 2, {250, 240, 230, 0});
    EXPECT_TRUE(std::ranges::all_of(image.pixels, [](const Color& c) {
        return c == Color{10, 20, 30, 255};
    })) << "a transparent colour leaves no trace";
}

TEST(Font, PixelsAreThoseOfEveryMachine) {
    Fnv1a<uint64_t> hash;
    for (const int scale : {1, 2}) {
        for (const Color& color : DrawOnPaper("Überlapp 0.121 × 2² μm 90° ≥ 148", scale, 3, 12, 600, 60).pixels)
            hash.Add(color.r);
    }
    // Of DejaVu Sans 2.37 and stb_truetype 1.26. Another version of either may draw other letters.
    EXPECT_EQ(hash.Get(), 313125120829772330u);
}

TEST(Font, CutTextFitsAndSaysThatItIsCut) {
    EXPECT_TRUE(rc::check("cut", [] {
        std::string text;
        const int count = *rc::gen::inRange(0, 20);
        for (int i = 0; i < count; ++i) text += *rc::gen::elementOf(someCharacters);
        const int scale = *rc::gen::inRange(1, 3), room = *rc::gen::inRange(0, 200);
        const std::string cut = CutText(text, scale, room);
        RC_ASSERT(GetTextWidth(cut, scale) <= room);
        if (GetTextWidth(text, scale) <= room) {
            RC_ASSERT(cut == text);
        } else {
            RC_ASSERT(cut.empty() || cut.ends_with("…"));
        }
    }));
    EXPECT_EQ(CutText("abc", 1, 1000), "abc");
    EXPECT_EQ(CutText("abc", 1, 0), "");
}

}  // namespace
}  // namespace testbed
