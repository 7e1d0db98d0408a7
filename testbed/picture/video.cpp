// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// ffmpeg as a child process. Its input is a socket and not a pipe, because a write to a socket whose reader has gone
// can return an error, where a pipe would end this program by a signal.

#include "testbed/picture/video.h"
#include "testbed/base/errors.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

extern char** environ;

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

bool WriteAll(int pipe, const unsigned char* data, size_t size) {
    while (size > 0) {
        const ssize_t written = send(pipe, data, size, MSG_NOSIGNAL);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        data += written;
        size -= static_cast<size_t>(written);
    }
    return true;
}

}  // namespace

void CheckFfmpeg() {
    if (IsInstalled("ffmpeg")) return;
    throw ToolError(
        "ffmpeg makes the mp4 and is not installed; install it with: apt-get install ffmpeg, or use --animate apng");
}

VideoWriter::VideoWriter(fs::path file, int framesPerSecond)
    : m_file(std::move(file)), m_log(m_file.string() + ".log"), m_framesPerSecond(framesPerSecond) {}

VideoWriter::~VideoWriter() {
    if (m_pipe >= 0) close(m_pipe);
    if (m_child >= 0) waitpid(m_child, nullptr, 0);
    std::error_code ignored;
    fs::remove(m_log, ignored);
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
    m_pipe = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, m_log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    std::vector<std::string> words = MakeArguments(first, m_framesPerSecond, m_file);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int error = posix_spawnp(&m_child, "ffmpeg", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error == 0) return;
    m_child = -1;
    throw ToolError("ffmpeg does not start: " + std::generic_category().message(error));
}

void VideoWriter::Fail() {
    std::ostringstream words;
    words << std::ifstream(m_log).rdbuf();
    throw ToolError(
        fmt::format("ffmpeg could not make the video: {}", words.str().empty() ? "it ended early" : words.str()));
}

void VideoWriter::Add(const Image& image) {
    if (m_child < 0) Start(image);
    if (image.width != m_width || image.height != m_height) {
        throw std::invalid_argument("the frames of a video are of one size");
    }
    const auto* bytes = reinterpret_cast<const unsigned char*>(image.pixels.data());
    if (!WriteAll(m_pipe, bytes, image.pixels.size() * sizeof(Color))) Fail();
}

void VideoWriter::Finish() {
    if (m_child < 0) throw std::logic_error("a video without frames");
    close(m_pipe);
    m_pipe = -1;
    int status = 0;
    const pid_t ended = waitpid(m_child, &status, 0);
    const bool isGood = ended == m_child && status == 0;
    m_child = -1;
    if (!isGood) Fail();
    m_isDone = true;
}

}  // namespace testbed
