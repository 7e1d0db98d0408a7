// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Threads of the pool, and the same loops through a program's own task system.

#include "base/task_pool.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/float_mode.h"
#include "base/undo.h"

namespace scree {

namespace {

/// More: better balance; fewer: less taking turns.
constexpr int chunksPerWorker = 4;
/// Some microseconds.
constexpr int spinsInWait = 2000;

#if defined(SCREE_HAS_THREADS)
/// Waits until done() holds.
template <typename Done>
void Await(Done&& done) {
    for (int turns = 0; !done(); ++turns) TaskPool::GiveWay(turns);
}
#endif

}  // namespace

TaskPool::~TaskPool() { Stop(); }

/// Spins for some microseconds, then gives the core away.
void TaskPool::GiveWay(int turns) {
#if defined(SCREE_HAS_THREADS)
    if (turns >= spinsInWait) return std::this_thread::yield();
#endif
    PauseSpinning();
}

/// Who takes chunk after chunk is a worker; of loops that are cut into tasks each task is one, whatever thread runs it.
TaskPool::TaskPool(int workerCount, const TaskCallbacks& callbacks)
    : m_workerCount(workerCount),
      m_rowCount(callbacks.enqueue == nullptr ? workerCount : workerCount * std::max(callbacks.tasksPerWorker, 1)),
      m_callbacks(callbacks),
      m_shares(workerCount > 1 ? std::make_unique<Share[]>(static_cast<size_t>(workerCount)) : nullptr) {
    MakeThreads();
}

void TaskPool::RunWithCallbacks() {
    struct Range {
        TaskPool* pool;
        int index, parts;
        void* handle;
    };
    Range ranges[maxWorkers];
    const int parts = std::min(m_rowCount, m_loop.count);
    for (int index = 1; index < parts; ++index) {
        Range& range = ranges[index];
        range = {this, index, parts, nullptr};
        range.handle = m_callbacks.enqueue(
            [](void* context) {
                const StandardFloats floats;
                const auto* own = static_cast<Range*>(context);
                own->pool->RunRange(own->index, own->parts, own->index);
            },
            &range, m_callbacks.context);
    }
    if (parts > 0) RunRange(0, parts, 0);
    for (int index = 1; index < parts; ++index) {
        // Null: the task was already run.
        if (ranges[index].handle != nullptr) m_callbacks.finish(ranges[index].handle, m_callbacks.context);
    }
}

#if defined(SCREE_HAS_THREADS)

void TaskPool::MakeThreads() {
    if (m_callbacks.enqueue != nullptr) {
        m_recruits = std::make_unique<Recruited[]>(static_cast<size_t>(m_workerCount));
        for (int worker = 1; worker < m_workerCount; ++worker) {
            m_recruits[static_cast<size_t>(worker)].pool = this;
            m_recruits[static_cast<size_t>(worker)].worker = worker;
        }
        return;
    }
    Undo undo([this] { Stop(); });  // those that could be made
    m_threads.reserve(static_cast<size_t>(m_workerCount - 1));
    for (int worker = 1; worker < m_workerCount; ++worker) m_threads.emplace_back([this, worker] { Work(worker); });
    undo.Dismiss();
}

void TaskPool::Stop() {
    m_quit = true;
    m_awake.Advance();
    m_awake.WakeAll();
    for (std::thread& thread : m_threads) thread.join();
}

void TaskPool::Begin() {
    m_inStep = m_workerCount > 1;
    if (m_stalledSteps > 0) --m_stalledSteps;
    m_cutsLoops = m_callbacks.enqueue != nullptr && m_callbacks.tasksPerWorker > 0;
    m_caller = std::this_thread::get_id();
    m_awake.Advance();
    if (!m_threads.empty()) m_awake.WakeAll();
}

void TaskPool::End() {
    m_inStep = false;
    m_awake.Advance();
    if (m_recruits != nullptr) Dismiss();
}

/// Hands a task to the program for each worker that has none, or whose task has left.
void TaskPool::Recruit() {
    bool areAllRefused = true;
    for (int worker = 1; worker < m_workerCount; ++worker) {
        Recruited& task = m_recruits[static_cast<size_t>(worker)];
        if (!task.isRefused && !task.isIn.load(std::memory_order_acquire)) {
            if (task.handle != nullptr) m_callbacks.finish(std::exchange(task.handle, nullptr), m_callbacks.context);
            task.isIn.store(true, std::memory_order_relaxed);
            task.handle = m_callbacks.enqueue(
                [](void* context) {
                    auto& own = *static_cast<Recruited*>(context);
                    // The thread that steps may run it, too, while it waits for something else.
                    if (std::this_thread::get_id() != own.pool->m_caller) {
                        const StandardFloats floats;
                        uint32_t turn = 0;
                        own.pool->WorkInStep(own.worker, turn, true);
                    }
                    own.isIn.store(false, std::memory_order_release);
                },
                &task, m_callbacks.context);
            task.isRefused = task.handle == nullptr;
        }
        areAllRefused = areAllRefused && task.isRefused;
    }
    m_cutsLoops = areAllRefused;
}

void TaskPool::Dismiss() {
    for (int worker = 1; worker < m_workerCount; ++worker) {
        Recruited& task = m_recruits[static_cast<size_t>(worker)];
        if (task.handle != nullptr) m_callbacks.finish(std::exchange(task.handle, nullptr), m_callbacks.context);
        task.isRefused = false;
        task.isIn.store(false, std::memory_order_relaxed);
    }
}

void TaskPool::Run(int count, TaskFunction function, void* context) {
    m_loop.count = count;
    m_loop.function = function;
    m_loop.context = context;
    if (m_recruits != nullptr) {
        if (!m_cutsLoops) Recruit();
        if (m_cutsLoops) return RunWithCallbacks();
    }
    m_loop.turn.store(++m_turn, std::memory_order_release);
    const auto chunks = static_cast<uint32_t>(m_workerCount * chunksPerWorker);
    uint32_t own = 0;
    for (int i = 0; i < m_workerCount; ++i) {
        // To look at the share of a thread that is at work holds it up.
        if (m_done.load(std::memory_order_acquire) == m_doneByThreads + (chunks - own)) break;
        own += RunShare(m_turn, i, 0);
    }
    m_doneByThreads += chunks - own;
    Await([&] { return m_done.load(std::memory_order_acquire) == m_doneByThreads; });
}

/// Runs what is left of a share and returns how many chunks that were. A share whose turn is the one before is that of
/// a loop that has ended: nobody has begun it in this one.
uint32_t TaskPool::RunShare(uint32_t turn, int share, int worker) {
    std::atomic<uint64_t>& shared = m_shares[static_cast<size_t>(share)].next;
    uint64_t next = shared.load(std::memory_order_acquire);
    for (uint32_t done = 0;;) {
        const auto ofTurn = static_cast<uint32_t>(next >> 32);
        if (ofTurn != turn && ofTurn != turn - 1) return done;
        const auto chunk = ofTurn == turn ? static_cast<int>(next & 0xFFFFFFFFu) : 0;
        if (chunk >= chunksPerWorker) return done;
        const uint64_t taken = static_cast<uint64_t>(turn) << 32 | static_cast<uint32_t>(chunk + 1);
        if (!shared.compare_exchange_weak(next, taken, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
        RunRange(share * chunksPerWorker + chunk, m_workerCount * chunksPerWorker, worker);
        ++done;
        next = shared.load(std::memory_order_acquire);
    }
}

void TaskPool::Work(int worker) {
    const StandardFloats floats;
    uint32_t turn = 0;
    for (;;) {
        // Between steps: sleep.
        for (uint32_t awake = m_awake.Load(); awake % 2 == 0 && !m_quit; awake = m_awake.Load()) m_awake.Wait(awake);
        if (m_quit) return;
        WorkInStep(worker, turn, false);
    }
}

/// Takes part in loops until the step is over; who may leave does so when there has been no loop for some time. `turn`:
/// the last one.
void TaskPool::WorkInStep(int worker, uint32_t& turn, bool mayLeave) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds patience(1);
    const auto current = [&] { return m_loop.turn.load(std::memory_order_acquire); };
    for (;;) {
        Clock::time_point idleSince;
        for (int turns = 0; current() == turn; ++turns) {
            if (m_awake.Load() % 2 == 0 || m_quit) return;
            GiveWay(turns);
            if (!mayLeave || turns < spinsInWait) continue;
            if (turns == spinsInWait) idleSince = Clock::now();
            if (Clock::now() - idleSince > patience) return;
        }
        turn = current();
        for (int i = 0; i < m_workerCount; ++i) {
            const uint32_t done = RunShare(turn, (worker + i) % m_workerCount, worker);
            if (done > 0) m_done.fetch_add(done, std::memory_order_release);
        }
    }
}

#else

void TaskPool::MakeThreads() {}
void TaskPool::Stop() {}
void TaskPool::Begin() {
    m_inStep = m_workerCount > 1 && m_callbacks.enqueue != nullptr;
    if (m_stalledSteps > 0) --m_stalledSteps;
}
void TaskPool::End() { m_inStep = false; }

void TaskPool::Run(int count, TaskFunction function, void* context) {
    m_loop.count = count;
    m_loop.function = function;
    m_loop.context = context;
    RunWithCallbacks();
}

#endif

}  // namespace scree
