// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// PNG files: an Image and text entries in, a file out (own chunks around a deflate stream; PNG specification, third
// edition, sections 5, 9 and 11), and back through stb_image.

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"
#include "testbed/picture/image.h"

namespace testbed {

/// One tEXt entry: keyword of 1–79 printable Latin-1 characters, text without a zero byte.
struct PngText {
    std::string key, value;
};

/// The bytes of a PNG file. Opaque images are stored as RGB, those of at most 256 colours as a palette.
/// Throws std::invalid_argument for an empty image or a bad keyword.
[[nodiscard]] std::vector<unsigned char> EncodePng(const Image& image, std::span<const PngText> text = {});

/// Writes to a temporary name beside the file, then renames: never a half-written picture. Throws FileError.
void WritePng(const std::filesystem::path& path, const Image& image, std::span<const PngText> text = {});

/// The same in a folder of output, which notes the file.
void WriteImage(OutputFolder& output, const std::filesystem::path& relative, const Image& image,
                std::span<const PngText> text = {});

/// Any 8-bit PNG as RGBA. Throws FileError.
[[nodiscard]] Image ReadPng(const std::filesystem::path& path);

/// The tEXt entries of a file, in file order. Throws FileError.
[[nodiscard]] std::vector<PngText> ReadPngText(const std::filesystem::path& path);

}  // namespace testbed
