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

TEST(Cores, AStepLastsItsSerialPartTheLongestTasksAndTheBarriers) {
    EXPECT_DOUBLE_EQ(PredictStep(10.0, {}), 10.0) << "nothing is shared";
    EXPECT_DOUBLE_EQ(PredictStep(10.0, {.loops = 3, .work = 8.0, .span = 2.0}), 2.0 + 2.0 + 3 * barrierMs);
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
    EXPECT_EQ(times.loops, 3);
    EXPECT_GT(times.span, 0.0);
    EXPECT_GE(times.work, times.span);
    EXPECT_LE(times.work, 3.0 * times.span) << "two tasks and the caller's";
    meter.Begin();
    EXPECT_EQ(meter.GetTimes().loops, 0);
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
        EXPECT_GT(meter.GetTimes().loops, 0);
    }
}

}  // namespace
}  // namespace testbed
