// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// ffmpeg as a child process. Its input is a socket and not a pipe. When the reader has gone, a write to a socket can
// return an error; a write to a pipe would end this program by a signal.

#include "testbed/picture/video.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// Players want even sides and the chroma of 4:2:0; an odd picture gets a black column or row.
std::vector<std::string> MakeArguments(const Image& first, int framesPerSecond, const fs::path& file) {
    return {"ffmpeg",
            "-hide_banner",
            "-loglevel",
            "error",
            "-y",  //
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgba",  //
            "-video_size",
            fmt::format("{}x{}", first.width, first.height),  //
            "-framerate",
            fmt::format("{}", framesPerSecond),
            "-i",
            "pipe:0",  //
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-pix_fmt",
            "yuv420p",  //
            "-movflags",
            "+faststart",
            "-f",
            "mp4",
            fs::absolute(file).string()};
}

}  // namespace

void CheckFfmpeg() {
    if (IsInstalled("ffmpeg")) return;
    throw ToolError(
        "ffmpeg makes the mp4 and is not installed; install it with: apt-get install ffmpeg, or use --animate apng");
}

VideoWriter::VideoWriter(fs::path file, int framesPerSecond)
    : m_file(std::move(file)), m_framesPerSecond(framesPerSecond) {}

VideoWriter::~VideoWriter() {
    m_pipe.Close();
    if (m_ffmpeg.IsRunning()) m_ffmpeg.Wait();
    std::error_code ignored;
    if (!m_isDone) fs::remove(m_file, ignored);
}

void VideoWriter::Start(const Image& first) {
    m_width = first.width;
    m_height = first.height;
    int ends[2] = {-1, -1};
    // Closed in every child but for the copy that becomes its input: another video's ffmpeg must not hold it open.
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        throw ToolError("cannot make a pipe to ffmpeg: " + std::generic_category().message(errno));
    }
    m_pipe = Descriptor(ends[0]);
    const Descriptor input(ends[1]);
    const std::error_code error =
        m_ffmpeg.Start(MakeArguments(first, m_framesPerSecond, m_file),
                       {.input = input.Get(), .output = m_words.Get(), .errors = m_words.Get()});
    if (error) throw ToolError("ffmpeg does not start: " + error.message());
}

void VideoWriter::Fail() {
    const std::string words = m_words.Read();
    throw ToolError(fmt::format("ffmpeg could not make the video: {}", words.empty() ? "it ended early" : words));
}

void VideoWriter::Add(const Image& image) {
    if (!m_ffmpeg.IsRunning()) Start(image);
    if (image.width != m_width || image.height != m_height) {
        throw std::invalid_argument("the frames of a video are of one size");
    }
    if (!WriteAll(m_pipe.Get(), std::as_bytes(std::span(image.pixels)))) Fail();
}

void VideoWriter::Finish() {
    if (!m_ffmpeg.IsRunning()) throw std::logic_error("a video without frames");
    m_pipe.Close();
    if (!m_ffmpeg.Wait().IsGood()) Fail();
    m_isDone = true;
}

}  // namespace testbed
