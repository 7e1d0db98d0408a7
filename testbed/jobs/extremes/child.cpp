// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of child.h.

#include "testbed/jobs/extremes/child.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <optional>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/process.h"

namespace testbed {

namespace {

using Clock = std::chrono::steady_clock;

std::string LastLine(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

struct Child {
    std::size_t job = 0;
    MemoryFile output, words;
    Process process;
    Clock::time_point deadline;
    bool killed = false;
};

Child Start(std::size_t job, const ChildJob& what) {
    Child child;
    child.job = job;
    std::vector<std::string> words{"/proc/self/exe"};
    words.insert(words.end(), what.arguments.begin(), what.arguments.end());
    const std::error_code error =
        child.process.Start(std::move(words), {.output = child.output.Get(), .errors = child.words.Get()});
    if (error) throw ToolError(fmt::format("cannot start this program again: {}", error.message()));
    child.deadline = Clock::now() + std::chrono::milliseconds(static_cast<long>(1000.0 * what.wallSeconds));
    return child;
}

ChildEnd Collect(const Child& child, const ProcessEnd& processEnd) {
    ChildEnd end;
    end.ending.signal = processEnd.GetSignal();
    end.ending.exitCode = std::max(processEnd.GetExitCode(), 0);
    end.ending.timedOut = child.killed || end.ending.signal == SIGXCPU;
    end.output = LastLine(child.output.Read());  // engines may have written lines of their own before
    end.words = LastLine(child.words.Read());
    end.ending.output = !end.output.empty();
    return end;
}

/// Until one of the children ends or has to be killed.
void WaitForAny(std::vector<Child>& running) {
    std::vector<const Process*> waits;
    Clock::time_point next = Clock::time_point::max();
    for (const Child& child : running) {
        waits.push_back(&child.process);
        if (!child.killed) next = std::min(next, child.deadline);
    }
    std::optional<std::chrono::milliseconds> time;
    if (next != Clock::time_point::max()) time = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now());
    Process::WaitForAny(waits, time);
    for (Child& child : running) {
        if (child.killed || Clock::now() < child.deadline) continue;
        child.process.Kill();
        child.killed = true;
    }
}

/// Ends what is still running when an exception passes.
struct Running {
    std::vector<Child> children;
    ~Running() {
        for (Child& child : children) child.process.Kill();
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
            const std::optional<ProcessEnd> end = running.children[i].process.Poll();
            if (!end) {
                ++i;
                continue;
            }
            const Child child = std::move(running.children[i]);
            running.children.erase(running.children.begin() + static_cast<std::ptrdiff_t>(i));
            done(child.job, Collect(child, *end));
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
