// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chunks are written here; zlib deflates (its fastest level: stb's own compressor takes several times as long and its
// files are larger), stb_image reads.

#include "testbed/render/png.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

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

using Bytes = std::vector<unsigned char>;

constexpr std::array<unsigned char, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr size_t maxPaletteSize = 256;
constexpr unsigned char colorTypeRgb = 2, colorTypePalette = 3, colorTypeRgba = 6;
constexpr unsigned char filterNone = 0, filterUp = 2;

void AppendNumber(Bytes& bytes, uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<unsigned char>(value >> shift));
}

uint32_t ReadNumber(const unsigned char* bytes) {
    return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | uint32_t{bytes[3]};
}

void AppendChunk(Bytes& file, const char* type, std::span<const unsigned char> data) {
    AppendNumber(file, static_cast<uint32_t>(data.size()));
    const size_t start = file.size();
    file.insert(file.end(), type, type + 4);
    file.insert(file.end(), data.begin(), data.end());
    AppendNumber(file, static_cast<uint32_t>(crc32(0, file.data() + start, static_cast<uInt>(file.size() - start))));
}

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

/// RGB or RGBA, each row as its difference from the row above: overlap pictures consist of tall rectangles.
Bytes MakeColorRows(const Image& image, size_t channels) {
    Bytes rows;
    const auto width = static_cast<size_t>(image.width);
    rows.resize((width * channels + 1) * static_cast<size_t>(image.height));
    unsigned char* out = rows.data();
    const std::vector<Color> black(width, Color{0, 0, 0, 0});
    const Color* above = black.data();
    for (int y = 0; y < image.height; ++y) {
        const Color* row = &image.At(0, y);
        *out++ = filterUp;
        for (size_t x = 0; x < width; ++x) {
            *out++ = static_cast<unsigned char>(row[x].r - above[x].r);
            *out++ = static_cast<unsigned char>(row[x].g - above[x].g);
            *out++ = static_cast<unsigned char>(row[x].b - above[x].b);
            if (channels == 4) *out++ = static_cast<unsigned char>(row[x].a - above[x].a);
        }
        above = row;
    }
    return rows;
}

Bytes Deflate(const Bytes& rows) {
    uLongf size = compressBound(static_cast<uLong>(rows.size()));
    Bytes compressed(size);
    if (compress2(compressed.data(), &size, rows.data(), static_cast<uLong>(rows.size()), Z_BEST_SPEED) != Z_OK) {
        throw FileError("out of memory while compressing a picture");
    }
    compressed.resize(size);
    return compressed;
}

bool IsOpaque(const Image& image) {
    for (const Color& color : image.pixels) {
        if (color.a != 255) return false;
    }
    return true;
}

void AppendHeader(Bytes& file, const Image& image, unsigned char colorType) {
    Bytes header;
    AppendNumber(header, static_cast<uint32_t>(image.width));
    AppendNumber(header, static_cast<uint32_t>(image.height));
    header.insert(header.end(), {8, colorType, 0, 0, 0});
    AppendChunk(file, "IHDR", header);
}

void AppendText(Bytes& file, const PngText& text) {
    const bool keyIsGood = !text.key.empty() && text.key.size() <= 79 && text.key.find('\0') == std::string::npos;
    if (!keyIsGood || text.value.find('\0') != std::string::npos) {
        throw std::invalid_argument("bad PNG text entry '" + text.key + "'");
    }
    Bytes data(text.key.begin(), text.key.end());
    data.push_back(0);
    data.insert(data.end(), text.value.begin(), text.value.end());
    AppendChunk(file, "tEXt", data);
}

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
    AppendHeader(file, image, usesPalette ? colorTypePalette : (opaque ? colorTypeRgb : colorTypeRgba));
    for (const PngText& entry : text) AppendText(file, entry);
    if (usesPalette) {
        Bytes palette;
        for (const Color& color : table.GetColors()) palette.insert(palette.end(), {color.r, color.g, color.b});
        AppendChunk(file, "PLTE", palette);
    } else {
        rows = MakeColorRows(image, opaque ? 3 : 4);
    }
    AppendChunk(file, "IDAT", Deflate(rows));
    AppendChunk(file, "IEND", {});
    return file;
}

void WritePng(const std::filesystem::path& path, const Image& image, std::span<const PngText> text) {
    const Bytes bytes = EncodePng(image, text);
    std::filesystem::path temporary = path;
    temporary += ".tmp";
    {
        std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
        stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) {
            std::error_code ignored;
            std::filesystem::remove(temporary, ignored);
            throw FileError("cannot write " + path.string());
        }
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw FileError("cannot write " + path.string() + ": " + error.message());
    }
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
