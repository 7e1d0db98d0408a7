// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Work and span of a step of our engine, counted on one thread. The engine cuts its loops into tasks; here every task
// runs at once and is timed. Then the tasks of each loop are dealt in order, each to the core that is free first: so
// the engine's threads take them. This is list scheduling (Graham, "Bounds on Multiprocessing Timing Anomalies", 1969).
// Contacts of large islands are solved in chains of parts that wait for parts of other chains: each chain has its core.
// What is in no loop no number of cores makes shorter.

#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "scree/tasks.h"

namespace testbed {

/// What the end of a loop costs on several cores, ms: its caller waits for the others.
inline constexpr double barrierMs = 1e-3;
/// What it costs a core to see that another one has done what it waits for, ms.
inline constexpr double handoverMs = 1e-4;

/// A part of a chain.
struct PartTime {
    int chain = 0;
    double ms = 0.0;
    std::vector<int> after{};  ///< by chain: how many of its parts were done before this one began
};

/// The times of the tasks of a step's loops, ms. A loop is over when the engine has waited for all of its tasks.
struct LoopTimes {
    std::vector<double> tasks{};    ///< of all loops, in order
    std::vector<int> ends{};        ///< by loop: end of its tasks
    std::vector<PartTime> parts{};  ///< of all loops in chains, in an order in which none waits for a later one
    std::vector<int> partEnds{};    ///< by loop: end of its parts; it has none where its tasks are independent

    [[nodiscard]] int CountLoops() const { return static_cast<int>(ends.size()); }
    /// From the begin of each loop to its end, on the one thread.
    [[nodiscard]] double GetElapsed() const;
    /// The same without what a thread does that has all chains to follow.
    [[nodiscard]] double GetWork() const;
    /// Of all loops one after the other, each dealt to so many cores.
    [[nodiscard]] double GetSpan(int cores) const;
    /// Keeps the least time of each task and part. Both must be of the same step, which has the same loops whenever it
    /// is taken; throws std::logic_error if it has others.
    void TakeLeast(const LoopTimes& other);

private:
    [[nodiscard]] std::span<const double> TasksOf(int loop) const;
    [[nodiscard]] std::span<const PartTime> PartsOf(int loop) const;
};

/// How long a loop of these tasks takes on so many cores.
[[nodiscard]] double DealToCores(std::span<const double> tasks, int cores);

/// The same for chains: each has one of the cores, in turn, and waits where its parts must.
[[nodiscard]] double FollowChains(std::span<const PartTime> parts, int cores);

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
    void NotePart(const scree::TaskPart& part, bool isDone);
    [[nodiscard]] bool IsBetweenLoops() const;
    /// The caller's own task ran between the last one that it handed over and the first that it waits for.
    void EndLoop();

    LoopTimes m_times;
    Clock::time_point m_last;       ///< when the last task ended
    Clock::time_point m_partBegan;  ///< the last part
};

}  // namespace testbed
