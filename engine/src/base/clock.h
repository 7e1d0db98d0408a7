// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wall time for the profile. Times are reported and never decide anything.

#pragma once

#include <chrono>

namespace scree {

class Stopwatch {
public:
    /// Milliseconds since the construction or the last Lap.
    float Lap() {
        const auto now = std::chrono::steady_clock::now();
        const float ms = std::chrono::duration<float, std::milli>(now - m_start).count();
        m_start = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace scree
