// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A tolerance picks the sub-steps of each island by itself: a hard one among many easy ones.

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "pipeline/group_substeps.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

constexpr int pileCount = 40, pileHeight = 3, columnHeight = 45;

void AddColumn(World& world, float x, int count) {
    for (int i = 0; i < count; ++i) {
        AddBox(AddBody(world, dynamicBody, {x, 0.5f + static_cast<float>(i)}), 0.5f, 0.5f, 1.0f);
    }
}

/// Ten links with 5000 times a link's mass at the end, let go from the horizontal.
void AddLoadedChain(World& world, Vec2 hook) {
    Body* before = AddBody(world, staticBody, hook);
    for (int i = 0; i <= 10; ++i) {
        Body* link = AddBody(world, dynamicBody, hook + Vec2{static_cast<float>(i) + 0.5f, 0.0f});
        AddBox(link, 0.5f, 0.125f, i == 10 ? 5000.0f : 1.0f);
        RevoluteJointDef def;
        def.Initialize(before, link, hook + Vec2{static_cast<float>(i), 0.0f});
        world.CreateJoint(&def);
        before = link;
    }
}

enum class Hard { column, chain };

struct Parts {
    bool hard = true, easy = true;
};

/// One hard island beside `pileCount` easy piles on the same ground, and ten bodies in free fall.
void Fill(World& world, Hard hard, Parts parts) {
    Body* ground = AddBody(world, staticBody, {0.0f, -0.5f});
    AddBox(ground, 400.0f, 0.5f, 0.0f);
    if (parts.hard && hard == Hard::column) AddColumn(world, -20.0f, columnHeight);
    if (parts.hard && hard == Hard::chain) AddLoadedChain(world, {-40.0f, 40.0f});
    if (parts.easy) {
        for (int i = 0; i < pileCount; ++i) AddColumn(world, 3.0f * static_cast<float>(i), pileHeight);
        for (int i = 0; i < 10; ++i)
            AddCircle(AddBody(world, dynamicBody, {3.0f * static_cast<float>(i), 900.0f}), 0.5f, 1.0f);
    }
    world.SetAllowSleeping(false);
}

struct Outcome {
    int mostSubsteps = 0;
    int64_t bodySubsteps = 0, wholeWorldSubsteps = 0;  ///< the latter: every awake body as the hardest island
    float overlap = 0.0f, jointGap = 0.0f;             ///< worst of the second half, or of all steps
    uint64_t hash = 0;
};

Outcome RunFor(int steps, Hard hard, Parts parts, const Tolerance& tolerance, int workers = 1) {
    WorldDef def;
    def.workerCount = workers;
    World world(def);
    world.GetState().pool->ShareAlways();
    Fill(world, hard, parts);
    Outcome outcome;
    for (int i = 0; i < steps; ++i) {
        const StepReport report = world.Step(frame, tolerance);
        outcome.mostSubsteps = std::max(outcome.mostSubsteps, report.substeps);
        outcome.bodySubsteps += report.bodySubsteps;
        outcome.wholeWorldSubsteps += int64_t{report.substeps} * report.awakeBodyCount;
        if (i >= steps / 2) outcome.overlap = std::max(outcome.overlap, report.errors.overlap);
        outcome.jointGap = std::max(outcome.jointGap, report.errors.jointGap);
    }
    outcome.hash = inspect::GetStateHash(world);
    return outcome;
}

constexpr Tolerance tight{.overlap = 0.007f};

TEST(IslandSubsteps, AHardIslandDoesNotMakeTheEasyOnesDear) {
    for (const Hard hard : {Hard::column, Hard::chain}) {
        const Outcome alone = RunFor(200, hard, {.easy = false}, tight);
        const Outcome easy = RunFor(200, hard, {.hard = false}, tight);
        const Outcome both = RunFor(200, hard, {}, tight);
        EXPECT_GT(alone.mostSubsteps, 2 * easy.mostSubsteps);
        EXPECT_EQ(both.mostSubsteps, alone.mostSubsteps);
        // Side by side they take what each takes by itself, but for the order of contacts in their common groups.
        const auto apart = static_cast<double>(alone.bodySubsteps + easy.bodySubsteps);
        EXPECT_NEAR(static_cast<double>(both.bodySubsteps), apart, 0.005 * apart);
        EXPECT_LE(both.overlap, tight.overlap);
        EXPECT_LE(both.jointGap, tight.jointGap);
        EXPECT_LT(3 * both.bodySubsteps, 2 * both.wholeWorldSubsteps);  // a column settles on eight, piles on four
    }
}

TEST(IslandSubsteps, BodiesNotedTheSubstepsOfTheirIsland) {
    World world({0.0f, -10.0f});
    Fill(world, Hard::column, {});
    StepReport report;
    for (int i = 0; i < 120; ++i) report = world.Step(frame, tight);
    const BodyTable& bodies = world.GetState().bodies;
    int64_t sum = 0;
    int hard = 0;
    for (const BodyIndex b : bodies.movers) {
        sum += bodies.demand[b].substeps;
        const bool inColumn = bodies.position[b].c.x < -10.0f;
        EXPECT_EQ(bodies.demand[b].substeps, inColumn ? report.substeps : tight.leastSubsteps);
        hard += inColumn ? 1 : 0;
    }
    EXPECT_EQ(hard, columnHeight);
    EXPECT_GT(report.substeps, tight.leastSubsteps);
    EXPECT_EQ(sum, report.bodySubsteps);
}

