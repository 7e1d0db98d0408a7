// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Animated PNG: pictures of one size in, one file out, written frame by frame (APNG specification 1.0; part of the PNG
// specification since its third edition). A frame stores only the rectangle that differs from the frame before it.
// Programs that know no APNG show the first frame.

#pragma once

#include <filesystem>
#include <fstream>
#include <span>

#include "testbed/picture/image.h"
#include "testbed/picture/png.h"

namespace testbed {

class ApngWriter {
public:
    /// `file` is written in place: give a temporary name. Throws FileError.
    ApngWriter(std::filesystem::path file, int framesPerSecond, std::span<const PngText> text = {});
    /// Removes the file unless Finish was reached.
    ~ApngWriter();
    ApngWriter(const ApngWriter&) = delete;
    ApngWriter& operator=(const ApngWriter&) = delete;

    /// Opaque pictures, all of the first one's size; std::invalid_argument for another size. Throws FileError.
    void Add(const Image& image);
    /// Ends the file; at least one frame was added. Throws FileError.
    void Finish();

private:
    [[noreturn]] void Fail() const;  ///< with the reason of the last call
    void WriteBytes(const std::vector<unsigned char>& bytes);

    std::filesystem::path m_file;
    std::ofstream m_stream;
    std::vector<PngText> m_text;
    int m_framesPerSecond;
    std::streampos m_controlPlace;  ///< of the chunk with the number of frames, which is known at the end
    uint32_t m_frameCount = 0;
    uint32_t m_sequence = 0;  ///< of fcTL and fdAT chunks together
    Image m_last;
    bool m_isDone = false;
};

}  // namespace testbed
