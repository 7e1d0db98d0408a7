// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Work and span of a step of our engine, counted on one thread. The engine cuts its loops into a task for each worker;
// here every task runs at once and is timed. What is in no loop, and the longest task of each loop, no number of cores
// makes shorter (Blumofe and Leiserson, "Scheduling Multithreaded Computations by Work Stealing", 1999).

#pragma once

#include <chrono>
#include <vector>

#include "scree/tasks.h"

namespace testbed {

/// What a step spent in loops. A loop is over when the engine has waited for all of its tasks.
struct LoopTimes {
    int loops = 0;
    double work = 0.0;  ///< of all tasks, ms
    double span = 0.0;  ///< of the longest task of each loop, summed, ms
};

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
    /// The caller's own task ran between the last one that it handed over and the first that it waits for.
    void EndLoop();

    LoopTimes m_times;
    std::vector<double> m_tasks;  ///< of the loop at hand, ms
    Clock::time_point m_last;     ///< when the last task ended
};

}  // namespace testbed