TEST(IslandSubsteps, AreTheSameForAnyNumberOfWorkersAndOnRepeat) {
    for (const Hard hard : {Hard::column, Hard::chain}) {
        const uint64_t one = RunFor(90, hard, {}, tight).hash;
        EXPECT_EQ(RunFor(90, hard, {}, tight).hash, one);
        for (const int workers : {2, 3}) EXPECT_EQ(RunFor(90, hard, {}, tight, workers).hash, one) << workers;
    }
}

TEST(IslandSubsteps, SurviveASnapshot) {
    for (const Hard hard : {Hard::column, Hard::chain}) {
        World world({0.0f, -10.0f});
        Fill(world, hard, {});
        for (int i = 0; i < 40; ++i) world.Step(frame, tight);
        const std::unique_ptr<World> restored = LoadWorld(SaveWorld(world));
        ASSERT_TRUE(restored);
        for (int i = 0; i < 60; ++i) {
            const StepReport one = world.Step(frame, tight), other = restored->Step(frame, tight);
            ASSERT_EQ(one.bodySubsteps, other.bodySubsteps) << i;
            ASSERT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*restored)) << i;
        }
    }
}

/// One island moves bit for bit as by a step with the number that was picked for it.
TEST(IslandSubsteps, AnIslandAloneMovesAsByAStepWithItsNumber) {
    for (const Hard hard : {Hard::column, Hard::chain}) {
        World picked({0.0f, -10.0f}), given({0.0f, -10.0f});
        for (World* world : {&picked, &given}) Fill(*world, hard, {.easy = false});
        int changes = 0, before = 0, step = 0;
        for (; step < 200; ++step) {
            const StepReport report = picked.Step(frame, tight);
            if (report.islandCount != 1 || report.isolatedBodyCount > 0) break;  // the column sways apart
            Tolerance number = tight;
            number.leastSubsteps = number.mostSubsteps = report.substeps;
            given.Step(frame, number);
            changes += report.substeps != before ? 1 : 0;
            before = report.substeps;
            const BodyTable &a = picked.GetState().bodies, &b = given.GetState().bodies;
            for (const BodyIndex row : a.movers) {
                ASSERT_EQ(a.position[row].c, b.position[row].c) << step;
                ASSERT_EQ(a.position[row].a, b.position[row].a) << step;
                ASSERT_EQ(a.velocity[row].v, b.velocity[row].v) << step;
            }
        }
        EXPECT_GE(step, 10);
        EXPECT_GE(changes, 4);
    }
}

TEST(IslandSubsteps, ABodyThatTakesAnothersPlaceStartsWithoutItsDemand) {
    World world({0.0f, -10.0f});
    Fill(world, Hard::chain, {.easy = false});
    for (int i = 0; i < 60; ++i) world.Step(frame, tight);
    Body* last = world.GetBodyList();
    const BodyIndex row = IndexOf(*last);
    ASSERT_GT(world.GetState().bodies.demand[row].wanted, 0.0f);
    world.DestroyBody(last);
    ASSERT_EQ(AddBody(world, dynamicBody, {100.0f, 100.0f})->GetIndex(), ToInt(row));
    EXPECT_EQ(world.GetState().bodies.demand[row].wanted, 0.0f);
    EXPECT_EQ(world.GetState().bodies.demand[row].substeps, 0);
}

TEST(IslandSubsteps, RoundUpToTwoNumbersAnOctaveWithinTheRange) {
    const Tolerance wide{.leastSubsteps = 1, .mostSubsteps = std::numeric_limits<int>::max()};
    std::set<int> numbers;
    for (float wanted = 1.0f; wanted <= 4096.0f; wanted += 0.25f) {
        const int taken = RoundUpSubsteps(wanted, wide);
        ASSERT_GE(static_cast<float>(taken), wanted);
        ASSERT_LE(taken, wanted <= 2.0f ? 2.0f : 1.5f * wanted);
        numbers.insert(taken);
    }
    std::set<int> expected;
    for (int power = 1; power <= 4096; power *= 2) expected.insert(power), expected.insert(std::max(1, power / 4 * 3));
    EXPECT_EQ(numbers, expected);
    EXPECT_EQ(RoundUpSubsteps(2147483648.0f, wide), std::numeric_limits<int>::max());
    EXPECT_EQ(RoundUpSubsteps(3.0f, {.leastSubsteps = 5, .mostSubsteps = 7}), 5);
    EXPECT_EQ(RoundUpSubsteps(5.5f, {.leastSubsteps = 5, .mostSubsteps = 7}), 6);
    EXPECT_EQ(RoundUpSubsteps(6.5f, {.leastSubsteps = 5, .mostSubsteps = 7}), 7);
}

/// Errors scale with the world.
TEST(IslandSubsteps, AWorldOfMillimetresTakesWhatAWorldOfMetresTakes) {
    const auto takes = [](float scale) {
        WorldDef def;
        def.gravity = {0.0f, -10.0f * scale};
        def.lengthScale = scale;
        World world(def);
        AddBox(AddBody(world, staticBody, {0.0f, -0.5f * scale}), 20.0f * scale, 0.5f * scale, 0.0f);
        for (int i = 0; i < 20; ++i) {
            AddBox(AddBody(world, dynamicBody, {0.0f, (0.5f + static_cast<float>(i)) * scale}), 0.5f * scale,
                   0.5f * scale, 1.0f);
        }
        int64_t sum = 0;
        for (int i = 0; i < 100; ++i) sum += world.Step(frame, Tolerance{.overlap = 0.008f * scale}).bodySubsteps;
        return static_cast<double>(sum);
    };
    EXPECT_NEAR(takes(1.0f / 1024.0f), takes(1.0f), 0.02 * takes(1.0f));
}

}  // namespace
}  // namespace scree::test
