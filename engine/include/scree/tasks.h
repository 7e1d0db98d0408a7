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

/// A part of a task, for who measures. Contacts of a large island are solved in chains of such parts.
struct TaskPart {
    int chain = 0;       ///< 0…chainCount − 1; parts of a chain follow each other
    int chainCount = 0;  ///< of this loop
    /// By chain: how many of its parts had to be done before this one could begin. Only valid during the call.
    const int* after = nullptr;
};

/// How a world gives work to a task system. Tasks may run in any order, on any threads, also one after the other, late,
/// or not before `finish`. A task may wait for what another one is in the midst of, never for one that has not begun:
/// it does that one's work itself. Results do not depend on that.
struct TaskCallbacks {
    /// Starts task(taskContext) and returns a handle for `finish`, or runs the task at once and returns null.
    void* (*enqueue)(void (*task)(void* taskContext), void* taskContext, void* userContext) = nullptr;
    /// Waits until the task is done.
    void (*finish)(void* handle, void* userContext) = nullptr;
    void* context = nullptr;  ///< passed on as userContext
    /// 0: a step has one task for each further worker. It takes part in all loops of the step, and waits by spinning in
    /// between. It leaves when there has been no loop for about a millisecond; another one is started when there is.
    /// 1…maxWorkers / workers: each loop is cut into so many tasks for each worker, and no task waits for loops. That
    /// is so with 0, too, in steps whose tasks were all run at once.
    int tasksPerWorker = 0;
    /// Told of each part before (isDone = false) and after it is done, on the thread that does it. Parts of one loop
    /// may be done at the same time, on several threads. It must not call the world. Null: nobody is told.
    void (*part)(const TaskPart& part, bool isDone, void* userContext) = nullptr;
};

}  // namespace scree
