// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The parts that PNG files are made of, for still and animated ones. They are chunks, rows with their filter bytes, and
// the deflate stream around them (PNG specification, third edition, sections 5, 9 and 10).

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "testbed/picture/image.h"
#include "testbed/picture/png.h"

namespace testbed::png {

using Bytes = std::vector<unsigned char>;

inline constexpr std::array<unsigned char, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

enum class ColorType : unsigned char { rgb = 2, palette = 3, rgba = 6 };

/// Four bytes, the most significant first.
void AppendNumber(Bytes& bytes, uint32_t value);
[[nodiscard]] uint32_t ReadNumber(const unsigned char* bytes);

/// Length, `type` of four letters, data, checksum.
void AppendChunk(Bytes& file, const char* type, std::span<const unsigned char> data);
/// IHDR of an 8-bit picture.
void AppendHeader(Bytes& file, int width, int height, ColorType type);

/// tEXt. Throws std::invalid_argument for a bad keyword or a zero byte.
void AppendText(Bytes& file, const PngText& text);

/// Rows of a part of a picture as RGB or RGBA (`channels` 3 or 4), each as its difference from the row above: overlap
/// pictures consist of tall rectangles. `box` is not empty and lies inside the image.
[[nodiscard]] Bytes MakeColorRows(const Image& image, const PixelBox& box, size_t channels);

/// The zlib stream of these rows, large ones by two threads in parts that are compressed apart. Throws FileError when
/// memory runs out.
[[nodiscard]] Bytes Deflate(const Bytes& rows);

}  // namespace testbed::png
