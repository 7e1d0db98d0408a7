// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wall time of a call in milliseconds on the steady clock, and its processor time.

#pragma once

#include <time.h>

#include <chrono>

namespace testbed {

class Stopwatch {
public:
    /// Time since construction, ms.
    [[nodiscard]] double GetMilliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start).count();
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// Processor time of all threads of this process. Reading it is a system call: some 0.3 µs.
class CpuStopwatch {
public:
    /// Time since construction, ms.
    [[nodiscard]] double GetMilliseconds() const { return Now() - m_start; }

private:
    static double Now() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    }
    double m_start = Now();
};

}  // namespace testbed
