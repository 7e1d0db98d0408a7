// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The verdicts on the speed to reach, on made-up rows: met, missed, void, not measured, and what a stopped run proves.

#include "testbed/jobs/bench/targets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/catalog.h"

namespace testbed {
namespace {

/// A full run; Box2D's takes what it took on the machine of the table, ours `speed` times less than needed.
BenchRow MakeRow(const SpeedTarget& target, const std::string& engine, int threads = 1, double speed = 1) {
    const scenes::SceneInfo& info = *scenes::Find(target.scene);
    const bool isOurs = engine == "scree";
    BenchRow row;
    row.scene = target.scene;
    row.size = info.defaultSize;
    row.steps = info.steps;
    row.engine = engine;
    row.solver = "si";
    row.threads = threads;
    row.movers = 6000;
    row.totalMs =
        isOurs ? target.boxTwoDMs / (threads == 1 ? target.ratioOne : target.ratioTwo) / speed : target.boxTwoDMs;
    row.maxMs = isOurs ? target.worstMs / speed : target.boxTwoDWorstMs;
    row.p99Ms = row.maxMs;
    row.createMs = isOurs ? 1 / speed : 1;
    row.peakBytes = isOurs ? 1000 : 2000;
    row.awakeBodySteps = 6'000'000;
    row.touchingSum = 1'000'000;
    row.contactSum = 2'000'000;
    return row;
}

const SpeedTarget& TargetOf(std::string_view scene) {
    return *std::ranges::find(SpeedTargets(), scene, &SpeedTarget::scene);
}

TargetResult Find(const std::vector<TargetResult>& results, std::string_view law, std::string_view scene) {
    for (const TargetResult& result : results) {
        if (result.law == law && result.scene == scene) return result;
    }
    ADD_FAILURE() << "no result for " << law << " in " << scene;
    return {};
}

Verdict VerdictOf(const std::vector<BenchRow>& rows, std::string_view law, std::string_view scene) {
    return Find(JudgeTargets(rows), law, scene).verdict;
}

TEST(Targets, TheTableNamesScenesOfTheSuiteOnce) {
    EXPECT_EQ(SpeedTargets().size(), 14u);
    for (const SpeedTarget& target : SpeedTargets()) {
        const scenes::SceneInfo* info = scenes::Find(target.scene);
        ASSERT_NE(info, nullptr) << target.scene;
        EXPECT_TRUE(info->sweep && !info->isClassic) << target.scene;
        EXPECT_EQ(&TargetOf(target.scene), &target) << "twice";
        EXPECT_GE(target.ratioTwo, target.ratioOne) << target.scene;
        EXPECT_LT(target.worstMs, target.boxTwoDWorstMs) << target.scene;
    }
}

TEST(Targets, AreMetJustAboveAndMissedJustBelow) {
    const SpeedTarget& tiles = TargetOf("tiles");
    for (const double speed : {1.01, 0.99}) {
        const Verdict expected = speed > 1 ? Verdict::met : Verdict::missed;
        const std::vector<BenchRow> rows = {MakeRow(tiles, "scree", 1, speed), MakeRow(tiles, "box2d")};
        EXPECT_EQ(VerdictOf(rows, "total, 1 thread", "tiles"), expected);
        EXPECT_EQ(VerdictOf(rows, "worst step, ms", "tiles"), expected);
        EXPECT_EQ(VerdictOf(rows, "creation, ms", "tiles"), expected);
        EXPECT_EQ(VerdictOf(rows, "peak memory, MB", "tiles"), Verdict::met);
        EXPECT_EQ(VerdictOf(rows, "total, 2 threads", "tiles"), Verdict::notMeasured);
        EXPECT_EQ(HasMiss(JudgeTargets(rows)), speed < 1);
    }
}

TEST(Targets, AreRatiosSoThatTheMachineDoesNotMatter) {
    // Everything ten times slower: the same verdicts, the gates of the stages included.
    const SpeedTarget& tiles = TargetOf("tiles");
    std::vector<BenchRow> rows = {MakeRow(tiles, "scree", 1, 1.1), MakeRow(tiles, "box2d")};
    rows[0].stages.narrowPhase = 0.9 * 25e-6 * 2'000'000;                       // 25 ns a contact
    rows[0].stages.broadPhase = 1.1 * (30e-6 * 6'000'000 + 14e-6 * 2'000'000);  // above 30 ns a box, 14 ns a contact
    rows[0].stages.solver = 0.9 * (55e-6 * 1'000'000 + 15e-6 * 6'000'000);
    for (const double slowness : {1.0, 10.0}) {
        std::vector<BenchRow> slow = rows;
        for (BenchRow& row : slow) {
            for (double* ms : {&row.totalMs, &row.maxMs, &row.p99Ms, &row.createMs, &row.stages.narrowPhase,
                               &row.stages.broadPhase, &row.stages.solver}) {
                *ms *= slowness;
            }
        }
        EXPECT_EQ(VerdictOf(slow, "total, 1 thread", "tiles"), Verdict::met);
        EXPECT_EQ(VerdictOf(slow, "worst step, ms", "tiles"), Verdict::met);
        EXPECT_EQ(VerdictOf(slow, "gate: narrow phase, ms", "tiles"), Verdict::met);
        EXPECT_EQ(VerdictOf(slow, "gate: broad phase, ms", "tiles"), Verdict::missed);
        EXPECT_EQ(VerdictOf(slow, "gate: islands and solver, ms", "tiles"), Verdict::met);
    }
}

TEST(Targets, AVoidRatioIsNeitherMetNorIgnored) {
    const SpeedTarget& n2 = TargetOf("n2");
    std::vector<BenchRow> rows = {MakeRow(n2, "scree", 1, 2), MakeRow(n2, "box2d")};
    rows[0].voidReason = "touching contacts differ by 30 %";
    const TargetResult result = Find(JudgeTargets(rows), "total, 1 thread", "n2");
    EXPECT_EQ(result.verdict, Verdict::isVoid);
    EXPECT_NE(result.note.find("30 %"), std::string::npos);
    EXPECT_TRUE(HasMiss(JudgeTargets(rows)));
    EXPECT_NE(FormatTargets(JudgeTargets(rows)).find("void"), std::string::npos);
    // A second solver that did the same work counts instead, even if it is slower.
    BenchRow soft = MakeRow(n2, "scree", 1, 1.5);
    soft.solver = "soft";
    rows.push_back(soft);
    const TargetResult other = Find(JudgeTargets(rows), "total, 1 thread", "n2");
    EXPECT_EQ(other.verdict, Verdict::met);
    EXPECT_EQ(other.note, "soft");
}

TEST(Targets, TheFasterSolverCounts) {
    const SpeedTarget& n2 = TargetOf("n2");
    std::vector<BenchRow> rows = {MakeRow(n2, "scree", 1, 0.5), MakeRow(n2, "scree", 1, 2), MakeRow(n2, "box2d")};
    rows[1].solver = "soft";
    EXPECT_EQ(VerdictOf(rows, "total, 1 thread", "n2"), Verdict::met);
}

TEST(Targets, AreThreeTimesTheFastestRivalOfTheRun) {
    const SpeedTarget& n2 = TargetOf("n2");
    std::vector<BenchRow> rows = {MakeRow(n2, "scree"), MakeRow(n2, "scree", 2), MakeRow(n2, "box2d")};
    EXPECT_EQ(VerdictOf(rows, "best rival, 1 thread", "n2"), Verdict::notMeasured) << "Box2D 2.4 is one of several";
    rows.push_back(MakeRow(n2, "box2d3"));
    for (const double ratio : {2.9, 3.1}) {
        rows[3].totalMs = ratio * rows[0].totalMs;
        rows[1].totalMs = 2 * rows[0].totalMs;  // with two threads ours is slower, and the rival has no such row
        const Verdict expected = ratio > 3 ? Verdict::met : Verdict::missed;
        EXPECT_EQ(VerdictOf(rows, "best rival, 1 thread", "n2"), expected);
        const TargetResult two = Find(JudgeTargets(rows), "best rival, 2 threads", "n2");
        EXPECT_EQ(two.verdict, Verdict::missed);
        EXPECT_NEAR(two.measured, ratio / 2, 1e-9);
        EXPECT_EQ(two.note, "si, against box2d3");
    }
    // A rival with two threads counts with two threads alone; the old Box2D counts if it is the faster one.
    rows.push_back(MakeRow(n2, "box2d3", 2));
    rows[4].totalMs = rows[0].totalMs;
    EXPECT_EQ(VerdictOf(rows, "best rival, 1 thread", "n2"), Verdict::met);
    EXPECT_NEAR(Find(JudgeTargets(rows), "best rival, 2 threads", "n2").measured, 0.5, 1e-9);
    rows[2].totalMs = 0.25 * rows[0].totalMs;
    const TargetResult old = Find(JudgeTargets(rows), "best rival, 1 thread", "n2");
    EXPECT_NEAR(old.measured, 0.25, 1e-9);
    EXPECT_EQ(old.note, "si, against box2d");
}

TEST(Targets, AStoppedRunProvesWhatItsBoundProves) {
    const SpeedTarget& n2 = TargetOf("n2");
    const auto verdict = [&](double speed, bool oursComplete, bool theirsComplete) {
        std::vector<BenchRow> rows = {MakeRow(n2, "scree", 1, speed), MakeRow(n2, "box2d")};
        rows[0].complete = oursComplete;
        rows[1].complete = theirsComplete;
        return VerdictOf(rows, "total, 1 thread", "n2");
    };
    EXPECT_EQ(verdict(2, true, false), Verdict::met) << "Box2D would have taken even longer";
    EXPECT_EQ(verdict(0.5, true, false), Verdict::notMeasured);
    EXPECT_EQ(verdict(2, false, true), Verdict::missed);
}

TEST(Targets, OtherSizesAndShortRunsJudgeNothing) {
    const SpeedTarget& n2 = TargetOf("n2");
    std::vector<BenchRow> rows = {MakeRow(n2, "scree"), MakeRow(n2, "box2d")};
    for (BenchRow& row : rows) row.size = 10;
    for (const TargetResult& result : JudgeTargets(rows)) EXPECT_EQ(result.verdict, Verdict::notMeasured) << result.law;
    rows = {MakeRow(n2, "scree"), MakeRow(n2, "box2d")};
    for (BenchRow& row : rows) row.steps = 5;
    for (const TargetResult& result : JudgeTargets(rows)) EXPECT_EQ(result.verdict, Verdict::notMeasured) << result.law;
}

TEST(Targets, TwoThreadsMustPayWhereManyBodiesMove) {
    const SpeedTarget& mixed = TargetOf("mixed");
    std::vector<BenchRow> rows = {MakeRow(mixed, "scree", 1), MakeRow(mixed, "scree", 2), MakeRow(mixed, "box2d")};
    for (const int movers : {2001, 2000}) {
        rows[0].movers = rows[1].movers = movers;
        rows[1].totalMs = rows[0].totalMs / 1.4;
        EXPECT_EQ(VerdictOf(rows, "2 threads against 1", "mixed"), movers > 2000 ? Verdict::missed : Verdict::met);
        rows[1].totalMs = rows[0].totalMs * 1.1;
        EXPECT_EQ(VerdictOf(rows, "2 threads against 1", "mixed"), Verdict::missed);
    }
}

TEST(Targets, ContinuousCollisionMayCostThreeTenths) {
    const SpeedTarget& mixed = TargetOf("mixed");
    std::vector<BenchRow> rows = {MakeRow(mixed, "scree"), MakeRow(mixed, "scree"), MakeRow(mixed, "box2d")};
    rows[1].continuous = true;
    EXPECT_TRUE(IsContinuousTarget("mixed"));
    EXPECT_FALSE(IsContinuousTarget("tiles"));
    rows[1].totalMs = 1.29 * rows[0].totalMs;
    EXPECT_EQ(VerdictOf(rows, "continuous on against off", "mixed"), Verdict::met);
    rows[1].totalMs = 1.31 * rows[0].totalMs;
    EXPECT_EQ(VerdictOf(rows, "continuous on against off", "mixed"), Verdict::missed);
}

TEST(Targets, TheMeanNeedsEveryScene) {
    std::vector<BenchRow> rows;
    for (const SpeedTarget& target : SpeedTargets()) {
        rows.push_back(MakeRow(target, "box2d"));
        rows.push_back(MakeRow(target, "scree"));
        rows.back().totalMs = target.boxTwoDMs / 20;
    }
    const TargetResult mean = Find(JudgeTargets(rows), "geometric mean, 1 thread", "");
    EXPECT_EQ(mean.verdict, Verdict::met);
    EXPECT_NEAR(mean.measured, 20, 1e-9);
    rows.back().totalMs *= 1e6;  // one scene a million times slower: 20 / 10^(6/14)
    EXPECT_EQ(VerdictOf(rows, "geometric mean, 1 thread", ""), Verdict::missed);
    rows.pop_back();
    EXPECT_EQ(VerdictOf(rows, "geometric mean, 1 thread", ""), Verdict::notMeasured);
}

TEST(Targets, LargeWorldsMayCostTheLogarithm) {
    const SpeedTarget& tiles = TargetOf("tiles");
    std::vector<BenchRow> rows = {MakeRow(tiles, "scree"), MakeRow(tiles, "scree")};
    rows[0].movers = 10'000;
    rows[1].movers = 1'000'000;
    rows[1].size = 1413;
    rows[0].nsPerBodyStep = 100;
    const std::string law = "ns per body, 1000000 bodies against 10000";
    rows[1].nsPerBodyStep = 149;  // ln 10^6 / ln 10^4 = 1.5
    EXPECT_EQ(VerdictOf(rows, law, "tiles"), Verdict::met);
    rows[1].nsPerBodyStep = 151;
    EXPECT_EQ(VerdictOf(rows, law, "tiles"), Verdict::missed);
}

}  // namespace
}  // namespace testbed
