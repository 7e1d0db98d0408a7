// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The accuracy dial and the tolerance that picks sub-steps.

#include <gtest/gtest.h>

#include "scree/recording.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

void AddColumn(World& world, int count, float density) {
    AddGround(world);
    for (int i = 0; i < count; ++i) {
        AddBox(AddBody(world, dynamicBody, {0.0f, 0.5f + static_cast<float>(i)}), 0.5f, 0.5f, density);
    }
    world.SetAllowSleeping(false);
}

/// A chain of ten links with `load` times a link's mass at its end, let go from the horizontal.
void AddChain(World& world, float load) {
    Body* before = AddBody(world, staticBody, {0.0f, 0.0f});
    for (int i = 0; i <= 10; ++i) {
        Body* link = AddBody(world, dynamicBody, {static_cast<float>(i) + 0.5f, 0.0f});
        AddBox(link, 0.5f, 0.125f, i == 10 ? load : 1.0f);
        RevoluteJointDef def;
        def.Initialize(before, link, {static_cast<float>(i), 0.0f});
        world.CreateJoint(&def);
        before = link;
    }
    world.SetAllowSleeping(false);
}

TEST(Accuracy, MarksOfTheDialAreTheStepsThatTheyStandFor) {
    const auto hashAfter = [](auto&& step) {
        World world({0.0f, -10.0f});
        AddColumn(world, 4, 1.0f);
        AddChain(world, 10.0f);
        for (int i = 0; i < 20; ++i) step(world);
        return inspect::GetStateHash(world);
    };
    const auto mark = [&](Accuracy accuracy) { return hashAfter([&](World& world) { world.Step(frame, accuracy); }); };
    const auto substeps = [&](int n) { return hashAfter([&](World& world) { world.Step(frame, n); }); };
    EXPECT_EQ(mark(Accuracy::draft), hashAfter([](World& world) { world.Step(frame, 4, 2); }));
    EXPECT_EQ(mark(Accuracy::game), substeps(4));
    EXPECT_EQ(mark(Accuracy::fine), substeps(8));
    EXPECT_EQ(mark(Accuracy::precise), substeps(16));
}

TEST(Accuracy, ATighterToleranceTakesMoreSubstepsAndIsKept) {
    int before = 0;
    for (const float overlap : {0.02f, 0.008f, 0.006f}) {
        World world({0.0f, -10.0f});
        AddColumn(world, 30, 1.0f);
        Tolerance tolerance;
        tolerance.overlap = overlap;
        StepReport report;
        for (int i = 0; i < 300; ++i) report = world.Step(frame, tolerance);
        EXPECT_LE(report.errors.overlap, 1.02f * overlap);
        EXPECT_GT(report.errors.overlap, 0.0f);
        EXPECT_GE(report.substeps, before);
        before = report.substeps;
    }
    EXPECT_GT(before, Tolerance{}.leastSubsteps);
}

TEST(Accuracy, APulledChainGetsTheSubstepsThatItsPullNeeds) {
    const auto most = [](float load) {
        World world({0.0f, -10.0f});
        AddChain(world, load);
        int highest = 0;
        float gap = 0.0f;
        for (int i = 0; i < 180; ++i) {
            const StepReport report = world.Step(frame, Tolerance{});
            highest = std::max(highest, report.substeps);
            gap = std::max(gap, report.errors.jointGap);
        }
        EXPECT_LT(gap, Tolerance{}.jointGap) << load;
        return highest;
    };
    EXPECT_EQ(most(1.0f), 4);
    int before = 4;
    for (const float load : {1000.0f, 3000.0f, 10000.0f}) {  // its pull goes up and down many times a swing
        const int now = most(load);
        EXPECT_GT(now, before) << load;
        before = now;
    }
}

TEST(Accuracy, ToleranceIsDeterministicAndSurvivesSnapshotsAndRecordings) {
    World world({0.0f, -10.0f});
    AddColumn(world, 10, 1.0f);
    Tolerance tolerance;
    tolerance.overlap = 0.007f;
    Recorder recorder;
    ASSERT_EQ(StartRecording(world, recorder), ErrorCode::ok);
    for (int i = 0; i < 30; ++i) world.Step(frame, tolerance);
    const std::vector<std::byte> image = SaveWorld(world);
    SnapshotError error{};
    const std::unique_ptr<World> restored = LoadWorld(image, &error);
    ASSERT_TRUE(restored);
    for (int i = 0; i < 60; ++i) {
        const StepReport one = world.Step(frame, tolerance), other = restored->Step(frame, tolerance);
        ASSERT_EQ(one.substeps, other.substeps) << i;
        ASSERT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*restored)) << i;
    }
    StopRecording(world);
    const ReplayReport report = Replay(recorder.GetBytes());
    EXPECT_TRUE(report.valid);
    EXPECT_EQ(report.firstDifference, 0);
    EXPECT_EQ(report.steps, 90);
}

TEST(Accuracy, BadInputIsRefused) {
    World world({0.0f, -10.0f});
    AddColumn(world, 2, 1.0f);
    ErrorLog log(world);
    const uint64_t before = inspect::GetStateHash(world);
    const auto expect = [&](const char* field, const Tolerance& tolerance) {
        world.Step(frame, tolerance);
        EXPECT_STREQ(log.last.field, field);
        EXPECT_EQ(inspect::GetStateHash(world), before);
    };
    expect("tolerance.overlap", {.overlap = linearSlop});
    expect("tolerance.overlap", {.overlap = std::numeric_limits<float>::quiet_NaN()});
    expect("tolerance.overlap", {.overlap = std::numeric_limits<float>::infinity()});
    expect("tolerance.jointGap", {.jointGap = 0.0f});
    expect("tolerance.leastSubsteps", {.leastSubsteps = 0});
    expect("tolerance.mostSubsteps", {.leastSubsteps = 8, .mostSubsteps = 4});
    world.Step(frame, static_cast<Accuracy>(9));
    EXPECT_STREQ(log.last.field, "accuracy");
    EXPECT_EQ(log.count, 7);
}

}  // namespace
}  // namespace scree::test
