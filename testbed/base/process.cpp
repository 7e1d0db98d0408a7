// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of process.h, for Linux: ends by process descriptors.

#include "testbed/base/process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "testbed/base/text.h"

namespace testbed {

namespace {

std::error_code LastError() { return {errno, std::generic_category()}; }

/// waitpid that no signal cuts short.
pid_t WaitFor(pid_t id, int& status, int options) {
    for (;;) {
        const pid_t ended = waitpid(id, &status, options);
        if (ended >= 0 || errno != EINTR) return ended;
    }
}

Descriptor OpenSignal(pid_t id) { return Descriptor(static_cast<int>(syscall(SYS_pidfd_open, id, 0))); }

/// In a new process: it ends when its parent does, however that ends.
void DieWith(pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);  // which had ended before
}

/// In a new process: becomes another program. Returns the reason if that fails. Calls only what is safe beside the
/// threads that the parent had.
int Become(const std::vector<char*>& arguments, const ProcessFiles& files) {
    const int places[] = {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO};
    const int own[] = {files.input, files.output, files.errors};
    for (int i = 0; i < 3; ++i) {
        if (own[i] >= 0 && dup2(own[i], places[i]) < 0) return errno;
    }
    for (const int number : {SIGPIPE, SIGXFSZ}) signal(number, SIG_DFL);
    execvp(arguments.front(), arguments.data());
    return errno;
}

}  // namespace

void Descriptor::Close() {
    if (m_number >= 0) close(m_number);
    m_number = -1;
}

bool WriteAll(int descriptor, std::span<const std::byte> data) {
    while (!data.empty()) {
        ssize_t count = send(descriptor, data.data(), data.size(), MSG_NOSIGNAL);
        if (count < 0 && errno == ENOTSOCK) count = write(descriptor, data.data(), data.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        data = data.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

std::string ReadAll(int descriptor) {
    std::string text;
    char buffer[65536];
    for (;;) {
        const ssize_t count = read(descriptor, buffer, sizeof buffer);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(buffer, static_cast<std::size_t>(count));
    }
}

MemoryFile::MemoryFile() : m_file(memfd_create("scree", MFD_CLOEXEC)) {}

std::string MemoryFile::Read() const {
    lseek(Get(), 0, SEEK_SET);
    return ReadAll(Get());
}

int ProcessEnd::GetExitCode() const { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }
int ProcessEnd::GetSignal() const { return WIFSIGNALED(status) ? WTERMSIG(status) : 0; }

Process::~Process() {
    if (IsRunning()) Wait();
}

std::error_code Process::Start(std::vector<std::string> words, const ProcessFiles& files) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    // Closed by a program that starts; one that does not writes the reason.
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0) return LastError();
    const Descriptor reader(ends[0]);
    Descriptor writer(ends[1]);
    const pid_t parent = getpid();
    const pid_t id = fork();
    if (id < 0) return LastError();
    if (id == 0) {
        DieWith(parent);
        const int code = Become(arguments, files);
        (void)!write(writer.Get(), &code, sizeof code);
        _exit(127);
    }
    writer.Close();
    int code = 0;
    if (read(reader.Get(), &code, sizeof code) == sizeof code) {
        int ignored = 0;
        WaitFor(id, ignored, 0);
        return {code, std::generic_category()};
    }
    m_id = id;
    m_signal = OpenSignal(id);
    return {};
}

std::error_code Process::Fork(const std::function<int()>& body) {
    std::fflush(nullptr);  // what is buffered would be written twice
    const pid_t parent = getpid();
    const pid_t id = fork();
    if (id < 0) return LastError();
    if (id == 0) {
        DieWith(parent);
        _exit(body());
    }
    m_id = id;
    m_signal = OpenSignal(id);
    return {};
}

ProcessEnd Process::Wait() {
    ProcessEnd end{-1};
    if (WaitFor(m_id, end.status, 0) != m_id) end.status = -1;
    m_id = -1;
    m_signal.Close();
    return end;
}

std::optional<ProcessEnd> Process::Poll() {
    ProcessEnd end;
    if (WaitFor(m_id, end.status, WNOHANG) == 0) return std::nullopt;
    m_id = -1;
    m_signal.Close();
    return end;
}

void Process::Kill() { Stop(SIGKILL); }

void Process::Stop(int signal) {
    if (IsRunning()) kill(m_id, signal);  // −1 would be every process
}

void Process::WaitForAny(std::span<const Process* const> processes, std::optional<std::chrono::milliseconds> time) {
    std::vector<pollfd> waits;
    for (const Process* process : processes) waits.push_back({process->m_signal.Get(), POLLIN, 0});
    constexpr std::chrono::milliseconds longest{1'000'000};
    const auto least = std::chrono::milliseconds::zero();
    const int milliseconds = time ? static_cast<int>(std::clamp(*time, least, longest).count()) : -1;
    poll(waits.data(), waits.size(), milliseconds);
}

bool IsInstalled(std::string_view program) {
    const char* path = std::getenv("PATH");
    const auto folders = Split(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin", ':');
    return std::ranges::any_of(folders, [&](std::string_view folder) {
        return access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0;
    });
}

}  // namespace testbed
