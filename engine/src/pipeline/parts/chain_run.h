// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Passes over all blocks in chains (constraints/block_chains.h): each thread follows a chain, and does steps of others
// where these have not come yet.

#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "base/clock.h"
#include "base/index.h"
#include "base/task_pool.h"
#include "constraints/block_chains.h"
#include "constraints/contact_block.h"

namespace scree {

/// Passes in chains. A step is done by whoever claims it: mostly the thread of its chain, but a thread that waits for
/// one that has not come yet does its steps, too.
///
/// Work::hasBodies tells whether passes end with the bodies of each slice. RunBlocks(part, pass, worker) does the
/// blocks of a step, RunBodies(chain, pass) those bodies.
template <typename Work>
class ChainRun {
public:
    ChainRun(TaskPool& pool, const KernelTask& task, int passes, Work& work)
        : m_pool(pool), m_task(task), m_chains(*task.chains), m_passes(passes), m_work(work) {}

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
    [[nodiscard]] int StepsOf(int chain) const { return m_chains.CountSteps(chain, Work::hasBodies); }
    [[nodiscard]] int StepsDone(int chain) const { return m_places[chain].at.load(std::memory_order_acquire) / 2; }
    [[nodiscard]] bool IsDone(int chain) const { return StepsDone(chain) == m_passes * StepsOf(chain); }

    [[nodiscard]] bool AreAllDone() const {
        for (int chain = 0; chain < m_chains.Count(); ++chain) {
            if (!IsDone(chain)) return false;
        }
        return true;
    }
    [[nodiscard]] int NeededOf(int other, int chain, int done) const {
        return m_chains.CountNeeded(chain, done, other, Work::hasBodies);
    }
    [[nodiscard]] bool MayBegin(int chain, int done) const {
        for (int other = 0; other < m_chains.Count(); ++other) {
            const int needed = NeededOf(other, chain, done);
            if (needed > 0 && StepsDone(other) < needed) return false;
        }
        return true;
    }
    bool TryStep(int chain, int worker) {
        std::atomic<int32_t>& place = m_places[chain].at;
        int32_t at = place.load(std::memory_order_acquire);
        const int count = StepsOf(chain), done = at / 2;
        if (at % 2 != 0 || done == m_passes * count) return false;
        if (!MayBegin(chain, done)) return false;
        if (!place.compare_exchange_strong(at, at + 1, std::memory_order_acquire)) return false;
        const bool isTold = m_pool.TellsOfParts();
        if (isTold) Tell(chain, done, false);
        RunStep(chain, done / count, ToSize(done % count), worker);
        if (isTold) Tell(chain, done, true);
        place.store(at + 2, std::memory_order_release);
        return true;
    }
    void RunStep(int chain, int pass, size_t index, int worker) {
        const std::span<const BlockChains::Step> steps = m_chains.GetSteps(chain);
        if (index == steps.size()) return m_work.RunBodies(chain, pass);
        const BlockChains::Step& step = steps[index];
        KernelTask part = m_task;
        part.ranges = &m_chains.GetRange(step.firstRange);
        part.rangeCount = step.endRange - step.firstRange;
        m_work.RunBlocks(part, pass, worker);
    }
    bool HelpOut(int chain, int worker) {
        for (int other = 0; other < m_chains.Count(); ++other) {
            if (other != chain && TryStep(other, worker)) return true;
        }
        return false;
    }

    /// Tells who measures of a step.
    void Tell(int chain, int done, bool isDone) const {
        int after[BlockChains::most] = {};
        for (int other = 0; other < m_chains.Count(); ++other) after[other] = NeededOf(other, chain, done);
        after[chain] = done;
        m_pool.TellOfPart({.chain = chain, .chainCount = m_chains.Count(), .after = after}, isDone);
    }

    TaskPool& m_pool;
    const KernelTask& m_task;
    const BlockChains& m_chains;
    const int m_passes;
    Work& m_work;
    Place m_places[BlockChains::most];
};

/// All passes, on the workers of the pool; the task has chains.
template <typename Work>
void RunChains(TaskPool& pool, const KernelTask& task, int passes, Work&& work) {
    ChainRun run(pool, task, passes, work);
    pool.For(task.chains->Count(), 2, [&](int begin, int end, int worker) {
        for (int chain = begin; chain < end; ++chain) run.Follow(chain, worker);
    });
}

}  // namespace scree
