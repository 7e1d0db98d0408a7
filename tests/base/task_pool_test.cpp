// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every item once, whoever runs the loops; one chunk a worker at a time.

#include "base/task_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <numeric>
#include <thread>

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

TEST(TaskPool, ATaskSystemMayRunTasksAtOnceOrOnItsThreads) {
    Calls calls;
    const TaskCallbacks atOnce = RunAtOnce(calls);
    const TaskCallbacks threads{[](void (*task)(void*), void* taskContext, void* user) -> void* {
                                    ++static_cast<Calls*>(user)->enqueued;
                                    return new std::future<void>(std::async(std::launch::async, task, taskContext));
                                },
                                [](void* handle, void* user) {
                                    auto* future = static_cast<std::future<void>*>(handle);
                                    future->wait();
                                    delete future;
                                    ++static_cast<Calls*>(user)->finished;
                                },
                                &calls};
    {
        TaskPool pool(3, atOnce);
        pool.Begin();
        ExpectEachOnce(Owners(pool, 300, 1), 3);
        pool.End();
        EXPECT_EQ(calls.enqueued, 2);
        EXPECT_EQ(calls.finished, 0);
    }
    TaskPool pool(3, threads);
    pool.Begin();
    for (int loop = 0; loop < 10; ++loop) ExpectEachOnce(Owners(pool, 300, 1), 3);
    pool.End();
    EXPECT_EQ(calls.enqueued, 22);
    EXPECT_EQ(calls.finished, 20);
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
