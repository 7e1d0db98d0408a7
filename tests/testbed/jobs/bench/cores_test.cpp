// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Work and span: what the model makes of a step's loops, and that counting changes no state.

#include "testbed/jobs/bench/cores.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/loop_meter.h"

namespace testbed {
namespace {

TEST(Cores, ALoopIsDealtToTheCoreThatIsFreeFirst) {
    const std::vector<double> tasks{3.0, 1.0, 1.0, 1.0, 2.0};
    EXPECT_DOUBLE_EQ(DealToCores(tasks, 1), 8.0);
    EXPECT_DOUBLE_EQ(DealToCores(tasks, 2), 5.0) << "3 and 2 on one core, 1, 1, 1 on the other";
    EXPECT_DOUBLE_EQ(DealToCores(tasks, 5), 3.0) << "as long as its longest task";
    EXPECT_DOUBLE_EQ(DealToCores(tasks, 50), 3.0);
    EXPECT_DOUBLE_EQ(DealToCores({}, 4), 0.0);
}

TEST(Cores, AStepLastsItsSerialPartItsLoopsAndTheBarriers) {
    EXPECT_DOUBLE_EQ(PredictStep(SplitStep(10.0, {}), 8), 10.0) << "nothing is shared";
    const LoopTimes loops{.tasks = {1.0, 2.0, 2.0, 3.0}, .ends = {2, 3, 4}, .partEnds = {0, 0, 0}};
    const CountedStep step = SplitStep(10.0, loops);
    EXPECT_DOUBLE_EQ(step.apart, 2.0);
    EXPECT_DOUBLE_EQ(PredictStep(step, 1), 10.0 + 3 * barrierMs);
    EXPECT_DOUBLE_EQ(PredictStep(step, 2), 2.0 + (2.0 + 2.0 + 3.0) + 3 * barrierMs);
}

TEST(Cores, ChainsWaitForTheBordersOfOthers) {
    // Chains 0 and 1 have two parts each. The second part of each follows on the first of the other.
    const std::vector<PartTime> parts{
        {0, 1.0, {0, 0}}, {1, 3.0, {0, 0}}, {1, 1.0, {1, 1}}, {0, 1.0, {1, 1}}, {0, 2.0, {2, 0}}};
    EXPECT_DOUBLE_EQ(FollowChains(parts, 1), 8.0) << "one core does it all";
    EXPECT_DOUBLE_EQ(FollowChains(parts, 2), 3.0 + handoverMs + 1.0 + 2.0);
    EXPECT_DOUBLE_EQ(FollowChains(parts, 16), FollowChains(parts, 2));
    EXPECT_DOUBLE_EQ(FollowChains({}, 2), 0.0);

    // What a thread does that has all chains to follow belongs to no part.
    const LoopTimes loops{.tasks = {4.0, 4.5, 1.0, 2.0}, .ends = {2, 4}, .parts = parts, .partEnds = {5, 5}};
    EXPECT_DOUBLE_EQ(loops.GetElapsed(), 11.5);
    EXPECT_DOUBLE_EQ(loops.GetWork(), 8.0 + 3.0);
    EXPECT_DOUBLE_EQ(loops.GetSpan(2), 6.0 + handoverMs + 2.0);
    EXPECT_DOUBLE_EQ(SplitStep(12.0, loops).apart, 0.5);
    LoopTimes least = loops, other = loops;
    other.parts[1].ms = 2.0, other.parts[2].ms = 5.0;
    least.TakeLeast(other);
    EXPECT_DOUBLE_EQ(least.parts[1].ms, 2.0);
    EXPECT_DOUBLE_EQ(least.parts[2].ms, 1.0);
    other.parts[3].after[1] = 0;
    EXPECT_THROW(least.TakeLeast(other), std::logic_error);
}

TEST(Cores, RepeatsKeepTheLeastTimeOfEachPart) {
    CountedStep step{.apart = 2.0, .loops = {.tasks = {1.0, 5.0}, .ends = {2}, .partEnds = {0}}};
    step.TakeLeast({.apart = 3.0, .loops = {.tasks = {2.0, 4.0}, .ends = {2}, .partEnds = {0}}});
    EXPECT_DOUBLE_EQ(step.apart, 2.0);
    EXPECT_EQ(step.loops.tasks, (std::vector<double>{1.0, 4.0}));
    EXPECT_THROW(step.TakeLeast({.apart = 1.0, .loops = {.tasks = {1.0}, .ends = {1}, .partEnds = {0}}}),
                 std::logic_error);
}

/// A task that keeps the thread busy, so that it has a time.
void Spin(void* done) {
    volatile int sum = 0;
    for (int i = 0; i < 20000; ++i) sum = sum + i;
    *static_cast<bool*>(done) = true;
}

TEST(Cores, TheMeterRunsEveryTaskAtOnceAndCountsLoops) {
    LoopMeter meter;
    const scree::TaskCallbacks calls = meter.GetCallbacks();
    for (int loop = 0; loop < 3; ++loop) {
        bool done[2] = {};
        void* const first = calls.enqueue(Spin, &done[0], calls.context);
        EXPECT_TRUE(done[0]);
        void* const second = calls.enqueue(Spin, &done[1], calls.context);
        ASSERT_NE(first, nullptr);
        ASSERT_NE(second, nullptr);
        bool own = false;
        Spin(&own);
        calls.finish(first, calls.context);
        calls.finish(second, calls.context);
    }
    const LoopTimes& times = meter.GetTimes();
    EXPECT_EQ(times.CountLoops(), 3);
    EXPECT_EQ(times.tasks.size(), 9u) << "two tasks and the caller's";
    EXPECT_GT(times.GetSpan(8), 0.0);
    EXPECT_GE(times.GetWork(), times.GetSpan(2));
    EXPECT_DOUBLE_EQ(times.GetWork(), times.GetSpan(1));
    meter.Begin();
    EXPECT_EQ(meter.GetTimes().CountLoops(), 0);
}

TEST(Cores, CountingLeavesTheStatesAsTheyAre) {
    // Enough bodies for loops to be shared; the pyramid has enough contacts for chains, too.
    const scenes::Scene squares = scenes::Build("falling-squares", 60), pyramid = scenes::Build("pyramid", 60);
    const auto hashOf = [&](const scenes::Scene& scene, int threads, LoopMeter* meter) {
        RunSpec spec = MakeSpec("scree");
        spec.threads = threads;
        const auto run = MakeRun(scene, spec, {.loops = meter});
        for (int i = 0; i < 40; ++i) run->Step();
        Snapshot snapshot;
        run->Capture(snapshot);
        return snapshot.stateHash;
    };
    for (const scenes::Scene* scene : {&squares, &pyramid}) {
        const auto alone = hashOf(*scene, 1, nullptr);
        for (const int threads : {2, 8, 16}) {
            LoopMeter meter;
            EXPECT_EQ(hashOf(*scene, threads, &meter), alone) << threads << " tasks a loop";
            const LoopTimes& times = meter.GetTimes();
            EXPECT_GT(times.CountLoops(), 0);
            EXPECT_EQ(times.partEnds.size(), times.ends.size());
            if (scene == &pyramid && threads == 2) EXPECT_GT(times.parts.size(), 100u);
            EXPECT_LE(times.GetSpan(threads), times.GetElapsed());
        }
    }
}

}  // namespace
}  // namespace testbed
