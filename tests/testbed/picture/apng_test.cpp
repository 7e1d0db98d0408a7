// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Animated PNG, read back by a reader of the specification. Chunks are in order with right checksums and sequence
// numbers, and frames lie inside the picture. The pixels are the same after they are put together.

#include "testbed/picture/apng.h"
#include "testbed/base/errors.h"
#include "testbed/picture/png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>

namespace testbed {
namespace {

using Bytes = std::vector<unsigned char>;

struct Chunk {
    std::string type;
    Bytes data;
};

uint32_t NumberAt(const Bytes& bytes, size_t at) {
    uint32_t number = 0;
    for (size_t i = 0; i < 4; ++i) number = number * 256 + bytes.at(at + i);
    return number;
}

/// The checksum bit by bit from its polynomial, as the PNG specification's appendix D has it.
uint32_t Checksum(const Bytes& bytes, size_t from, size_t to) {
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = from; i < to; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? 0xEDB88320u ^ (crc >> 1) : crc >> 1;
    }
    return ~crc;
}

std::vector<Chunk> ReadChunks(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const Bytes bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_EQ(NumberAt(bytes, 0), 0x89504E47u);
    EXPECT_EQ(NumberAt(bytes, 4), 0x0D0A1A0Au);
    std::vector<Chunk> chunks;
    for (size_t at = 8; at < bytes.size();) {
        const size_t length = NumberAt(bytes, at);
        EXPECT_EQ(NumberAt(bytes, at + 8 + length), Checksum(bytes, at + 4, at + 8 + length));
        const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at + 4);
        chunks.push_back(
            {std::string(begin, begin + 4), Bytes(begin + 4, begin + 4 + static_cast<std::ptrdiff_t>(length))});
        at += 12 + length;
    }
    return chunks;
}

/// Pixels of a frame into the picture below it; only the filters none and up are known.
void PutFrame(const Bytes& control, const unsigned char* data, size_t size, Image& picture) {
    const uint32_t width = NumberAt(control, 4), height = NumberAt(control, 8);
    const uint32_t left = NumberAt(control, 12), top = NumberAt(control, 16);
    ASSERT_GT(width, 0u);
    ASSERT_GT(height, 0u);
    ASSERT_LE(left + width, static_cast<uint32_t>(picture.width));
    ASSERT_LE(top + height, static_cast<uint32_t>(picture.height));
    Bytes rows((width * 3 + 1) * height);
    uLongf length = rows.size();
    ASSERT_EQ(uncompress(rows.data(), &length, data, size), Z_OK);
    ASSERT_EQ(length, rows.size());
    Bytes above(width * 3, 0);
    for (uint32_t y = 0; y < height; ++y) {
        const unsigned char* row = rows.data() + y * (width * 3 + 1);
        ASSERT_TRUE(row[0] == 0 || row[0] == 2);
        for (uint32_t i = 0; i < width * 3; ++i) {
            above[i] = static_cast<unsigned char>(row[1 + i] + (row[0] == 2 ? above[i] : 0));
        }
        for (uint32_t x = 0; x < width; ++x) {
            picture.At(static_cast<int>(left + x), static_cast<int>(top + y)) = {above[3 * x], above[3 * x + 1],
                                                                                 above[3 * x + 2], 255};
        }
    }
}

/// All frames as a program would show them.
std::vector<Image> ReadFrames(const std::filesystem::path& path) {
    const std::vector<Chunk> chunks = ReadChunks(path);
    EXPECT_EQ(chunks.front().type, "IHDR");
    EXPECT_EQ(chunks.at(1).type, "acTL");
    EXPECT_EQ(chunks.back().type, "IEND");
    Image picture(static_cast<int>(NumberAt(chunks[0].data, 0)), static_cast<int>(NumberAt(chunks[0].data, 4)), {});
    std::vector<Image> frames;
    uint32_t sequence = 0;
    Bytes control;
    for (const Chunk& chunk : chunks) {
        if (chunk.type == "fcTL") {
            EXPECT_EQ(NumberAt(chunk.data, 0), sequence++);
            EXPECT_EQ(chunk.data.size(), 26u);
            control = chunk.data;
        } else if (chunk.type == "IDAT") {
            EXPECT_TRUE(frames.empty());
            EXPECT_EQ(NumberAt(control, 4), static_cast<uint32_t>(picture.width)) << "the first frame is whole";
            EXPECT_EQ(NumberAt(control, 8), static_cast<uint32_t>(picture.height));
            PutFrame(control, chunk.data.data(), chunk.data.size(), picture);
            frames.push_back(picture);
        } else if (chunk.type == "fdAT") {
            EXPECT_EQ(NumberAt(chunk.data, 0), sequence++);
            PutFrame(control, chunk.data.data() + 4, chunk.data.size() - 4, picture);
            frames.push_back(picture);
        }
    }
    EXPECT_EQ(NumberAt(chunks[1].data, 0), frames.size());
    EXPECT_EQ(NumberAt(chunks[1].data, 4), 0u) << "for ever";
    return frames;
}

