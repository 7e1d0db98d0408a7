// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Loops over independent items on several threads. A loop is cut into chunks by position alone. Each thread has its own
// share of them, the same part of every loop, so that what it works on stays in its caches. Then it takes what others
// have not begun. So a thread that lost its core to another process delays a loop by one chunk at most. Items are
// independent, so no result depends on who took what. Loops below a size stay on the caller.
//
// Workers sleep between steps: Begin wakes them once, End lets them sleep, and PoolRegion does both for a step, if
// sharing pays. Between the loops of a step they wait by spinning for a while and then yielding.
//
// A program's own tasks do the same: one for each worker lasts for a step, and takes chunks of its loops. Such a task
// leaves when there has been nothing to do for some time, so that what else the program waits for gets its thread.
// Where a task system runs tasks at once, or is asked for more of them, every loop is cut into tasks.

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "base/clock.h"
#include "base/compiler.h"
#include "base/sharing_gauge.h"
#include "base/wake_word.h"
#include "scree/tasks.h"

#if defined(SCREE_HAS_THREADS)
#include <thread>
#include <vector>
#endif

namespace scree {

class TaskPool {
public:
    /// `workerCount` ≥ 1, the calling thread included. With callbacks no threads are made: their tasks are the workers.
    /// Without threads (base/compiler.h) and callbacks the caller runs every loop alone.
    TaskPool(int workerCount, const TaskCallbacks& callbacks);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    [[nodiscard]] int GetWorkerCount() const { return m_workerCount; }
    /// Above every `worker` that a loop's body gets: so many rows of scratch do.
    [[nodiscard]] int GetRowCount() const { return m_rowCount; }
    /// From now on every step is shared, and every loop of two items or more, whether that pays or not: for tests.
    void ShareAlways() { m_sharesAlways = true; }
    [[nodiscard]] bool SharesAlways() const { return m_sharesAlways; }
    /// Between Begin and End, with more than one worker.
    [[nodiscard]] bool IsOpen() const { return m_inStep; }
    /// The same, and no worker has been seen without its core for some time: they may wait for each other.
    [[nodiscard]] bool KeepsPace() const { return m_inStep && (m_stalledSteps == 0 || m_sharesAlways); }
    /// From a worker: another one, for which it waits, seems to have lost its core to another process.
    void NoteStall() { m_stalledSteps.store(stallSteps, std::memory_order_relaxed); }
    /// What a worker does while it waits for another; `turns`: how often it has.
    static void GiveWay(int turns);
    /// Whether the program asks for the parts of tasks that wait for each other, and the way to tell it of one.
    [[nodiscard]] bool TellsOfParts() const { return m_callbacks.part != nullptr; }
    void TellOfPart(const TaskPart& part, bool isDone) const { m_callbacks.part(part, isDone, m_callbacks.context); }
    void Begin();
    void End();

    /// Whether there are so many workers that short loops over what one core has in its cache are worth sharing. With
    /// two, the way from cache to cache costs more than the other half of such a loop.
    [[nodiscard]] bool IsWide() const { return m_inStep && m_workerCount >= leastWide; }

    /// Calls body(begin, end, worker) for chunks of [0, count); worker < GetRowCount(), 0 is this thread, and one
    /// worker has one chunk at a time. One call with everything if count < least, outside of Begin and End, or with one
    /// worker.
    template <typename Body>
    void For(int count, int least, Body&& body) {
        if (!m_inStep || count < (m_sharesAlways ? 2 : least)) {
            body(0, count, 0);
            return;
        }
        using Code = std::remove_reference_t<Body>;
        Run(
            count,
            [](void* context, int begin, int end, int worker) { (*static_cast<Code*>(context))(begin, end, worker); },
            const_cast<std::remove_const_t<Code>*>(&body));
    }

    /// The same for such short loops: with few workers all of it is the caller's.
    template <typename Body>
    void ForIfWide(int count, int least, Body&& body) {
        if (IsWide()) return For(count, least, body);
        body(0, count, 0);
    }

private:
    friend class PoolRegion;
    static constexpr int leastWide = 4;
    static constexpr int stallSteps = 120;  ///< until workers may wait for each other again

