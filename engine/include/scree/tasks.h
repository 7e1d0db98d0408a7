// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program's own task system in place of the world's threads.

#pragma once

namespace scree {

/// Most workers of a world, the thread that calls Step included.
inline constexpr int maxWorkers = 64;

/// One range [begin, end) of a loop.
using TaskFunction = void (*)(void* context, int begin, int end, int worker);

/// How a world hands work to a task system. Tasks of one loop are independent of each other and may run in any order,
/// on any thread, even one after the other; they never wait for each other. Results do not depend on who runs them.
struct TaskCallbacks {
    /// Runs task(taskContext) sometime before `finish` returns for the handle it gives back; null if it ran it at once.
    void* (*enqueue)(void (*task)(void* taskContext), void* taskContext, void* userContext) = nullptr;
    /// Waits for the task.
    void (*finish)(void* handle, void* userContext) = nullptr;
    void* context = nullptr;  ///< passed on as userContext
};

}  // namespace scree
