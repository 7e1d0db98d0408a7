// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Passes of a contact kernel over all blocks, on the workers: in chains (constraints/block_chains.h), or colour by
// colour, since the blocks of one colour push different bodies. Colours with few blocks stay on the caller.

#pragma once

#include <atomic>
#include <limits>

#include "base/clock.h"
#include "base/task_pool.h"
#include "constraints/block_chains.h"
#include "constraints/contact_block.h"
#include "scree/math.h"

namespace scree {

/// Fewer blocks than this in a colour are not worth a shared loop. A block takes some 25 ns, and the end of a loop 0.5
/// to 1 µs. With few workers what one core wrote has to reach the other besides.
inline int LeastBlocks(const TaskPool& pool) {
    constexpr int ofWide = 64, ofFew = 128, ofTests = 4;
    if (pool.SharesAlways()) return ofTests;
    return pool.IsWide() ? ofWide : ofFew;
}

/// The end of the ranges of one colour that begin at `begin`: they are independent of each other.
inline int EndOfColour(const KernelTask& task, int begin) {
    int end = begin + 1;
    while (end < task.rangeCount && task.ranges[end].colour == task.ranges[begin].colour) ++end;
    return end;
}

/// The blocks [begin, end) of a task whose ranges are those of one colour.
template <typename Pass>
void RunBlocks(const KernelTask& task, int begin, int end, int worker, Pass&& pass) {
    for (int i = 0; i < task.rangeCount; ++i) {
        const BlockRange& range = task.ranges[i];
        const BlockRange own{range.begin > begin ? range.begin : begin, range.end < end ? range.end : end, range.kind,
                             range.colour};
        if (own.begin >= own.end) continue;
        KernelTask part = task;
        part.ranges = &own;
        part.rangeCount = 1;
        pass(part, worker);
    }
}

/// One pass, colour by colour.
template <typename Pass>
void RunPass(TaskPool& pool, const KernelTask& task, Pass&& pass) {
    if (!pool.IsOpen()) return pass(task, 0);
    const auto run = [&](int begin, int end) {  // ranges
        KernelTask part = task;
        part.ranges += begin;
        part.rangeCount = end - begin;
        return part;
    };
    const int leastBlocks = LeastBlocks(pool);
    const auto isLarge = [&](int begin, int end) {
        return task.ranges[end - 1].end - task.ranges[begin].begin >= leastBlocks;
    };
    int small = 0;  // where the small colours begin that nobody has run yet
    for (int begin = 0, end = 0; begin < task.rangeCount; begin = end) {
        end = EndOfColour(task, begin);
        if (!isLarge(begin, end)) continue;
        if (small < begin) pass(run(small, begin), 0);
        small = end;
        const KernelTask colour = run(begin, end);
        const int first = colour.ranges[0].begin;
        pool.For(task.ranges[end - 1].end - first, leastBlocks,
                 [&](int from, int to, int worker) { RunBlocks(colour, first + from, first + to, worker, pass); });
    }
    if (small < task.rangeCount) pass(run(small, task.rangeCount), 0);
}

/// Passes in chains. A step is done by whoever claims it: mostly the thread of its chain, but a thread that waits for
/// one that has not come yet does its steps, too.
template <typename Pass>
class ChainRun {
public:
    ChainRun(TaskPool& pool, const KernelTask& task, int passes, Pass& pass)
        : m_pool(pool), m_task(task), m_chains(*task.chains), m_passes(passes), m_pass(pass) {}

    /// Until all steps of a chain are done; of the first one, which is the caller's, until all of all are.
    void Follow(int chain, int worker) {
        const uint64_t start = Stopwatch::ReadTicks();
        uint64_t waiting = start;  // since then
        for (int turns = 0; !(chain == 0 ? AreAllDone() : IsDone(chain)); ++turns) {
            if (TryStep(chain, worker) || (turns >= patience && HelpOut(chain, worker))) {
                turns = -1;
                continue;
            }
            TaskPool::GiveWay(turns);
            if (turns == patience) waiting = Stopwatch::ReadTicks();
            // Waits far longer than there was anything to do are not for a longer chain.
            const bool isLong = turns >= longWait && turns % patience == 0;
            if (isLong &&
                Stopwatch::TicksBetween(waiting, Stopwatch::ReadTicks()) > Stopwatch::TicksBetween(start, waiting))
                m_pool.NoteStall();
        }
    }

private:
    static constexpr int patience = 16, longWait = 1024;  ///< turns; the latter take some 50 µs

