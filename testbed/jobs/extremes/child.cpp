// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of child.h, for Linux: output goes to files in memory, ends are waited for by process descriptors.

#include "testbed/jobs/extremes/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/page/gnuplot.h"

extern char** environ;

namespace testbed {

namespace {

using Clock = std::chrono::steady_clock;

/// A descriptor that is closed with the object.
struct Descriptor {
    int number = -1;

    Descriptor() = default;
    explicit Descriptor(int n) : number(n) {}
    Descriptor(Descriptor&& other) noexcept : number(std::exchange(other.number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number, other.number);
        return *this;
    }
    ~Descriptor() {
        if (number >= 0) close(number);
    }
};

std::string ReadBack(int descriptor) {
    std::string text;
    lseek(descriptor, 0, SEEK_SET);
    char buffer[65536];
    for (ssize_t got = 0; (got = read(descriptor, buffer, sizeof buffer)) > 0;) {
        text.append(buffer, static_cast<std::size_t>(got));
    }
    return text;
}

std::string LastLine(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

struct Child {
    std::size_t job = 0;
    pid_t pid = 0;
    Descriptor process, output, words;
    Clock::time_point deadline;
    bool killed = false;
};

Child Start(std::size_t job, const ChildJob& what) {
    Child child;
    child.job = job;
    child.output = Descriptor(memfd_create("output", MFD_CLOEXEC));
    child.words = Descriptor(memfd_create("words", MFD_CLOEXEC));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, child.output.number, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, child.words.number, STDERR_FILENO);
    std::string program = "/proc/self/exe";
    std::vector<std::string> words = what.arguments;
    std::vector<char*> arguments{program.data()};
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int error = posix_spawn(&child.pid, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw ToolError(fmt::format("cannot start this program again: {}", std::strerror(error)));
    child.process = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, child.pid, 0)));
    child.deadline = Clock::now() + std::chrono::milliseconds(static_cast<long>(1000.0 * what.wallSeconds));
    return child;
}

ChildEnd Collect(const Child& child, int status) {
    ChildEnd end;
    end.ending.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.ending.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    end.ending.timedOut = child.killed || end.ending.signal == SIGXCPU;
    end.output = ReadBack(child.output.number);
    end.words = LastLine(ReadBack(child.words.number));
    end.ending.output = !end.output.empty();
    return end;
}

/// Until one of the children ends or has to be killed.
void WaitForAny(std::vector<Child>& running) {
    std::vector<pollfd> waits;
    Clock::time_point next = Clock::time_point::max();
    for (const Child& child : running) {
        waits.push_back({child.process.number, POLLIN, 0});
        if (!child.killed) next = std::min(next, child.deadline);
    }
    int timeout = -1;
    if (next != Clock::time_point::max()) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next - Clock::now()).count();
        timeout = static_cast<int>(std::clamp<long>(left + 1, 0, 1'000'000));
    }
    poll(waits.data(), waits.size(), timeout);
    for (Child& child : running) {
        if (child.killed || Clock::now() < child.deadline) continue;
        kill(child.pid, SIGKILL);
        child.killed = true;
    }
}

/// Ends what is still running when an exception passes.
struct Running {
    std::vector<Child> children;
    ~Running() {
        for (const Child& child : children) {
            kill(child.pid, SIGKILL);
            waitpid(child.pid, nullptr, 0);
        }
    }
};

}  // namespace

void RunChildren(std::span<const ChildJob> jobs, int parallel,
                 const std::function<void(std::size_t job, const ChildEnd& end)>& done) {
    Running running;
    std::size_t next = 0;
    while (next < jobs.size() || !running.children.empty()) {
        while (next < jobs.size() && running.children.size() < static_cast<std::size_t>(parallel)) {
            running.children.push_back(Start(next, jobs[next]));
            ++next;
        }
        WaitForAny(running.children);
        for (std::size_t i = 0; i < running.children.size();) {
            int status = 0;
            if (waitpid(running.children[i].pid, &status, WNOHANG) == 0) {
                ++i;
                continue;
            }
            const Child child = std::move(running.children[i]);
            running.children.erase(running.children.begin() + static_cast<std::ptrdiff_t>(i));
            done(child.job, Collect(child, status));
        }
    }
}

void LimitThisProcess(double cpuSeconds) {
    const auto seconds = static_cast<rlim_t>(std::ceil(cpuSeconds));
    const rlimit cpu{seconds, seconds + 2};
    setrlimit(RLIMIT_CPU, &cpu);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they reserve terabytes of addresses
    const rlimit memory{rlim_t{3} << 30, rlim_t{3} << 30};
    setrlimit(RLIMIT_AS, &memory);
#endif
}

}  // namespace testbed
