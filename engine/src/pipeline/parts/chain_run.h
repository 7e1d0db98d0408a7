// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Passes of a kernel over all blocks in chains (constraints/block_chains.h): each thread follows a chain, and does
// steps of others where these have not come yet.

#pragma once

#include <atomic>
#include <cstdint>
#include <span>

#include "base/clock.h"
#include "base/index.h"
#include "base/task_pool.h"
#include "constraints/block_chains.h"
#include "constraints/contact_block.h"
#include "scree/math.h"

namespace scree {

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
        const bool isTold = m_pool.TellsOfParts();
        if (isTold) Tell(chain, done, false);
        m_pass(part, worker);
        if (isTold) Tell(chain, done, true);
        place.store(at + 2, std::memory_order_release);
        return true;
    }
    bool HelpOut(int chain, int worker) {
        for (int other = 0; other < m_chains.Count(); ++other) {
            if (other != chain && TryStep(other, worker)) return true;
        }
        return false;
    }

    /// Tells who measures of a step.
    void Tell(int chain, int done, bool isDone) const {
        const int count = StepsOf(chain);
        const BlockChains::Step& step = m_chains.GetSteps(chain)[ToSize(done % count)];
        int after[BlockChains::most] = {};
        for (int other = 0; step.needs >= 0 && other < m_chains.Count(); ++other) {
            const int32_t needed = m_chains.GetNeeds(step.needs)[ToSize(other)];
            if (needed != BlockChains::nothing) after[other] = Max(0, done / count * StepsOf(other) + needed);
        }
        after[chain] = done;
        m_pool.TellOfPart({.chain = chain, .chainCount = m_chains.Count(), .after = after}, isDone);
    }

    TaskPool& m_pool;
    const KernelTask& m_task;
    const BlockChains& m_chains;
    const int m_passes;
    Pass& m_pass;
    Place m_places[BlockChains::most];
};

}  // namespace scree
