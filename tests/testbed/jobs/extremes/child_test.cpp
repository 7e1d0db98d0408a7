// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The command with its processes: a case that crashes and one that hangs get grade 0 and do not keep the others from
// theirs.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "testbed/base/errors.h"
#include "testbed/engines/engine_list.h"
#include "testbed/jobs/extremes/report.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

std::vector<ExtremeResult> ReadLines(const std::string& text) {
    std::vector<ExtremeResult> results;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        results.push_back(ExtremeResultFromJson(nlohmann::ordered_json::parse(line)));
    }
    return results;
}

TEST(ExtremesCommand, ACrashIsGradeZeroWithItsSignal) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("extremes -g test-crash -o out --json lines.jsonl");
    ASSERT_EQ(result.exitCode, 1) << "one of ours broke\n" << result.output;
    const std::vector<ExtremeResult> results = ReadLines(folder.Read("lines.jsonl"));
    ASSERT_GE(results.size(), 2u);
    for (const ExtremeResult& one : results) {
        EXPECT_EQ(one.verdict.grade, Grade::abort) << one.setting;
        EXPECT_EQ(one.ending.signal, 6) << one.setting;
        EXPECT_FALSE(one.ending.timedOut);
    }
    EXPECT_NE(result.output.find("below 3: test-crash, scree 8/3: 0 (ended by signal 6"), std::string::npos)
        << result.output;
}

TEST(ExtremesCommand, LinesThatAnEngineWritesAreNoCrash) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("extremes -g test-chatter -o out --json lines.jsonl");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::vector<ExtremeResult> results = ReadLines(folder.Read("lines.jsonl"));
    ASSERT_GE(results.size(), 2u);
    for (const ExtremeResult& one : results) EXPECT_EQ(one.verdict.grade, Grade::accurate) << one.setting;
}

TEST(ExtremesCommand, AHangIsGradeZeroAtTheLimit) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("extremes -g test-hang -o out --json lines.jsonl --limit 1");
    ASSERT_EQ(result.exitCode, 1) << result.output;
    for (const ExtremeResult& one : ReadLines(folder.Read("lines.jsonl"))) {
        EXPECT_EQ(one.verdict.grade, Grade::abort) << one.setting;
        EXPECT_TRUE(one.ending.timedOut) << one.setting;
    }
}

TEST(ExtremesCommand, RunsCasesAndWritesTheMatrix) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run(
        "extremes --quick -g '^(light-on-heavy-1e0|bad-density|chain-10-loaded)$' -o out --json lines.jsonl");
    ASSERT_EQ(result.exitCode, 0) << result.output;
    const std::vector<ExtremeResult> results = ReadLines(folder.Read("lines.jsonl"));
    // Two scenes in all engines, and bad input in those that have code for it.
    ASSERT_EQ(results.size(), IsBuilt("box2d3") ? 4u + 4u + 3u : 3u + 3u + 3u);
    EXPECT_NE(result.output.find(std::to_string(results.size()) + " runs: 3 cases, "), std::string::npos);
    for (const ExtremeResult& one : results) {
        if (one.name == "light-on-heavy-1e0") {
            EXPECT_EQ(one.verdict.grade, Grade::accurate) << one.setting;
        }
        if (one.setting.starts_with("scree")) {
            EXPECT_GE(one.verdict.grade, Grade::survives) << one.name;
        }
    }
    const std::string csv = folder.Read("out/cases.csv"), page = folder.Read("out/index.html");
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), 1 + results.size());
    EXPECT_NE(page.find("light-on-heavy-1e0"), std::string::npos);
    EXPECT_NE(page.find("data:image/svg+xml"), std::string::npos);
    const ProgramResult from = folder.Run("extremes --from lines.jsonl -o again");
    EXPECT_EQ(from.exitCode, 0) << from.output;
    EXPECT_EQ(folder.Read("again/cases.csv"), csv);
}

TEST(ExtremesCommand, StandingTakesItsGroupsAtEveryMark) {
    const ScratchFolder folder;
    const ProgramResult list = folder.Run("extremes --standing --list");
    ASSERT_EQ(list.exitCode, 0) << list.output;
    std::size_t asked = 0;
    for (const ExtremeCase& one : GetExtremeCases()) {
        const bool stands =
            one.group == "built flush" || one.group == "loads" || one.group == "loops" || one.group == "machines";
        asked += stands ? 1 : 0;
        EXPECT_EQ(
            list.output.find("\n" + one.name + " ") != std::string::npos || list.output.starts_with(one.name + " "),
            stands)
            << one.name;
    }
    EXPECT_GE(asked, 40u);
    const ProgramResult run =
        folder.Run("extremes --standing --quick -g '^flush-pyramid-15$' -o out --json lines.jsonl");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    std::vector<std::string> settings;
    for (const ExtremeResult& one : ReadLines(folder.Read("lines.jsonl"))) settings.push_back(one.setting);
    std::vector<std::string> marks = {"scree game",     "scree fine", "scree precise",
                                      "scree tolerant", "scree si",   "box2d 8/3"};
    if (IsBuilt("box2d3")) marks.push_back("box2d3 soft 4");
    std::ranges::sort(settings);
    std::ranges::sort(marks);
    EXPECT_EQ(settings, marks);
    const ProgramResult one =
        folder.Run("extremes --standing --quick -g '^flush-pyramid-15$' --engines scree -o out --json one.jsonl");
    ASSERT_EQ(one.exitCode, 0) << one.output;
    EXPECT_EQ(ReadLines(folder.Read("one.jsonl")).size(), 1u);
}

TEST(ExtremesCommand, RefusesWhatItCannotMean) {
    const ScratchFolder folder;
    EXPECT_EQ(folder.Run("extremes --quick --full").exitCode, 2);
    EXPECT_EQ(folder.Run("extremes -g nonesuch").exitCode, 2);
    EXPECT_EQ(folder.Run("extremes -g '['").exitCode, 2);
    EXPECT_EQ(folder.Run("extremes --from missing.jsonl").exitCode, 4);
    const ProgramResult list = folder.Run("extremes --list");
    EXPECT_EQ(list.exitCode, 0);
    EXPECT_EQ(std::ranges::count(list.output, '\n'),
              std::ranges::count(GetExtremeCases(), false, &ExtremeCase::hidden));
    EXPECT_EQ(list.output.find("test-hang"), std::string::npos);
}

}  // namespace
}  // namespace testbed
