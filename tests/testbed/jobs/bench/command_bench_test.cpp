// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree bench` end to end on small scenes: rows, counts, files, shards, and wrong usage. No time is asserted.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "testbed/base/case_lines.h"
#include "testbed/base/errors.h"
#include "testbed/base/new_file.h"
#include "testbed/engines/engine_run.h"
#include "testbed/jobs/bench/object_bytes.h"
#include "testbed/jobs/bench/plan.h"
#include "testbed/jobs/bench/row.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

BenchResult RunSmall(const std::string& scene, int size, const BenchEffort& effort) {
    return RunBenchCase({MakeInput(*scenes::Find(scene), size), ParsePanes("scree,box2d", {}, comparisonBase)}, effort,
                        [](int) {});
}

TEST(Bench, CountsTheSameWorkInBothEnginesWhileNothingCollides) {
    // 20 tiles a side: 210 boxes above a ground of 2000, which they do not reach within 9 steps; neighbours do not
    // touch.
    int advanced = 0;
    const BenchResult result =
        RunBenchCase({MakeInput(*scenes::Find("tiles"), 20), ParsePanes("scree,box2d", {}, comparisonBase)},
                     {.repeats = 2, .maxSteps = 9}, [&](int count) { advanced += count; });
    EXPECT_EQ(advanced, 2 * 2 * 9);
    ASSERT_EQ(result.rows.size(), 2u);
    ASSERT_EQ(result.timing.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const BenchRow& row = result.rows[i];
        EXPECT_EQ(row.steps, 9);
        EXPECT_EQ(row.movers, 210);
        EXPECT_EQ(row.fixtures, 2210);
        EXPECT_EQ(row.awakeBodySteps, 9 * 210);
        EXPECT_EQ(row.touchingSum, 0);
        EXPECT_EQ(row.voidReason, "");
        EXPECT_TRUE(row.complete);
        ASSERT_EQ(result.timing[i].steps.size(), 9u);
        double total = 0;
        for (const StepRecord& record : result.timing[i].steps) total += record.times.step;
        EXPECT_DOUBLE_EQ(row.totalMs, total);
        // Stages are parts of a step; 1e-4 ms per step for the float they are stored in.
        const StageTotals& s = row.stages;
        EXPECT_LE(s.broadPhase + s.narrowPhase + s.islands + s.solver + s.continuous, row.totalMs + 9e-4);
        EXPECT_GT(row.cpuMs, 0.0);
    }
    EXPECT_EQ(result.rows[0].engine, "scree");
}

TEST(Bench, CountsAwakeBodiesOfBothEnginesAlike) {
    // Boxes that come to rest and sleep, and boxes that enter during the run.
    for (const auto& [scene, size, steps] : {std::tuple("box-stack", 1, 120), std::tuple("tumbler", 50, 60)}) {
        const BenchResult result = RunSmall(scene, size, {.maxSteps = steps});
        const auto ours = static_cast<double>(result.rows[0].awakeBodySteps);
        const auto theirs = static_cast<double>(result.rows[1].awakeBodySteps);
        EXPECT_GT(ours, 0.0);
        // The same 0.5 s of rest: a step or two of difference in when a body falls asleep.
        EXPECT_NEAR(ours, theirs, 0.02 * theirs) << scene;
        EXPECT_NEAR(static_cast<double>(result.rows[0].touchingSum), static_cast<double>(result.rows[1].touchingSum),
                    0.2 * static_cast<double>(result.rows[1].touchingSum))
            << scene;
    }
}

TEST(Bench, RepeatsAndSlicesDoNotChangeTheState) {
    const BenchResult once = RunSmall("n2", 25, {.maxSteps = 20});
    const BenchResult thrice = RunSmall("n2", 25, {.repeats = 3, .maxSteps = 20});
    const scenes::Scene scene = scenes::Build("n2", 25);
    const std::unique_ptr<EngineRun> alone = MakeRun(scene, MakeSpec("scree", likeBox2dPreset));
    for (int i = 0; i < 20; ++i) alone->Step();
    Snapshot snapshot;
    alone->Capture(snapshot);
    EXPECT_EQ(once.rows[0].stateHash, snapshot.stateHash);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(once.rows[i].stateHash, thrice.rows[i].stateHash);
        EXPECT_EQ(once.rows[i].contactSum, thrice.rows[i].contactSum);
    }
    EXPECT_NE(once.rows[0].stateHash, once.rows[1].stateHash);
}

