// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chunks of an animation: acTL once, then an fcTL per frame, the first one's pixels in IDAT and all others' in fdAT.

#include "testbed/picture/apng.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/picture/png_chunks.h"

namespace testbed {

namespace {

using namespace png;

constexpr unsigned char disposeNone = 0, blendSource = 0;

/// Frames and repetitions; 0 repetitions: for ever.
void AppendControl(Bytes& file, uint32_t frames) {
    Bytes data;
    AppendNumber(data, frames);
    AppendNumber(data, 0);
    AppendChunk(file, "acTL", data);
}

void AppendFrameControl(Bytes& file, uint32_t sequence, const PixelBox& box, int framesPerSecond) {
    Bytes data;
    AppendNumber(data, sequence);
    for (const int32_t value : {box.x1 - box.x0, box.y1 - box.y0, box.x0, box.y0}) {
        AppendNumber(data, static_cast<uint32_t>(value));
    }
    // The delay as a fraction of a second, two bytes each.
    data.insert(data.end(), {0, 1, 0, static_cast<unsigned char>(framesPerSecond), disposeNone, blendSource});
    AppendChunk(file, "fcTL", data);
}

/// The smallest box outside which both pictures are equal; one pixel when they are equal everywhere.
PixelBox FindChange(const Image& before, const Image& after) {
    PixelBox box{after.width, after.height, 0, 0};
    for (int y = 0; y < after.height; ++y) {
        const Color* a = &before.At(0, y);
        const Color* b = &after.At(0, y);
        const auto [first, ignored] = std::mismatch(b, b + after.width, a);
        if (first == b + after.width) continue;
        int last = after.width - 1;
        while (a[last] == b[last]) --last;
        box.x0 = std::min(box.x0, static_cast<int32_t>(first - b));
        box.x1 = std::max(box.x1, last + 1);
        box.y0 = std::min(box.y0, y);
        box.y1 = y + 1;
    }
    return box.y1 == 0 ? PixelBox{0, 0, 1, 1} : box;
}

}  // namespace

ApngWriter::ApngWriter(std::filesystem::path file, int framesPerSecond, std::span<const PngText> text)
    : m_file(std::move(file)), m_text(text.begin(), text.end()), m_framesPerSecond(framesPerSecond) {
    if (framesPerSecond < 1 || framesPerSecond > 255) throw std::invalid_argument("1 to 255 frames per second");
    m_stream.open(m_file, std::ios::binary | std::ios::trunc);
    if (!m_stream) Fail();
}

ApngWriter::~ApngWriter() {
    if (m_isDone) return;
    m_stream.close();
    std::error_code ignored;
    std::filesystem::remove(m_file, ignored);
}

void ApngWriter::Fail() const {
    const int code = errno;
    throw FileError("cannot write " + m_file.string() + ": " + std::generic_category().message(code != 0 ? code : EIO));
}

void ApngWriter::WriteBytes(const Bytes& bytes) {
    m_stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!m_stream) Fail();
}

void ApngWriter::Add(const Image& image) {
    const bool isFirst = m_frameCount == 0;
    if (image.pixels.empty()) throw std::invalid_argument("an empty picture cannot be a frame");
    if (!isFirst && (image.width != m_last.width || image.height != m_last.height)) {
        throw std::invalid_argument("the frames of an animation are of one size");
    }
    Bytes bytes;
    PixelBox box{0, 0, image.width, image.height};
    if (isFirst) {
        bytes.assign(signature.begin(), signature.end());
        AppendHeader(bytes, image.width, image.height, ColorType::rgb);
        m_controlPlace = static_cast<std::streamoff>(bytes.size());
        AppendControl(bytes, 0);
        for (const PngText& entry : m_text) AppendText(bytes, entry);
    } else {
        box = FindChange(m_last, image);
    }
    AppendFrameControl(bytes, m_sequence++, box, m_framesPerSecond);
    const Bytes pixels = Deflate(MakeColorRows(image, box, 3));
    if (isFirst) {
        AppendChunk(bytes, "IDAT", pixels);
    } else {
        Bytes data;
        data.reserve(pixels.size() + 4);
        AppendNumber(data, m_sequence++);
        data.insert(data.end(), pixels.begin(), pixels.end());
        AppendChunk(bytes, "fdAT", data);
    }
    WriteBytes(bytes);
    m_last = image;
    ++m_frameCount;
}

void ApngWriter::Finish() {
    if (m_frameCount == 0) throw std::logic_error("an animation without frames");
    Bytes end, control;
    AppendChunk(end, "IEND", {});
    WriteBytes(end);
    AppendControl(control, m_frameCount);
    m_stream.seekp(m_controlPlace);
    WriteBytes(control);
    m_stream.close();
    if (!m_stream) Fail();
    m_isDone = true;
}

}  // namespace testbed
