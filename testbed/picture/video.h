// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// mp4 through ffmpeg, a program of its own. Pictures of one size go to it through a socket, never through files.

#pragma once

#include <filesystem>

#include "testbed/base/process.h"
#include "testbed/picture/image.h"

namespace testbed {

/// Throws ToolError unless ffmpeg is on PATH: call it before a long run.
void CheckFfmpeg();

class VideoWriter {
public:
    /// `file` is written in place: give a temporary name. ffmpeg starts with the first frame.
    VideoWriter(std::filesystem::path file, int framesPerSecond);
    /// Ends ffmpeg; without Finish also removes the file.
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// All frames are of the first one's size, else std::invalid_argument. Throws ToolError with ffmpeg's own words.
    void Add(const Image& image);
    /// Throws ToolError when ffmpeg could not make the video.
    void Finish();

private:
    void Start(const Image& first);
    [[noreturn]] void Fail();

    std::filesystem::path m_file;
    int m_framesPerSecond;
    int m_width = 0, m_height = 0;
    MemoryFile m_words;  ///< what ffmpeg says
    Descriptor m_pipe;   ///< its input
    Process m_ffmpeg;
    bool m_isDone = false;
};

}  // namespace testbed
