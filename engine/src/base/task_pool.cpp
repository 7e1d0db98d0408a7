// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Threads of the pool, and the same loops through a program's own task system.

#include "base/task_pool.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace scree {

namespace {

inline void Pause() {
#if defined(__SSE2__)
    _mm_pause();
#endif
}

/// Waits until done() holds: spins for some microseconds, then gives the core away in between.
template <typename Done>
void Await(Done&& done) {
    constexpr int spins = 2000;
    for (int i = 0; i < spins; ++i) {
        if (done()) return;
        Pause();
    }
    while (!done()) std::this_thread::yield();
}

}  // namespace

TaskPool::TaskPool(int workerCount, const TaskCallbacks& callbacks)
    : m_workerCount(workerCount), m_callbacks(callbacks) {
    if (m_callbacks.enqueue != nullptr) return;
    for (int worker = 1; worker < workerCount; ++worker) m_threads.emplace_back([this, worker] { Work(worker); });
}

TaskPool::~TaskPool() {
    m_quit = true;
    m_awake.fetch_add(1);
    m_awake.notify_all();
    for (std::thread& thread : m_threads) thread.join();
}

void TaskPool::Begin() {
    m_inStep = m_workerCount > 1;
    if (m_threads.empty()) return;
    m_awake.fetch_add(1);
    m_awake.notify_all();
}

void TaskPool::End() {
    m_inStep = false;
    if (!m_threads.empty()) m_awake.fetch_add(1);
}

void TaskPool::Run(int count, TaskFunction function, void* context) {
    m_count = count;
    m_function = function;
    m_context = context;
    if (m_callbacks.enqueue != nullptr) {
        RunWithCallbacks();
        return;
    }
    m_running.store(m_workerCount - 1, std::memory_order_relaxed);
    m_turn.fetch_add(1, std::memory_order_release);
    RunRange(0);
    Await([&] { return m_running.load(std::memory_order_acquire) == 0; });
}

void TaskPool::RunWithCallbacks() {
    struct Range {
        TaskPool* pool;
        int worker;
        void* handle;
    };
    Range ranges[maxWorkers];
    for (int worker = 1; worker < m_workerCount; ++worker) {
        Range& range = ranges[worker];
        range = {this, worker, nullptr};
        range.handle = m_callbacks.enqueue(
            [](void* context) {
                const auto* own = static_cast<Range*>(context);
                own->pool->RunRange(own->worker);
            },
            &range, m_callbacks.context);
    }
    RunRange(0);
    for (int worker = 1; worker < m_workerCount; ++worker) {
        // Null: the task was already run.
        if (ranges[worker].handle != nullptr) m_callbacks.finish(ranges[worker].handle, m_callbacks.context);
    }
}

void TaskPool::Work(int worker) {
    uint32_t turn = 0;
    for (;;) {
        // Between steps: sleep. A loop can only be started inside of a step, and is waited for before its end.
        for (uint32_t awake = m_awake.load(); awake % 2 == 0 && !m_quit; awake = m_awake.load()) m_awake.wait(awake);
        if (m_quit) return;
        Await([&] { return m_turn.load(std::memory_order_acquire) != turn || m_awake.load() % 2 == 0 || m_quit; });
        const uint32_t now = m_turn.load(std::memory_order_acquire);
        if (now == turn) continue;
        turn = now;
        RunRange(worker);
        m_running.fetch_sub(1, std::memory_order_release);
    }
}

}  // namespace scree
