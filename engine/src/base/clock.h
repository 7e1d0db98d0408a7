// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wall time for the profile, and for who takes part in a step (sharing_gauge.h). Times decide nothing else.
//
// A step of an empty world takes as long as ten looks at the system's clock. So laps are counted in ticks of the
// processor, and the clock, read at both ends, tells how long these were.

#pragma once

#include <chrono>
#include <cstdint>

#include "base/compiler.h"

namespace scree {

class Stopwatch {
public:
    /// Ticks since the construction or the last Lap.
    float Lap() {
        const uint64_t now = ReadTicks();
        const float lap = TicksBetween(m_lap, now);
        m_lap = now;
        return lap;
    }
    /// Turns laps into milliseconds. Returns the milliseconds since the construction.
    template <typename... Laps>
    float Stop(Laps&... laps) {
        const float total = TicksBetween(m_firstTick, ReadTicks());
        const float ms = std::chrono::duration<float, std::milli>(Clock::now() - m_start).count();
        const float perTick = total > 0.0f ? ms / total : 0.0f;
        ((laps *= perTick), ...);
        return ms;
    }

    /// Of any length, for comparisons.
    static uint64_t ReadTicks() {
#ifdef SCREE_HAS_TICKS
        return CountTicks();
#else
        return static_cast<uint64_t>(Clock::now().time_since_epoch().count());
#endif
    }
    /// Another core's count may lag behind.
    static float TicksBetween(uint64_t from, uint64_t to) { return to > from ? static_cast<float>(to - from) : 0.0f; }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point m_start = Clock::now();
    uint64_t m_firstTick = ReadTicks(), m_lap = m_firstTick;
};

}  // namespace scree