    /// 2 · steps done, + 1 while the next one is at work.
    struct alignas(64) Place {
        std::atomic<int32_t> at{0};
    };
    [[nodiscard]] int StepsOf(int chain) const { return static_cast<int>(m_chains.GetSteps(chain).size()); }
    [[nodiscard]] int StepsDone(int chain) const { return m_places[chain].at.load(std::memory_order_acquire) / 2; }
    [[nodiscard]] bool IsDone(int chain) const { return StepsDone(chain) == m_passes * StepsOf(chain); }

    [[nodiscard]] bool AreAllDone() const {
        for (int chain = 0; chain < m_chains.Count(); ++chain) {
            if (!IsDone(chain)) return false;
        }
        return true;
    }
    [[nodiscard]] bool MayBegin(const BlockChains::Step& step, int pass) const {
        if (step.needs < 0) return true;
        int chain = 0;
        for (const int32_t needed : m_chains.GetNeeds(step.needs)) {
            if (needed != BlockChains::nothing && StepsDone(chain) < pass * StepsOf(chain) + needed) return false;
            ++chain;
        }
        return true;
    }
    bool TryStep(int chain, int worker) {
        std::atomic<int32_t>& place = m_places[chain].at;
        int32_t at = place.load(std::memory_order_acquire);
        const std::span<const BlockChains::Step> steps = m_chains.GetSteps(chain);
        const int count = static_cast<int>(steps.size()), done = at / 2;
        if (at % 2 != 0 || done == m_passes * count) return false;
        const BlockChains::Step& step = steps[ToSize(done % count)];
        if (!MayBegin(step, done / count)) return false;
        if (!place.compare_exchange_strong(at, at + 1, std::memory_order_acquire)) return false;
        KernelTask part = m_task;
        part.ranges = &m_chains.GetRange(step.firstRange);
        part.rangeCount = step.endRange - step.firstRange;
        m_pass(part, worker);
        place.store(at + 2, std::memory_order_release);
        return true;
    }
    bool HelpOut(int chain, int worker) {
        for (int other = 0; other < m_chains.Count(); ++other) {
            if (other != chain && TryStep(other, worker)) return true;
        }
        return false;
    }

    TaskPool& m_pool;
    const KernelTask& m_task;
    const BlockChains& m_chains;
    const int m_passes;
    Pass& m_pass;
    Place m_places[BlockChains::most];
};

/// Calls pass(task, worker) with tasks that cover all ranges in order, as often as told.
template <typename Pass>
void RunKernel(TaskPool& pool, const KernelTask& task, Pass&& pass, int passes = 1) {
    if (task.chains != nullptr && pool.KeepsPace()) {
        ChainRun run(pool, task, passes, pass);
        pool.For(task.chains->Count(), 2, [&](int begin, int end, int worker) {
            for (int chain = begin; chain < end; ++chain) run.Follow(chain, worker);
        });
        return;
    }
    for (int i = 0; i < passes; ++i) RunPass(pool, task, pass);
}
inline void RunKernel(TaskPool& pool, const KernelTask& task, void (*kernel)(const KernelTask&), int passes = 1) {
    RunKernel(
        pool, task, [kernel](const KernelTask& part, int) { kernel(part); }, passes);
}

/// The smallest separation of a pass of pushApart.
inline float RunPushApart(TaskPool& pool, const KernelTask& task, const ContactKernels& kernels, float share) {
    float smallest[maxWorkers];
    for (float& s : smallest) s = 1.0f;
    RunKernel(pool, task, [&](const KernelTask& part, int worker) {
        smallest[worker] = Min(smallest[worker], kernels.pushApart(part, share));
    });
    float least = smallest[0];
    for (const float s : smallest) least = Min(least, s);
    return least;
}

/// A pass of part.
inline float RunPart(TaskPool& pool, const KernelTask& task, const ContactKernels& kernels, const Parting& parting) {
    float lacking[maxWorkers] = {};
    RunKernel(pool, task, [&](const KernelTask& part, int worker) {
        lacking[worker] = Max(lacking[worker], kernels.part(part, parting));
    });
    float largest = 0.0f;
    for (const float one : lacking) largest = Max(largest, one);
    return largest;
}

/// A pass of bounce: true if a contact bounces.
inline bool RunBounce(TaskPool& pool, const KernelTask& task, const ContactKernels& kernels) {
    bool bounced[maxWorkers] = {};
    RunKernel(pool, task,
              [&](const KernelTask& part, int worker) { bounced[worker] = kernels.bounce(part) || bounced[worker]; });
    bool any = false;
    for (const bool b : bounced) any = any || b;
    return any;
}

}  // namespace scree
