// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contact sheets: small copies keep the mean of a picture, cells stand where they should, and nothing is lost.

#include "testbed/view/contact_sheet.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace testbed {
namespace {

TEST(ShrinkImage, KeepsTheMeanOfWholeBlocks) {
    std::mt19937 random(5);
    Image image(60, 40, {});
    for (Color& pixel : image.pixels) pixel = {static_cast<uint8_t>(random() % 256), 7, 0, 255};
    const Image small = ShrinkImage(image, 20, 10);  // blocks of 3 × 4
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 20; ++x) {
            double sum = 0;
            for (int i = 0; i < 12; ++i) sum += image.At(3 * x + i % 3, 4 * y + i / 3).r;
            EXPECT_NEAR(small.At(x, y).r, sum / 12, 0.5) << "rounded once";
            EXPECT_EQ(small.At(x, y).g, 7);
            EXPECT_EQ(small.At(x, y).a, 255);
        }
    }
    EXPECT_TRUE(ShrinkImage(image, 60, 40).pixels == image.pixels);
    EXPECT_THROW((void)ShrinkImage(image, 61, 40), std::invalid_argument);
}

TEST(ContactSheet, EveryPictureHasItsCell) {
    ContactSheet sheet(5, 640, Theme::dark);  // three columns, two rows
    for (int i = 0; i < 5; ++i) {
        sheet.Add(Image(400, 200, Color{static_cast<uint8_t>(100 + i), 0, 0, 255}), "step " + std::to_string(i));
    }
    const Image made = sheet.Make();
    EXPECT_EQ(made.width, 640);
    const int cellWidth = (640 - 4 * 6) / 3;
    std::vector<int> pixels(5, 0);
    int words = 0;
    for (const Color& color : made.pixels) {
        if (color.g == 0) ++pixels[static_cast<size_t>(color.r - 100)];
        const bool isLetter = color.g > GetTheme(Theme::dark).strip.g;
        words += isLetter ? 1 : 0;
    }
    for (const int count : pixels) EXPECT_EQ(count, cellWidth * (cellWidth / 2));
    EXPECT_GT(words, 5 * 30) << "labels of some 6 letters";
    EXPECT_EQ(made.At(6, 6).r, 100);
    EXPECT_EQ(made.At(6 + 2 * (cellWidth + 6), 6).r, 102);
}

TEST(ContactSheet, RefusesWhatHasNoRoom) {
    EXPECT_TRUE(ContactSheet::Fits(1, 320));
    EXPECT_TRUE(ContactSheet::Fits(300, 1920));
    EXPECT_FALSE(ContactSheet::Fits(400, 1920));
    EXPECT_THROW(ContactSheet(400, 1920, Theme::dark), std::invalid_argument);
    EXPECT_THROW((void)ContactSheet(4, 1920, Theme::dark).Make(), std::logic_error);
}

}  // namespace
}  // namespace testbed
