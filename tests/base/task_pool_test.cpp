// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every item once, whoever runs the loops; one chunk a worker at a time.

#include "base/task_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace scree {

namespace {

/// Which worker met each item; −1 none, −2 met twice.
std::vector<int> Owners(TaskPool& pool, int count, int least) {
    std::vector<int> owner(static_cast<size_t>(count), -1);
    pool.For(count, least, [&](int begin, int end, int worker) {
        for (int i = begin; i < end; ++i) {
            int& o = owner[static_cast<size_t>(i)];
            o = o == -1 ? worker : -2;
        }
    });
    return owner;
}

void ExpectEachOnce(const std::vector<int>& owners, int workers) {
    for (const int owner : owners) {
        ASSERT_GE(owner, 0);
        ASSERT_LT(owner, workers);
    }
}

TEST(TaskPool, MeetsEveryItemOnce) {
    for (const int workers : {2, 3, 7}) {
        TaskPool pool(workers, {});
        for (int step = 0; step < 20; ++step) {
            pool.Begin();
            for (const int count : {1, 5, 1000}) {
                for (int loop = 0; loop < 30; ++loop) ExpectEachOnce(Owners(pool, count, 1), workers);
            }
            pool.End();
        }
    }
}

// Threads wake, and find that the step is over.
TEST(TaskPool, AStepWithoutLoopsRunsNothing) {
    for (const int workers : {2, 3, 7}) {
        TaskPool pool(workers, {});
        for (int step = 0; step < 20; ++step) {
            pool.Begin();
            std::this_thread::sleep_for(std::chrono::microseconds(200));
            pool.End();
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        pool.Begin();
        ExpectEachOnce(Owners(pool, 1000, 1), workers);
        pool.End();
    }
}

// A thread whose chunk takes long leaves the rest of its part to the others.
TEST(TaskPool, OthersTakeWhatAThreadHasNotBegun) {
    constexpr int workers = 2, count = 64;
    TaskPool pool(workers, {});
    pool.Begin();
    for (int loop = 0; loop < 20; ++loop) {
        std::atomic<int> left{count};
        const int held = loop % workers;  // this one waits in its first chunk until all else is done
        std::atomic<bool> isHeld{false};
        std::vector<int> owner(count, -1);
        const auto give = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        pool.For(count, 1, [&](int begin, int end, int worker) {
            for (int i = begin; i < end; ++i) owner[static_cast<size_t>(i)] = worker;
            left -= end - begin;
            if (worker != held || isHeld.exchange(true)) return;
            while (left > 0 && std::chrono::steady_clock::now() < give) std::this_thread::yield();
            EXPECT_EQ(left, 0);
        });
        ExpectEachOnce(owner, workers);
    }
    pool.End();
}

TEST(TaskPool, OneWorkerHasOneChunkAtATime) {
    TaskPool pool(4, {});
    pool.Begin();
    std::atomic<int> busy[4] = {};
    std::atomic<int> clashes{0};
    for (int loop = 0; loop < 200; ++loop) {
        pool.For(64, 1, [&](int, int, int worker) {
            if (busy[worker].fetch_add(1) != 0) ++clashes;
            busy[worker].fetch_sub(1);
        });
    }
    pool.End();
    EXPECT_EQ(clashes, 0);
}

TEST(TaskPool, SmallLoopsAndLoopsOutsideOfAStepStayOnTheCaller) {
    TaskPool pool(4, {});
    EXPECT_EQ(Owners(pool, 100, 1), std::vector<int>(100, 0));
    pool.Begin();
    EXPECT_EQ(Owners(pool, 99, 100), std::vector<int>(99, 0));
    ExpectEachOnce(Owners(pool, 100, 100), 4);
    pool.End();
    EXPECT_TRUE(Owners(pool, 0, 1).empty());
}

TEST(TaskPool, ALoopIsOverWhenForReturns) {
    TaskPool pool(3, {});
    pool.Begin();
    std::vector<int64_t> sums(3);
    int64_t expected = 0;
    for (int loop = 1; loop <= 500; ++loop) {
        sums.assign(3, 0);
        pool.For(3000, 1, [&](int begin, int end, int worker) {
            for (int i = begin; i < end; ++i) sums[static_cast<size_t>(worker)] += i * loop;
        });
        expected = int64_t{2999} * 3000 / 2 * loop;
        ASSERT_EQ(std::accumulate(sums.begin(), sums.end(), int64_t{0}), expected);
    }
    pool.End();
}

struct Calls {
    int enqueued = 0, finished = 0;
};

TaskCallbacks RunAtOnce(Calls& calls) {
    return {[](void (*task)(void*), void* taskContext, void* user) -> void* {
                ++static_cast<Calls*>(user)->enqueued;
                task(taskContext);
                return nullptr;
            },
            [](void*, void* user) { ++static_cast<Calls*>(user)->finished; }, &calls};
}

TEST(TaskPool, LoopsAreCutForATaskSystemThatRunsTasksAtOnce) {
    Calls calls;
    TaskPool pool(3, RunAtOnce(calls));
    for (int step = 1; step <= 3; ++step) {
        pool.Begin();
        for (int loop = 0; loop < 4; ++loop) {
            const std::vector<int> owners = Owners(pool, 300, 1);
            for (int worker = 0; worker < 3; ++worker) EXPECT_EQ(std::ranges::count(owners, worker), 100);
        }
        pool.End();
        EXPECT_EQ(calls.enqueued, step * (2 + 4 * 2)) << "one each to see how it runs them";
    }
    EXPECT_EQ(calls.finished, 0);
}

/// A program's threads: one for each task.
struct TaskThreads {
    int enqueued = 0, finished = 0;
    std::atomic<int> ended{0};

    [[nodiscard]] TaskCallbacks GetCallbacks() {
        return {[](void (*task)(void*), void* taskContext, void* user) -> void* {
                    auto& own = *static_cast<TaskThreads*>(user);
                    ++own.enqueued;
                    return new std::thread([task, taskContext, &own] {
                        task(taskContext);
                        ++own.ended;
                    });
                },
                [](void* handle, void* user) {
                    auto* thread = static_cast<std::thread*>(handle);
                    thread->join();
                    delete thread;
                    ++static_cast<TaskThreads*>(user)->finished;
                },
                this};
    }
    /// Waits until so many tasks have ended; false if that takes too long.
    [[nodiscard]] bool AwaitEnd(int tasks) const {
        const auto give = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (ended < tasks && std::chrono::steady_clock::now() < give) std::this_thread::yield();
        return ended == tasks;
    }
};

TEST(TaskPool, AStepHasOneTaskForEachFurtherWorker) {
    constexpr int steps = 20, loops = 100;
    TaskThreads threads;
    TaskPool pool(3, threads.GetCallbacks());
    const auto start = std::chrono::steady_clock::now();
    int enqueued = 0;
    for (int step = 0; step < steps; ++step) {
        pool.Begin();
        for (int loop = 0; loop < loops; ++loop) ExpectEachOnce(Owners(pool, 300, 1), 3);
        EXPECT_LE(threads.finished, threads.enqueued - 2) << "as long as the step lasts";
        pool.End();
        EXPECT_EQ(threads.finished, threads.enqueued);
        EXPECT_GE(threads.enqueued, enqueued + 2);
        enqueued = threads.enqueued;
        pool.Begin();
        pool.End();
        EXPECT_EQ(threads.enqueued, enqueued) << "a step without loops has no tasks";
    }
    // A task leaves, and is started anew, only where its thread gets no loop for a millisecond.
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    EXPECT_LE(enqueued, 2 * steps + static_cast<int>(2.0 * elapsed.count()));
}

TEST(TaskPool, AStepsTaskThatHasNothingToDoLeavesAndIsStartedAgainWhenThereIs) {
    TaskThreads threads;
    TaskPool pool(3, threads.GetCallbacks());
    pool.Begin();
    for (int times = 1; times <= 3; ++times) {
        ExpectEachOnce(Owners(pool, 300, 1), 3);
        EXPECT_EQ(threads.enqueued, 2 * times);
        ASSERT_TRUE(threads.AwaitEnd(2 * times));
    }
    EXPECT_EQ(threads.finished, 4);
    pool.End();
    EXPECT_EQ(threads.finished, 6);
}

/// Tasks that wait until their `finish`, or for whoever runs one.
struct LateTasks {
    struct Task {
        void (*run)(void*);
        void* context;
        LateTasks* all;
    };
    std::vector<Task*> waiting;

    void RunOne() {
        if (waiting.empty()) return;
        const Task* const task = waiting.back();
        waiting.pop_back();
        task->run(task->context);
    }
    [[nodiscard]] TaskCallbacks GetCallbacks() {
        return {[](void (*task)(void*), void* taskContext, void* user) -> void* {
                    auto& all = *static_cast<LateTasks*>(user);
                    return all.waiting.emplace_back(new Task{task, taskContext, &all});
                },
                [](void* handle, void*) {
                    const std::unique_ptr<Task> task(static_cast<Task*>(handle));
                    if (std::erase(task->all->waiting, task.get()) > 0) task->run(task->context);
                },
                this};
    }
};

TEST(TaskPool, AStepsTasksMayRunLateOrOnTheThreadThatSteps) {
    for (const bool helps : {false, true}) {
        LateTasks tasks;
        TaskPool pool(4, tasks.GetCallbacks());
        for (int step = 0; step < 3; ++step) {
            pool.Begin();
            for (int loop = 0; loop < 10; ++loop) {
                std::vector<int> owners(300, -1);
                pool.For(300, 1, [&](int begin, int end, int worker) {
                    for (int i = begin; i < end; ++i) owners[static_cast<size_t>(i)] = worker;
                    if (helps) tasks.RunOne();  // as a program may that waits for another of its tasks
                });
                EXPECT_EQ(owners, std::vector<int>(300, 0));
            }
            pool.End();
            EXPECT_TRUE(tasks.waiting.empty());
        }
    }
}

TEST(TaskPool, ATaskSystemGetsSoManyTasksForEachWorkerButNoEmptyOnes) {
    Calls calls;
    TaskCallbacks atOnce = RunAtOnce(calls);
    atOnce.tasksPerWorker = 5;
    TaskPool pool(3, atOnce);
    EXPECT_EQ(pool.GetWorkerCount(), 3);
    EXPECT_EQ(pool.GetRowCount(), 15);
    pool.Begin();
    for (const int count : {0, 1, 2, 14, 15, 16, 300}) {
        calls.enqueued = 0;
        const std::vector<int> owners = Owners(pool, count, 0);
        ExpectEachOnce(owners, 15);
        EXPECT_EQ(calls.enqueued, std::max(std::min(count, 15) - 1, 0)) << count << " items";
        EXPECT_TRUE(std::ranges::is_sorted(owners)) << "each task has one range";
    }
    pool.End();
}

TEST(TaskPool, DoesNotLetWorkersWaitForEachOtherForSomeStepsAfterAStall) {
    Calls calls;
    for (const bool hasCallbacks : {false, true}) {
        TaskPool pool(2, hasCallbacks ? RunAtOnce(calls) : TaskCallbacks{});
        EXPECT_FALSE(pool.KeepsPace()) << "outside of a step";
        const auto keepsPace = [&pool] {
            pool.Begin();
            const bool keeps = pool.KeepsPace();
            pool.End();
            return keeps;
        };
        EXPECT_TRUE(keepsPace());
        pool.NoteStall();
        int steps = 0;
        while (steps < 1000 && !keepsPace()) ++steps;
        EXPECT_GT(steps, 10);
        EXPECT_LT(steps, 1000);
        EXPECT_TRUE(keepsPace());
        pool.NoteStall();
        pool.ShareAlways();
        EXPECT_TRUE(keepsPace()) << "tests see what threads do";
    }
}

}  // namespace
}  // namespace scree
