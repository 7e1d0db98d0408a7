// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Law: how many workers share FindPairs changes neither a pair nor their order nor what is counted.

#include <gtest/gtest.h>

#include "base/task_pool.h"
#include "tests/broad_phase/test_world.h"

namespace scree::test {
namespace {

TaskCallbacks RunAtOnce() {
    TaskCallbacks tasks;
    tasks.enqueue = [](void (*task)(void*), void* taskContext, void*) -> void* {
        task(taskContext);
        return nullptr;
    };
    tasks.finish = [](void*, void*) {};
    return tasks;
}

/// A world of that shape beside a broad phase, which may share its work with a pool.
struct Follower {
    TestWorld world;
    std::unique_ptr<TaskPool> pool;
    std::unique_ptr<BroadPhase> broadPhase = CreateBroadPhase(BroadPhaseKind::keys);

    /// More than a few workers are no threads: their tasks run at once.
    Follower(const WorldShape& shape, int workers)
        : world(shape), pool(std::make_unique<TaskPool>(workers, workers > 5 ? RunAtOnce() : TaskCallbacks{})) {
        broadPhase->ShareWork(*pool);
        world.Fill(*broadPhase);
    }
    std::vector<Pair> FindPairs() {
        std::vector<Pair> pairs;
        pool->Begin();
        broadPhase->FindPairs(pairs);
        pool->End();
        return pairs;
    }
};

void ExpectSamePairs(const WorldShape& shape, int workers, int steps) {
    SCOPED_TRACE("layout " + std::to_string(static_cast<int>(shape.layout)) + ", " + std::to_string(workers) +
                 " workers, static share " + std::to_string(shape.staticShare));
    Follower alone(shape, 1), together(shape, workers);
    for (int step = 0; step < steps; ++step) {
        for (Follower* follower : {&alone, &together}) {
            follower->world.Edit(*follower->broadPhase, step % 3 == 0 ? 40 : 0);
            follower->world.Drift(*follower->broadPhase, 0.2f);
        }
        const std::vector<Pair> expected = alone.FindPairs();
        ASSERT_TRUE(together.FindPairs() == expected) << "step " << step;
        EXPECT_EQ(together.broadPhase->GetStats().boxTests, alone.broadPhase->GetStats().boxTests);
        if (step > 0) continue;
        std::vector<Pair> sorted = expected;
        std::sort(sorted.begin(), sorted.end());
        EXPECT_TRUE(sorted == alone.world.TruePairs());
    }
}

TEST(SharedWalk, FindsTheSamePairsInTheSameOrder) {
    for (int layout = 0; layout < static_cast<int>(Layout::count); ++layout) {
        // 2,048 boxes are the least that are shared; on one point every two of them pair.
        const int count = static_cast<Layout>(layout) == Layout::onePoint ? 2100 : 5000;
        // No statics; few enough for candidates of the root; in the main tree; in a tree of their own.
        for (const float staticShare : {0.0f, 0.004f, 0.1f, 0.5f}) {
            const WorldShape shape{.layout = static_cast<Layout>(layout), .count = count, .staticShare = staticShare};
            ExpectSamePairs(shape, 2 + layout % 4, 4);
        }
    }
}

// So many that a part would be smaller than a leaf.
TEST(SharedWalk, MayHaveMoreWorkersThanSubtrees) {
    for (const Layout layout : {Layout::spread, Layout::clusters, Layout::outlier}) {
        ExpectSamePairs({.layout = layout, .count = 2500, .staticShare = 0.004f}, maxWorkers, 4);
    }
}

TEST(SharedWalk, PoolsMayChangeBetweenCalls) {
    const WorldShape shape{.layout = Layout::clusters, .count = 4000};
    Follower alone(shape, 1), together(shape, 2);
    for (const int workers : {3, 1, 5, 2}) {
        together.pool = std::make_unique<TaskPool>(workers, TaskCallbacks{});
        together.broadPhase->ShareWork(*together.pool);
        for (Follower* follower : {&alone, &together}) follower->world.Drift(*follower->broadPhase, 0.2f);
        EXPECT_TRUE(together.FindPairs() == alone.FindPairs()) << workers;
    }
}

}  // namespace
}  // namespace scree::test
