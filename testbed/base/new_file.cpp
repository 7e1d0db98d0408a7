// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of new_file.h.

#include "testbed/base/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/process.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

// `snapshot accept` has two unfinished files a picture, of several hundred pictures. What is not used takes no memory.
constexpr int longestName = 4096, mostEntries = 2048;

/// An unfinished file, readable from a signal handler.
struct Entry {
    std::atomic<bool> isTaken{false};
    std::atomic<pid_t> owner{0};  ///< 0: the name is not whole. A forked copy leaves its parent's files alone
    std::array<char, longestName> name{};
};
std::array<Entry, mostEntries> entries;

/// Of what "-" names; −1: standard output itself.
int standardOutput = -1;

/// Set by a signal: whoever begins a file now waits for the end.
std::atomic<bool> isEnding{false};

int AddEntry(const fs::path& file) {
    while (isEnding) pause();
    const std::string name = fs::absolute(file).string();
    if (name.size() + 1 > longestName) return -1;
    for (int i = 0; i < mostEntries; ++i) {
        Entry& entry = entries[static_cast<std::size_t>(i)];
        if (entry.isTaken.exchange(true)) continue;
        std::memcpy(entry.name.data(), name.c_str(), name.size() + 1);
        entry.owner = getpid();
        return i;
    }
    return -1;  // a signal leaves this one behind
}

void RemoveEntry(int i) {
    if (i < 0) return;
    Entry& entry = entries[static_cast<std::size_t>(i)];
    entry.owner = 0;
    entry.isTaken = false;
}

/// Calls only what a signal handler may.
void HandleSignal(int number) {
    // Another thread may have named a file that it has not opened yet: it gets the time to do so.
    constexpr int passes = 4;
    constexpr timespec pause{0, 5'000'000};
    isEnding = true;
    const pid_t self = getpid();
    for (int pass = 0; pass < passes; ++pass) {
        if (pass > 0) nanosleep(&pause, nullptr);
        for (const Entry& entry : entries) {
            if (entry.owner == self) unlink(entry.name.data());
        }
    }
    signal(number, SIG_DFL);
    raise(number);
}

[[noreturn]] void Fail(const fs::path& path, int code) {
    throw FileError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(code)));
}

/// The file behind a link, even where it does not exist yet.
fs::path FollowLinks(fs::path path) {
    constexpr int most = 40;
    std::error_code error;
    for (int i = 0; i < most && fs::is_symlink(path, error); ++i) {
        const fs::path next = fs::read_symlink(path, error);
        if (error) break;
        path = path.parent_path() / next;
    }
    return path;
}

bool IsStandardOutput(const fs::path& path) { return path == "-"; }

void WriteTo(const fs::path& path, int flags, const fs::path& named, std::string_view content) {
    const int file = open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0) Fail(named, errno);
    int code = WriteAll(file, std::as_bytes(std::span(content))) ? 0 : errno;
    // Some file systems tell only now that there was no room.
    if (close(file) != 0 && code == 0) code = errno;
    if (code != 0) Fail(named, code);
}

std::string ReadPlace(const fs::path& place, const fs::path& named) {
    const Descriptor file(open(place.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.IsOpen()) Fail(named, errno);
    return ReadAll(file.Get());
}

}  // namespace

NewFile::NewFile(fs::path path) : m_path(std::move(path)), m_target(FollowLinks(m_path)) {
    std::error_code ignored;
    const fs::file_status status = fs::status(m_target, ignored);
    m_isInPlace = IsStandardOutput(m_path) || (fs::exists(status) && !fs::is_regular_file(status));
    const fs::path folder = m_isInPlace ? fs::temp_directory_path() : m_target.parent_path();
    // The process number keeps two runs into one folder from writing one temporary file.
    m_place = folder / fmt::format(".{}.{}.tmp", m_target.filename().string(), getpid());
    m_entry = AddEntry(m_place);
}

NewFile::NewFile(NewFile&& other) noexcept
    : m_path(std::move(other.m_path)),
      m_target(std::move(other.m_target)),
      m_place(std::move(other.m_place)),
      m_isInPlace(other.m_isInPlace),
      m_entry(std::exchange(other.m_entry, -1)),
      m_isOpen(std::exchange(other.m_isOpen, false)) {}

NewFile::~NewFile() {
    if (!m_isOpen) return;
    std::error_code ignored;
    fs::remove(m_place, ignored);
    RemoveEntry(m_entry);
}

void NewFile::Write(std::string_view content) { WriteTo(m_place, O_CREAT | O_TRUNC, m_path, content); }

void NewFile::Finish() {
    std::error_code error;
    if (IsStandardOutput(m_path)) {
        const std::string content = ReadPlace(m_place, m_path);
        std::fflush(stdout);
        const int descriptor = standardOutput >= 0 ? standardOutput : STDOUT_FILENO;
        if (!WriteAll(descriptor, std::as_bytes(std::span(content)))) Fail("standard output", errno);
    } else if (m_isInPlace) {
        WriteTo(m_target, 0, m_path, ReadPlace(m_place, m_path));
    } else {
        fs::rename(m_place, m_target, error);
        if (error) Fail(m_path, error.value());
        m_isOpen = false;
        RemoveEntry(m_entry);
    }
}

void CheckCanWrite(const fs::path& path) {
    if (path.empty()) return;
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) Fail(path, EISDIR);
    NewFile(path).Write("");
}

void WriteTextFile(const fs::path& path, std::string_view text) {
    NewFile file(path);
    file.Write(text);
    file.Finish();
}

void GiveStandardOutputToFiles() {
    if (standardOutput >= 0) return;
    std::fflush(stdout);
    standardOutput = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    dup2(STDERR_FILENO, STDOUT_FILENO);
}

void RemoveUnfinishedFilesOnSignals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        // A program that runs it in the background may have asked for a signal to be ignored.
        if (sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
        signal(number, HandleSignal);
    }
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
}

void HoldStandardFiles() {
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(number, F_GETFD) < 0) (void)open("/dev/null", O_RDONLY);  // the lowest free number is this one
    }
}

void CheckStandardOutput() {
    errno = 0;
    const bool failed = std::fflush(stdout) != 0;
    const int code = errno;
    if (!failed && std::ferror(stdout) == 0) return;
    const std::string reason = code != 0 ? std::generic_category().message(code) : "an earlier part was not taken";
    throw FileError("cannot write to standard output: " + reason);
}

}  // namespace testbed
