// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wall time of a call in milliseconds on the steady clock.

#pragma once

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

}  // namespace testbed