TEST(Bench, StopsAtTheTimeLimit) {
    // No machine does a million steps in a microsecond, nor fails to do one.
    const BenchResult result = RunSmall("n2", 25, {.timeLimitS = 1e-6});
    for (const BenchRow& row : result.rows) {
        EXPECT_FALSE(row.complete);
        EXPECT_EQ(row.steps, 1);
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Bench, BytesPerObjectOfBox2dAreThoseOfItsClasses) {
    const ObjectBytes bytes = MeasureObjectBytes("box2d");
    // Its block allocator serves these sizes from chunks of 16 KiB: at most one size class above the class's own size,
    // and rounding by a chunk over 4096 objects. A fixture adds shape, proxy array and two tree nodes; the array of
    // nodes doubles, so up to four of 40 bytes.
    EXPECT_NEAR(bytes.body, 192 + 44, 16) << "with the arrays of an island for one step";
    EXPECT_GT(bytes.fixture, 72 + 152 + 28);
    EXPECT_LT(bytes.fixture, 72 + 160 + 32 + 4 * 40 + 32);
    EXPECT_GE(bytes.contact, 208);
    EXPECT_LT(bytes.contact, 208 + 400) << "with what the solver takes from the heap for a step";
    EXPECT_GE(bytes.joint, 200);
    EXPECT_NE(FormatObjectBytes("box2d", bytes).find("joint"), std::string::npos);
}
#endif

TEST(BenchPlan, TheSuiteIsTheDefaultAndSizesAreChecked) {
    BenchArguments arguments;
    EXPECT_EQ(MakeBenchPlan(arguments).cases.size(), 14u);
    arguments.targets = true;
    EXPECT_EQ(MakeBenchPlan(arguments).cases.size(), 17u) << "three scenes with continuous collision on";
    EXPECT_EQ(MakeBenchPlan(arguments).cases.front().panes.size(), 5u) << "two solvers at one and two threads, Box2D";
    arguments.targets = false;
    EXPECT_EQ(MakeBenchPlan(arguments).cases.front().panes.size(), 3u);
    arguments.scenes = {"n2", "big-mobile", "n2"};
    arguments.sizes = "sweep";
    const BenchPlan plan = MakeBenchPlan(arguments);
    ASSERT_EQ(plan.cases.size(), 30u + 11u) << "25:750:25 and 1:11:1";
    EXPECT_EQ(plan.cases[0].scene.size, 25);
    EXPECT_EQ(plan.cases[29].scene.size, 750);
    const auto sizesOf = [&arguments](const char* scene, const char* sizes) {
        arguments.scenes = {scene};
        arguments.sizes = sizes;
        std::vector<int> chosen;
        for (const BenchCase& one : MakeBenchPlan(arguments).cases) chosen.push_back(one.scene.size);
        return chosen;
    };
    EXPECT_EQ(sizesOf("tiles", "sweep@4"), (std::vector{60, 100, 160, 200})) << "of 20:200:20";
    EXPECT_EQ(sizesOf("tumbler", "sweep@1"), std::vector{1000});
    EXPECT_EQ(sizesOf("big-mobile", "sweep@99"), sizesOf("big-mobile", "sweep"));
    arguments.scenes = {"slow-explosion"};
    arguments.sizes = "10000,1000000";
    EXPECT_EQ(MakeBenchPlan(arguments).cases.back().scene.size, 1'000'000) << "above the sweep is legal";
    for (const char* sizes : {"0", "abc", "10,", "99999999", "sweep@", "sweep@0", "sweep@x"}) {
        arguments.sizes = sizes;
        EXPECT_THROW((void)MakeBenchPlan(arguments), UsageError) << sizes;
    }
}

TEST(BenchPlan, APresetLeavesTheChosenSolverAndThreads) {
    BenchArguments arguments;
    arguments.scenes = {"n2"};
    arguments.settings.engines = "scree";
    arguments.solver = "soft@6";
    arguments.threads = "2";
    arguments.settings.typed = {{"preset=own", "--set preset=own"}, {"sleeping=off", "--set sleeping=off"}};
    const BenchPlan plan = MakeBenchPlan(arguments);
    ASSERT_EQ(plan.cases.front().panes.size(), 1u);
    const RunSpec& spec = plan.cases.front().panes.front().spec;
    EXPECT_EQ(spec.solver, Solver(SoftStep{6}));
    EXPECT_EQ(spec.threads, 2);
    EXPECT_TRUE(spec.continuous) << "of the preset";
    EXPECT_FALSE(spec.sleeping);
}

TEST(BenchPlan, ACommaMayStandInASolverAndBetweenSolvers) {
    BenchArguments arguments;
    arguments.scenes = {"n2"};
    arguments.settings.engines = "scree";
    arguments.solver = "si@4,2,soft@6,si@5/1";
    arguments.threads = "1,2";
    std::vector<Solver> solvers;
    const BenchPlan plan = MakeBenchPlan(arguments);
    for (const Pane& pane : plan.cases.front().panes) {
        if (pane.spec.threads == 1) solvers.push_back(pane.spec.solver);
    }
    EXPECT_EQ(plan.cases.front().panes.size(), 6u);
    EXPECT_EQ(solvers, (std::vector<Solver>{SequentialImpulses{Iterations{4, 2}}, SoftStep{6},
                                            SequentialImpulses{Iterations{5, 1}}}));
    for (const char* illegal : {"si@4,2,3", "3,si", "si@4,", "soft@6,2"}) {
        arguments.solver = illegal;
        EXPECT_THROW((void)MakeBenchPlan(arguments), UsageError) << illegal;
    }
}

TEST(BenchCommand, WritesWhatItPrints) {
    const ScratchFolder folder;
    const ProgramResult result =
        folder.Run("bench n2 --sizes 25,50 --steps 5 --threads 1 --json rows.json -o out --targets --time-limit 60");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_NE(result.output.find("bytes a body"), std::string::npos);
    EXPECT_NE(result.output.find("0 missed"), std::string::npos) << "five steps judge nothing";
    for (const char* file : {"out/bench.csv", "out/index.html", "out/plots/n2-total.svg", "out/plots/n2-total.png",
                             "out/plots/n2-steps.svg", "rows.json"}) {
        EXPECT_TRUE(folder.Has(file)) << file;
    }
    const std::vector<BenchRow> rows = ReadBenchRows("rows.json", folder.Read("rows.json"));
    ASSERT_EQ(rows.size(), 6u) << "two sizes, both solvers and Box2D";
    EXPECT_EQ(folder.Read("out/bench.csv"), WriteBenchCsv(rows));
    EXPECT_EQ(rows[5].size, 50);
    EXPECT_EQ(rows[4].solver, "soft");
    EXPECT_EQ(rows[5].engine, "box2d");
    EXPECT_NE(rows[3].stateHash, rows[4].stateHash) << "two solvers";
    const ProgramResult again = folder.Run("bench --from rows.json --csv again.csv");
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_EQ(folder.Read("again.csv"), folder.Read("out/bench.csv"));
}

TEST(BenchCommand, NeighboursEndWithIt) {
    // One that went on would hold the output open, for whose end the test waits.
    const ScratchFolder folder;
    const std::string command = "bench n2 --sizes 5 --steps 2 --repeat 1 --engines scree --solver si ";
    const ProgramResult result = folder.Run(command + "--neighbours 3");
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(folder.Run("bench nothing-like-that --neighbours 2").exitCode, 2) << "also after an error";
    for (const char* refused : {"--neighbours -1", "--neighbours 1025", "--neighbours x",
                                "--neighbours 1 --from r.json", "--neighbours 1 --cores 8"}) {
        EXPECT_EQ(folder.Run(command + refused).exitCode, 2) << refused;
    }
}

TEST(BenchCommand, ShardsTakeEveryOtherCase) {
    const ScratchFolder folder;
    const std::string command = "bench n2 --sizes 5,10,15 --steps 2 --engines scree --solver si --shard ";
    ASSERT_EQ(folder.Run(command + "1/2 --json 1.json").exitCode, 0);
    ASSERT_EQ(folder.Run(command + "2/2 --json 2.json").exitCode, 0);
    const auto sizes = [&](const char* file) {
        std::vector<int> list;
        for (const BenchRow& row : ReadBenchRows(file, folder.Read(file))) list.push_back(row.size);
        return list;
    };
    EXPECT_EQ(sizes("1.json"), (std::vector{5, 15}));
    EXPECT_EQ(sizes("2.json"), (std::vector{10}));
}

TEST(BenchCommand, AMissEndsInOne) {
    const ScratchFolder folder;
    BenchRow row;
    row.scene = "n2";
    row.size = 750;
    row.steps = 100;
    row.engine = "scree";
    row.solver = "si";
    row.totalMs = row.maxMs = row.createMs = 1;
    BenchRow box2d = row;
    box2d.engine = "box2d";
    box2d.peakBytes = 1;
    CaseLines lines("bench", 1);
    for (const BenchRow& one : {row, box2d}) lines.Add(0, MakeBenchJson(one));
    WriteTextFile(folder.GetPath() / "rows.json", lines.GetText());
    const ProgramResult result = folder.Run("bench --targets --from rows.json");
    EXPECT_EQ(result.exitCode, 1) << result.output;
    EXPECT_NE(result.output.find("MISSED"), std::string::npos);
}

TEST(BenchCommand, WrongUsageIsNamed) {
    const ScratchFolder folder;
    for (const auto& [arguments, word] :
         {std::pair("bench nosuch", "nosuch"), std::pair("bench n2 --sizes 1,x", "--sizes 1,x"),
          std::pair("bench n2 --solver magic", "magic"), std::pair("bench n2 --threads 0", "--threads 0"),
          std::pair("bench n2 --repeat 0", "--repeat 0"), std::pair("bench n2 --shard 3/2", "--shard 3/2"),
          std::pair("bench n2 --engines box3d", "box3d"), std::pair("bench n2 --broad-phase bhv-sah", "bvh-sah")}) {
        const ProgramResult result = folder.Run(arguments);
        EXPECT_EQ(result.exitCode, 2) << arguments;
        EXPECT_NE(result.output.find(word), std::string::npos) << result.output;
    }
    EXPECT_EQ(folder.Run("bench --from nosuch.json").exitCode, 4);
}

}  // namespace
}  // namespace testbed
