// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// zlib deflates, at its fastest level: stb's own compressor takes several times as long and its files are larger.

#include "testbed/picture/png_chunks.h"
#include "testbed/base/errors.h"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

namespace testbed::png {

namespace {

constexpr unsigned char filterUp = 2;
constexpr size_t partSize = size_t{1} << 20;  // bytes; what a part cannot refer to before it costs less than 1 %

/// A piece of a deflate stream that refers to nothing before it.
struct Part {
    Bytes bytes;
    size_t size = 0;  ///< before compression
    uLong checksum = 0;
    bool isGood = false;
};

/// All parts but the last end on a whole byte (Z_FULL_FLUSH), so that parts follow each other as they are.
Part DeflatePart(std::span<const unsigned char> data, bool isLast) {
    Part part;
    part.size = data.size();
    z_stream stream{};
    constexpr int rawWindowBits = -15, memoryLevel = 9;  // no header; the largest tables
    if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, rawWindowBits, memoryLevel, Z_DEFAULT_STRATEGY) != Z_OK) {
        return part;
    }
    part.bytes.resize(deflateBound(&stream, static_cast<uLong>(data.size())) + 16);  // a flush adds up to 6 bytes
    stream.next_in = const_cast<unsigned char*>(data.data());                        // zlib only reads it
    stream.avail_in = static_cast<uInt>(data.size());
    stream.next_out = part.bytes.data();
    stream.avail_out = static_cast<uInt>(part.bytes.size());
    const int result = deflate(&stream, isLast ? Z_FINISH : Z_FULL_FLUSH);
    part.isGood = stream.avail_in == 0 && result == (isLast ? Z_STREAM_END : Z_OK);
    part.bytes.resize(stream.total_out);
    deflateEnd(&stream);
    part.checksum = adler32(adler32(0, nullptr, 0), data.data(), static_cast<uInt>(data.size()));
    return part;
}

}  // namespace

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

void AppendHeader(Bytes& file, int width, int height, ColorType type) {
    Bytes header;
    AppendNumber(header, static_cast<uint32_t>(width));
    AppendNumber(header, static_cast<uint32_t>(height));
    header.insert(header.end(), {8, static_cast<unsigned char>(type), 0, 0, 0});
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

Bytes MakeColorRows(const Image& image, const PixelBox& box, size_t channels) {
    const auto width = static_cast<size_t>(box.x1 - box.x0), height = static_cast<size_t>(box.y1 - box.y0);
    Bytes rows((width * channels + 1) * height);
    unsigned char* out = rows.data();
    const std::vector<Color> black(width, Color{0, 0, 0, 0});
    const Color* above = black.data();
    for (int y = box.y0; y < box.y1; ++y) {
        const Color* row = &image.At(box.x0, y);
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
    // The number of parts depends on the size alone, so that a picture's bytes do not depend on the machine.
    const size_t parts = std::max<size_t>(1, rows.size() / partSize);
    std::vector<Part> done(parts);
    std::atomic<size_t> next{0};
    const auto work = [&] {
        for (size_t i = next++; i < parts; i = next++) {
            const size_t begin = rows.size() * i / parts, end = rows.size() * (i + 1) / parts;
            done[i] = DeflatePart(std::span(rows).subspan(begin, end - begin), i + 1 == parts);
        }
    };
    std::thread helper;
    if (parts > 1) helper = std::thread(work);
    work();
    if (helper.joinable()) helper.join();

    Bytes stream{0x78, 0x01};  // deflate with a window of 32 KB, fastest level
    uLong checksum = adler32(0, nullptr, 0);
    for (const Part& part : done) {
        if (!part.isGood) throw FileError("out of memory while compressing a picture");
        stream.insert(stream.end(), part.bytes.begin(), part.bytes.end());
        checksum = adler32_combine(checksum, part.checksum, static_cast<z_off_t>(part.size));
    }
    AppendNumber(stream, static_cast<uint32_t>(checksum));
    return stream;
}

}  // namespace testbed::png