    void Run(int count, TaskFunction function, void* context);
    void RunWithCallbacks();
    void Work(int worker);
    void WorkInStep(int worker, uint32_t& turn, bool mayLeave);
    void MakeThreads();
    void Recruit();
    void Dismiss();
    void Stop();
    uint32_t RunShare(uint32_t turn, int share, int worker);
    void RunRange(int index, int parts, int worker) {
        const auto at = [&](int i) { return static_cast<int>(static_cast<int64_t>(m_loop.count) * i / parts); };
        m_loop.function(m_loop.context, at(index), at(index + 1), worker);
    }

    const int m_workerCount;
    const int m_rowCount;
    const TaskCallbacks m_callbacks;
    SharingGauge m_gauge;
    bool m_sharesAlways = false;
    std::atomic<int> m_stalledSteps{0};
#if defined(SCREE_HAS_THREADS)
    std::vector<std::thread> m_threads;

    /// A task that is a worker while a step lasts.
    struct alignas(64) Recruited {
        TaskPool* pool = nullptr;
        int worker = 0;
        void* handle = nullptr;
        bool isRefused = false;         ///< was run at once, and is not tried again in this step
        std::atomic<bool> isIn{false};  ///< from when it was handed over until it leaves
    };
    std::unique_ptr<Recruited[]> m_recruits;  ///< by worker
    bool m_cutsLoops = true;                  ///< into tasks, in this step
    std::thread::id m_caller;                 ///< of this step
#endif

    bool m_inStep = false;  ///< and with more than one worker

    /// The loop at hand, in one cache line; written before its turn, and only read by who holds a chunk of it.
    struct alignas(64) Loop {
        std::atomic<uint32_t> turn{0};  ///< that threads may work on
        int count = 0;
        TaskFunction function = nullptr;
        void* context = nullptr;
    };
    /// The chunks of one thread: turn · 2³² + the first that nobody has; none before the first turn.
    struct alignas(64) Share {
        std::atomic<uint64_t> next{0x7FFFFFFFu};
    };
    uint32_t m_turn = 0;           ///< counts loops
    uint32_t m_doneByThreads = 0;  ///< what m_done is once the loop has ended
    Loop m_loop;
    std::unique_ptr<Share[]> m_shares;  ///< by worker
    /// Chunks that other threads than the caller's have finished, of all loops. The caller only reads it.
    alignas(64) std::atomic<uint32_t> m_done{0};
    alignas(64) WakeWord m_awake;  ///< odd: inside a step
    std::atomic<bool> m_quit{false};
};

/// A step. Keeps the workers of a pool awake while it lives, if that pays.
class PoolRegion {
public:
    /// `work`: how much there is to do; 0 if it is not worth sharing. A program's task system is always used: it knows
    /// its cores.
    PoolRegion(TaskPool& pool, int work)
        : m_pool(work > 0 && pool.GetWorkerCount() > 1 ? &pool : nullptr), m_work(work) {
        if (m_pool == nullptr) return;
        m_start = Stopwatch::ReadTicks();
        if (SharesAlways() || m_pool->m_gauge.Shares()) m_pool->Begin();
    }
    ~PoolRegion() {
        if (m_pool == nullptr) return;
        if (m_pool->IsOpen()) m_pool->End();
        if (!SharesAlways())
            m_pool->m_gauge.Note(double{Stopwatch::TicksBetween(m_start, Stopwatch::ReadTicks())}, m_work);
    }
    PoolRegion(const PoolRegion&) = delete;
    PoolRegion& operator=(const PoolRegion&) = delete;

private:
    [[nodiscard]] bool SharesAlways() const { return m_pool->m_sharesAlways || m_pool->m_callbacks.enqueue != nullptr; }

    TaskPool* m_pool;
    double m_work;
    uint64_t m_start = 0;
};

}  // namespace scree
