// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// PNG: what is written is read back by another decoder, pixel for pixel and text for text, in all three colour types. A
// file that cannot be written leaves nothing behind.

#include "testbed/picture/png.h"
#include "testbed/base/errors.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <random>

namespace testbed {
namespace {

class Png : public testing::Test {
protected:
    Png() : m_folder(std::filesystem::temp_directory_path() / ("scree-png-" + std::to_string(std::random_device{}()))) {
        std::filesystem::create_directories(m_folder);
    }
    ~Png() override { std::filesystem::remove_all(m_folder); }
    [[nodiscard]] std::filesystem::path GetPath(const char* name) const { return m_folder / name; }
    [[nodiscard]] size_t CountFiles() const {
        size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(m_folder)) ++count;
        return count;
    }

private:
    std::filesystem::path m_folder;
};

/// colors: how many different colours, at most width × height are used.
Image MakeNoise(int width, int height, unsigned colors, bool opaque) {
    std::mt19937 random(7);
    std::vector<Color> table;
    for (unsigned i = 0; i < colors; ++i) {
        const auto byte = [&random] { return static_cast<uint8_t>(random() % 256); };
        table.push_back({byte(), byte(), byte(), opaque ? uint8_t{255} : byte()});
    }
    Image image(width, height, table[0]);
    for (Color& pixel : image.pixels) pixel = table[random() % colors];
    return image;
}

/// Bytes of the IDAT chunk's contents by zlib, which checks the sum at their end; 0 when anything is wrong.
size_t InflateData(const std::vector<unsigned char>& file) {
    const std::string name = "IDAT";
    const auto found = std::search(file.begin(), file.end(), name.begin(), name.end());
    if (found == file.end()) return 0;
    std::vector<unsigned char> rows(size_t{1} << 23);
    uLongf size = rows.size();
    const auto length = static_cast<uLong>(file.end() - found - 4 - 16);  // a checksum and the IEND chunk follow
    return uncompress(rows.data(), &size, &*found + 4, length) == Z_OK ? size : 0;
}

TEST_F(Png, PixelsAndTextComeBack) {
    const std::vector<PngText> text{{"scene", "tiles"}, {"command", "scree overlap tiles -o out"}, {"empty", ""}};
    for (const bool opaque : {true, false}) {
        for (const unsigned colors : {1u, 2u, 256u, 257u, 5000u}) {
            const Image image = MakeNoise(123, 77, colors, opaque);
            WritePng(GetPath("a.png"), image, text);
            const Image back = ReadPng(GetPath("a.png"));
            EXPECT_EQ(back.width, 123);
            EXPECT_EQ(back.height, 77);
            EXPECT_TRUE(back.pixels == image.pixels) << colors << " colours";
            const std::vector<PngText> textBack = ReadPngText(GetPath("a.png"));
            ASSERT_EQ(textBack.size(), text.size());
            for (size_t i = 0; i < text.size(); ++i) {
                EXPECT_EQ(textBack[i].key, text[i].key);
                EXPECT_EQ(textBack[i].value, text[i].value);
            }
        }
    }
    EXPECT_EQ(CountFiles(), 1u) << "temporary files are gone, the picture was replaced";
}

TEST_F(Png, LargePicturesAreCompressedInPartsThatFit) {
    // 3 MB of rows and 1 MB of indices and a few odd sizes about the limit; stb_image checks no checksum, zlib does.
    for (const unsigned colors : {200u, 2000u}) {
        for (const int height : {349, 350, 699, 1050}) {
            const Image image = MakeNoise(1000, height, colors, true);
            WritePng(GetPath("a.png"), image);
            EXPECT_TRUE(ReadPng(GetPath("a.png")).pixels == image.pixels);
            EXPECT_EQ(InflateData(EncodePng(image)), static_cast<size_t>(height) * (colors > 256 ? 3001 : 1001));
        }
    }
}

TEST_F(Png, OnePixel) {
    WritePng(GetPath("a.png"), Image(1, 1, {1, 2, 3, 255}));
    EXPECT_EQ(ReadPng(GetPath("a.png")).At(0, 0), (Color{1, 2, 3, 255}));
}

TEST_F(Png, FewColoursMakeAPalette) {
    const std::vector<unsigned char> few = EncodePng(MakeNoise(64, 64, 256, true));
    const std::vector<unsigned char> many = EncodePng(MakeNoise(64, 64, 257, true));
    EXPECT_EQ(few[25], 3);  // colour type in the header
    EXPECT_EQ(many[25], 2);
    EXPECT_EQ(EncodePng(MakeNoise(64, 64, 2, false))[25], 6);
}

TEST_F(Png, ProblemsNameTheFile) {
    EXPECT_THROW(WritePng(GetPath("no/such/folder/a.png"), Image(2, 2, {})), FileError);
    std::filesystem::create_directories(GetPath("folder.png") / "inside");
    EXPECT_THROW(WritePng(GetPath("folder.png"), Image(2, 2, {})), FileError);
    EXPECT_EQ(CountFiles(), 1u) << "only the folder itself";
    EXPECT_THROW((void)ReadPng(GetPath("missing.png")), FileError);
    EXPECT_THROW((void)ReadPngText(GetPath("missing.png")), FileError);
    EXPECT_THROW((void)EncodePng({}), std::invalid_argument);
    EXPECT_THROW((void)EncodePng(Image(1, 1, {}), std::vector<PngText>{{"", "x"}}), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
