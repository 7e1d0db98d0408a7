// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every item once, by the same worker in every loop, whoever runs the loops.

#include "base/task_pool.h"

#include <gtest/gtest.h>

#include <future>
#include <numeric>

namespace scree {

namespace {

/// Which worker met each item; −1 none, −2 several.
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

void ExpectRanges(const std::vector<int>& owners, int workers) {
    EXPECT_TRUE(std::is_sorted(owners.begin(), owners.end()));
    EXPECT_EQ(owners.front(), 0);
    EXPECT_EQ(owners.back(), workers - 1);
}

TEST(TaskPool, CutsALoopIntoOneRangeAWorker) {
    for (const int workers : {2, 3, 7}) {
        TaskPool pool(workers, {});
        for (int step = 0; step < 20; ++step) {
            pool.Begin();
            const std::vector<int> first = Owners(pool, 1000, 10);
            ExpectRanges(first, workers);
            for (int loop = 0; loop < 50; ++loop) ASSERT_EQ(Owners(pool, 1000, 10), first);
            pool.End();
        }
    }
}

TEST(TaskPool, SmallLoopsAndLoopsOutsideOfAStepStayOnTheCaller) {
    TaskPool pool(4, {});
    EXPECT_EQ(Owners(pool, 100, 1), std::vector<int>(100, 0));
    pool.Begin();
    EXPECT_EQ(Owners(pool, 99, 100), std::vector<int>(99, 0));
    EXPECT_EQ(Owners(pool, 100, 100).back(), 3);
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

TEST(TaskPool, ATaskSystemMayRunTasksAtOnceOrOnItsThreads) {
    Calls calls;
    const TaskCallbacks atOnce{[](void (*task)(void*), void* taskContext, void* user) -> void* {
                                   ++static_cast<Calls*>(user)->enqueued;
                                   task(taskContext);
                                   return nullptr;
                               },
                               [](void*, void* user) { ++static_cast<Calls*>(user)->finished; }, &calls};
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
        ExpectRanges(Owners(pool, 300, 1), 3);
        pool.End();
        EXPECT_EQ(calls.enqueued, 2);
        EXPECT_EQ(calls.finished, 0);
    }
    TaskPool pool(3, threads);
    pool.Begin();
    for (int loop = 0; loop < 10; ++loop) ExpectRanges(Owners(pool, 300, 1), 3);
    pool.End();
    EXPECT_EQ(calls.enqueued, 22);
    EXPECT_EQ(calls.finished, 20);
}

}  // namespace
}  // namespace scree
