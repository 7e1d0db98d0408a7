// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chunks in their order, and the palette; stb_image reads.

#include "testbed/picture/png.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "testbed/base/errors.h"
#include "testbed/picture/png_chunks.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace testbed {

namespace {

using namespace png;

constexpr size_t maxPaletteSize = 256;
constexpr unsigned char filterNone = 0;

/// The picture's colours when there are few enough for a palette, with an open-addressing table from colour to index.
class ColorTable {
public:
    /// Index of a colour, added when new; −1 when the palette is full.
    int Find(const Color& color) {
        uint32_t key = 0;
        std::memcpy(&key, &color, sizeof key);
        size_t slot = key * 2654435761u >> 22;  // Knuth's multiplicative hash, top 10 bits
        while (m_slots[slot] >= 0 && !(m_colors[static_cast<size_t>(m_slots[slot])] == color))
            slot = (slot + 1) % m_slots.size();
        if (m_slots[slot] < 0) {
            if (m_colors.size() == maxPaletteSize) return -1;
            m_slots[slot] = static_cast<int16_t>(m_colors.size());
            m_colors.push_back(color);
        }
        return m_slots[slot];
    }
    [[nodiscard]] const std::vector<Color>& GetColors() const { return m_colors; }

    ColorTable() { m_slots.fill(-1); }

private:
    std::array<int16_t, 1024> m_slots{};
    std::vector<Color> m_colors;
};

/// One index per pixel, a filter byte before each row; empty when there are too many colours.
Bytes MakePaletteRows(const Image& image, ColorTable& table) {
    Bytes rows(image.pixels.size() + static_cast<size_t>(image.height));
    unsigned char* out = rows.data();
    Color last = image.pixels[0];  // runs of one colour are the rule
    int index = table.Find(last);
    const Color* pixel = image.pixels.data();
    for (int y = 0; y < image.height; ++y) {
        *out++ = filterNone;
        for (int x = 0; x < image.width; ++x, ++pixel) {
            if (!(*pixel == last)) {
                last = *pixel;
                index = table.Find(last);
                if (index < 0) return {};
            }
            *out++ = static_cast<unsigned char>(index);
        }
    }
    return rows;
}

bool IsOpaque(const Image& image) {
    for (const Color& color : image.pixels) {
        if (color.a != 255) return false;
    }
    return true;
}

std::string_view AsText(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

Bytes ReadBytes(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw FileError("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

std::vector<unsigned char> EncodePng(const Image& image, std::span<const PngText> text) {
    if (image.width <= 0 || image.height <= 0) throw std::invalid_argument("an empty picture cannot be written");
    Bytes file(signature.begin(), signature.end());
    const bool opaque = IsOpaque(image);
    ColorTable table;
    Bytes rows = opaque ? MakePaletteRows(image, table) : Bytes{};
    const bool usesPalette = !rows.empty();
    const ColorType type = usesPalette ? ColorType::palette : opaque ? ColorType::rgb : ColorType::rgba;
    AppendHeader(file, image.width, image.height, type);
    for (const PngText& entry : text) AppendText(file, entry);
    if (usesPalette) {
        Bytes palette;
        for (const Color& color : table.GetColors()) palette.insert(palette.end(), {color.r, color.g, color.b});
        AppendChunk(file, "PLTE", palette);
    } else {
        rows = MakeColorRows(image, {0, 0, image.width, image.height}, opaque ? 3 : 4);
    }
    AppendChunk(file, "IDAT", Deflate(rows));
    AppendChunk(file, "IEND", {});
    return file;
}

void WritePng(const std::filesystem::path& path, const Image& image, std::span<const PngText> text) {
    WriteTextFile(path, AsText(EncodePng(image, text)));
}

void WriteImage(OutputFolder& output, const std::filesystem::path& relative, const Image& image,
                std::span<const PngText> text) {
    output.WriteText(relative, AsText(EncodePng(image, text)));
}

Image ReadPng(const std::filesystem::path& path) {
    const Bytes bytes = ReadBytes(path);
    int width = 0, height = 0, channels = 0;
    unsigned char* data =
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &channels, 4);
    if (data == nullptr) throw FileError(path.string() + " is not a PNG picture: " + stbi_failure_reason());
    Image image(width, height, Color{0, 0, 0, 0});
    std::memcpy(image.pixels.data(), data, image.pixels.size() * sizeof(Color));
    stbi_image_free(data);
    return image;
}

std::vector<PngText> ReadPngText(const std::filesystem::path& path) {
    const Bytes bytes = ReadBytes(path);
    if (bytes.size() < signature.size() || std::memcmp(bytes.data(), signature.data(), signature.size()) != 0) {
        throw FileError(path.string() + " is not a PNG picture");
    }
    std::vector<PngText> entries;
    // A chunk is length, type, data, checksum: 12 bytes around the data.
    for (size_t at = signature.size(); bytes.size() - at >= 12;) {
        const size_t length = ReadNumber(bytes.data() + at);
        if (length > bytes.size() - at - 12) throw FileError(path.string() + " is cut short");
        if (std::memcmp(bytes.data() + at + 4, "tEXt", 4) == 0) {
            const std::string data(bytes.begin() + static_cast<std::ptrdiff_t>(at + 8),
                                   bytes.begin() + static_cast<std::ptrdiff_t>(at + 8 + length));
            const size_t zero = data.find('\0');
            if (zero != std::string::npos) entries.push_back({data.substr(0, zero), data.substr(zero + 1)});
        }
        at += length + 12;
    }
    return entries;
}

}  // namespace testbed
