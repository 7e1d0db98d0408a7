// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Work and span of a step of our engine, counted on one thread. The engine cuts its loops into tasks; here every task
// runs at once and is timed. Then the tasks of each loop are dealt in order, each to the core that is free first: so
// the engine's threads take them. This is list scheduling (Graham, "Bounds on Multiprocessing Timing Anomalies", 1969).
// What is in no loop no number of cores makes shorter.

#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "scree/tasks.h"

namespace testbed {

/// The times of the tasks of a step's loops, ms. A loop is over when the engine has waited for all of its tasks.
struct LoopTimes {
    std::vector<double> tasks{};  ///< of all loops, in order
    std::vector<int> ends{};      ///< by loop: end of its tasks

    [[nodiscard]] int CountLoops() const { return static_cast<int>(ends.size()); }
    /// Of all tasks.
    [[nodiscard]] double GetWork() const;
    /// Of all loops one after the other, each dealt to so many cores.
    [[nodiscard]] double GetSpan(int cores) const;
    /// Keeps the least time of each task. Both must be of the same step, which has the same loops whenever it is taken;
    /// throws std::logic_error if it has others.
    void TakeLeast(const LoopTimes& other);
};

/// How long a loop of these tasks takes on so many cores.
[[nodiscard]] double DealToCores(std::span<const double> tasks, int cores);

class LoopMeter {
public:
    LoopMeter() = default;
    LoopMeter(const LoopMeter&) = delete;
    LoopMeter& operator=(const LoopMeter&) = delete;

    /// For World::SetWorkers with at least two workers; the meter must outlive the world.
    [[nodiscard]] scree::TaskCallbacks GetCallbacks();
    /// Forgets what was counted, before a step.
    void Begin() { m_times = {}; }
    [[nodiscard]] const LoopTimes& GetTimes() const { return m_times; }

private:
    using Clock = std::chrono::steady_clock;

    void Run(void (*task)(void*), void* taskContext);
    void EndTask();
    [[nodiscard]] bool IsBetweenLoops() const;
    /// The caller's own task ran between the last one that it handed over and the first that it waits for.
    void EndLoop();

    LoopTimes m_times;
    Clock::time_point m_last;  ///< when the last task ended
};

}  // namespace testbed
