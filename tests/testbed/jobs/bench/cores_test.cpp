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
    const LoopTimes loops{.tasks = {1.0, 2.0, 2.0, 3.0}, .ends = {2, 3, 4}};
    const CountedStep step = SplitStep(10.0, loops);
    EXPECT_DOUBLE_EQ(step.apart, 2.0);
    EXPECT_DOUBLE_EQ(PredictStep(step, 1), 10.0 + 3 * barrierMs);
    EXPECT_DOUBLE_EQ(PredictStep(step, 2), 2.0 + (2.0 + 2.0 + 3.0) + 3 * barrierMs);
}

TEST(Cores, RepeatsKeepTheLeastTimeOfEachPart) {
    CountedStep step{.apart = 2.0, .loops = {.tasks = {1.0, 5.0}, .ends = {2}}};
    step.TakeLeast({.apart = 3.0, .loops = {.tasks = {2.0, 4.0}, .ends = {2}}});
    EXPECT_DOUBLE_EQ(step.apart, 2.0);
    EXPECT_EQ(step.loops.tasks, (std::vector<double>{1.0, 4.0}));
    EXPECT_THROW(step.TakeLeast({.apart = 1.0, .loops = {.tasks = {1.0}, .ends = {1}}}), std::logic_error);
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
    const scenes::Scene scene = scenes::Build("falling-squares", 60);  // enough bodies for loops to be shared
    const auto hashOf = [&](int threads, LoopMeter* meter) {
        RunSpec spec = MakeSpec("scree");
        spec.threads = threads;
        const auto run = MakeRun(scene, spec, {.loops = meter});
        for (int i = 0; i < 40; ++i) run->Step();
        Snapshot snapshot;
        run->Capture(snapshot);
        return snapshot.stateHash;
    };
    const auto alone = hashOf(1, nullptr);
    for (const int threads : {2, 8, 16}) {
        LoopMeter meter;
        EXPECT_EQ(hashOf(threads, &meter), alone) << threads << " tasks a loop";
        EXPECT_GT(meter.GetTimes().CountLoops(), 0);
    }
}

}  // namespace
}  // namespace testbed