class Apng : public testing::Test {
protected:
    Apng()
        : m_folder(std::filesystem::temp_directory_path() / ("scree-apng-" + std::to_string(std::random_device{}()))) {
        std::filesystem::create_directories(m_folder);
    }
    ~Apng() override { std::filesystem::remove_all(m_folder); }
    [[nodiscard]] std::filesystem::path GetPath(const char* name) const { return m_folder / name; }

private:
    std::filesystem::path m_folder;
};

/// A square that wanders over noise; the third frame repeats the second, the last one changes everything.
std::vector<Image> MakeFrames() {
    std::mt19937 random(11);
    Image noise(61, 43, {});
    for (Color& pixel : noise.pixels) {
        const auto bits = static_cast<uint32_t>(random());
        pixel = {static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8), static_cast<uint8_t>(bits >> 16), 255};
    }
    std::vector<Image> frames;
    for (const int place : {0, 20, 20, 38}) {
        Image frame = noise;
        for (int y = place; y < place + 5; ++y) {
            for (int x = place; x < place + 9; ++x) frame.At(x, y) = {255, 255, 255, 255};
        }
        frames.push_back(frame);
    }
    frames.emplace_back(61, 43, Color{1, 2, 3, 255});
    return frames;
}

TEST_F(Apng, FramesComeBack) {
    const std::vector<Image> frames = MakeFrames();
    const std::vector<PngText> text{{"Scene", "tiles 6"}};
    ApngWriter writer(GetPath("a.apng"), 25, text);
    for (const Image& frame : frames) writer.Add(frame);
    writer.Finish();
    const std::vector<Image> back = ReadFrames(GetPath("a.apng"));
    ASSERT_EQ(back.size(), frames.size());
    for (size_t i = 0; i < frames.size(); ++i) EXPECT_TRUE(back[i].pixels == frames[i].pixels) << i;
    EXPECT_TRUE(ReadPng(GetPath("a.apng")).pixels == frames[0].pixels) << "any PNG reader shows the first frame";
    ASSERT_EQ(ReadPngText(GetPath("a.apng")).size(), 1u);
    EXPECT_EQ(ReadPngText(GetPath("a.apng"))[0].value, "tiles 6");
}

TEST_F(Apng, AFrameStoresWhatChangedAndItsDelay) {
    ApngWriter writer(GetPath("a.apng"), 25);
    for (const Image& frame : MakeFrames()) writer.Add(frame);
    writer.Finish();
    std::vector<Bytes> controls;
    for (const Chunk& chunk : ReadChunks(GetPath("a.apng"))) {
        if (chunk.type == "fcTL") controls.push_back(chunk.data);
    }
    ASSERT_EQ(controls.size(), 5u);
    const auto box = [&controls](size_t frame) {
        std::vector<uint32_t> numbers;
        for (size_t i = 4; i < 20; i += 4) numbers.push_back(NumberAt(controls[frame], i));
        return numbers;
    };
    EXPECT_EQ(box(1), (std::vector<uint32_t>{29, 25, 0, 0})) << "old and new place";
    EXPECT_EQ(box(2), (std::vector<uint32_t>{1, 1, 0, 0})) << "nothing changed; a frame has at least a pixel";
    for (const Bytes& control : controls) {
        EXPECT_EQ(control[20] * 256 + control[21], 1);
        EXPECT_EQ(control[22] * 256 + control[23], 25);
    }
}

TEST_F(Apng, BadFramesAreRefusedAndUnfinishedFilesGo) {
    {
        ApngWriter writer(GetPath("a.apng"), 25);
        EXPECT_THROW(writer.Finish(), std::logic_error);
        writer.Add(Image(4, 4, {}));
        EXPECT_THROW(writer.Add(Image(4, 5, {})), std::invalid_argument);
    }
    EXPECT_FALSE(std::filesystem::exists(GetPath("a.apng")));
    EXPECT_THROW(ApngWriter(GetPath("no/folder.apng"), 25), FileError);
    EXPECT_THROW(ApngWriter(GetPath("a.apng"), 0), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
