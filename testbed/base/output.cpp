// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The folder that a command writes to.

#include "testbed/base/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// The process number keeps two runs into one folder from writing one temporary file.
fs::path TemporaryName(const fs::path& path) {
    return path.parent_path() / fmt::format(".{}.{}.tmp", path.filename().string(), getpid());
}

void Rename(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) {
        std::error_code ignored;
        fs::remove(from, ignored);
        throw FileError(fmt::format("cannot write {}: {}", to.string(), error.message()));
    }
}

}  // namespace

void WriteTextFile(const fs::path& path, std::string_view text) {
    const fs::path temporary = TemporaryName(path);
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
        const int code = errno;
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw FileError(
            fmt::format("cannot write {}: {}", path.string(), code != 0 ? std::strerror(code) : "the stream failed"));
    }
    Rename(temporary, path);
}

std::string FormatFiles(std::span<const std::string> files) {
    // Enough for the default run of two scenes; a long series is its first and last files.
    constexpr std::size_t most = 24, ends = 8;
    std::string text = fmt::format("{} files:\n", files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files.size() > most && i == ends) {
            text += "  …\n";
            i = files.size() - ends;
        }
        fmt::format_to(std::back_inserter(text), "  {}\n", files[i]);
    }
    return text;
}

OutputFolder::OutputFolder(fs::path root) : m_root(std::move(root)) {
    const fs::path probe = Prepare(fmt::format(".probe.{}", getpid()));
    WriteTextFile(probe, "");
    std::error_code ignored;
    fs::remove(probe, ignored);
}

fs::path OutputFolder::Prepare(const fs::path& relative) const {
    const fs::path path = m_root / relative;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
        throw FileError(fmt::format("cannot create the folder {}: {}; choose another with -o DIR",
                                    path.parent_path().string(), error.message()));
    }
    return path;
}

void OutputFolder::WriteText(const fs::path& relative, std::string_view text) {
    WriteBy(relative, [text](const fs::path& path) { WriteTextFile(path, text); });
}

void OutputFolder::WriteBy(const fs::path& relative, const std::function<void(const fs::path&)>& write) {
    const fs::path path = Prepare(relative);
    write(path);
    m_files.push_back(path.string());
}

void OutputFolder::Adopt(const fs::path& temporary, const fs::path& relative) {
    const fs::path path = Prepare(relative);
    Rename(temporary, path);
    m_files.push_back(path.string());
}

}  // namespace testbed
