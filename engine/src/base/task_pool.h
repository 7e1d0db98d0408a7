// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Loops over independent items on several threads. A loop is cut into one range per worker, by position alone, so the
// same worker meets the same items in every loop of a step, and no result can depend on who was faster. Loops below a
// size stay on the caller: that is decided from counts, never from clocks.
//
// Workers sleep between steps (Begin wakes them once, End lets them sleep) and wait between the loops of a step by
// spinning for a while and then yielding, so that a core taken by another process does not stop the others.

#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "scree/tasks.h"

namespace scree {

class TaskPool {
public:
    /// `workerCount` ≥ 1, the calling thread included. With callbacks no threads are made: every loop goes to them.
    TaskPool(int workerCount, const TaskCallbacks& callbacks);
    ~TaskPool();
    TaskPool(const TaskPool&) = delete;
    TaskPool& operator=(const TaskPool&) = delete;

    [[nodiscard]] int GetWorkerCount() const { return m_workerCount; }
    void Begin();
    void End();

    /// Calls body(begin, end, worker) for the ranges of [0, count), the first on this thread. One call with everything
    /// if count < least, outside of Begin and End, or with one worker.
    template <typename Body>
    void For(int count, int least, Body&& body) {
        if (!m_inStep || count < least) {
            body(0, count, 0);
            return;
        }
        using Loop = std::remove_reference_t<Body>;
        Run(
            count,
            [](void* context, int begin, int end, int worker) { (*static_cast<Loop*>(context))(begin, end, worker); },
            const_cast<std::remove_const_t<Loop>*>(&body));
    }

private:
    void Run(int count, TaskFunction function, void* context);
    void RunWithCallbacks();
    void Work(int worker);
    [[nodiscard]] int Start(int worker) const {
        return static_cast<int>(static_cast<int64_t>(m_count) * worker / m_workerCount);
    }
    void RunRange(int worker) { m_function(m_context, Start(worker), Start(worker + 1), worker); }

    const int m_workerCount;
    const TaskCallbacks m_callbacks;
    std::vector<std::thread> m_threads;

    // The loop at hand; written before m_turn changes.
    bool m_inStep = false;  ///< and with more than one worker
    int m_count = 0;
    TaskFunction m_function = nullptr;
    void* m_context = nullptr;

    alignas(64) std::atomic<uint32_t> m_turn{0};   ///< counts loops
    alignas(64) std::atomic<int> m_running{0};     ///< workers still busy with the loop
    alignas(64) std::atomic<uint32_t> m_awake{0};  ///< odd: inside a step
    std::atomic<bool> m_quit{false};
};

}  // namespace scree
