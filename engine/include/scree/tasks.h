// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program's own task system in place of the world's threads.

#pragma once

namespace scree {

/// Largest number of threads of a world, including the one that calls Step.
inline constexpr int maxWorkers = 64;

/// One range [begin, end) of a loop.
using TaskFunction = void (*)(void* context, int begin, int end, int worker);

/// How a world gives work to a task system. The tasks of a loop are independent of each other. They may run in any
/// order, on any threads, also one after the other; they never wait for each other. Results do not depend on that.
struct TaskCallbacks {
    /// Starts task(taskContext) and returns a handle for `finish`, or runs the task at once and returns null.
    void* (*enqueue)(void (*task)(void* taskContext), void* taskContext, void* userContext) = nullptr;
    /// Waits until the task is done.
    void (*finish)(void* handle, void* userContext) = nullptr;
    void* context = nullptr;  ///< passed on as userContext
    /// Into how many tasks a loop is cut for each worker, 1…maxWorkers / workers. With more of them tasks are shorter,
    /// and a worker that is done early takes some of another's; with fewer there are fewer to start.
    int tasksPerWorker = 1;
};

}  // namespace scree
