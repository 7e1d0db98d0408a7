// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two builds side by side: the interval of a median against its definition, and the command with this build as the
// other.

#include "testbed/jobs/bench/against.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

TEST(Against, TheIntervalHoldsTheTrueMedianInNineteenOfTwentyDraws) {
    std::mt19937 random(std::random_device{}());
    std::lognormal_distribution<double> draw(0.0, 0.7);  // its median is 1
    for (const std::size_t n : {6, 7, 9, 10, 15, 30}) {
        int inside = 0;
        constexpr int trials = 4000;
        for (int trial = 0; trial < trials; ++trial) {
            std::vector<double> values(n);
            for (double& value : values) value = draw(random);
            const MedianInterval interval = FindMedianInterval(values);
            ASSERT_TRUE(interval.isSure);
            ASSERT_LE(interval.low, interval.median);
            ASSERT_LE(interval.median, interval.high);
            inside += interval.low <= 1.0 && 1.0 <= interval.high;
        }
        // Five standard deviations of the count below 95 %.
        EXPECT_GT(inside, trials * 0.95 - 5.0 * std::sqrt(trials * 0.95 * 0.05)) << n;
    }
}

TEST(Against, TheIntervalOfNineLeavesOutTheOutermostValues) {
    const std::vector<double> values{9, 1, 8, 2, 7, 3, 6, 4, 5};
    const MedianInterval interval = FindMedianInterval(values);
    EXPECT_EQ(interval.low, 2);
    EXPECT_EQ(interval.median, 5);
    EXPECT_EQ(interval.high, 8);
    const MedianInterval few = FindMedianInterval(std::vector<double>{3, 1, 2});
    EXPECT_FALSE(few.isSure);
    EXPECT_EQ(few.low, 1);
    EXPECT_EQ(few.high, 3);
}

TEST(Against, OnlyAWholeIntervalBelowIsSlower) {
    AgainstRow row;
    row.ratio = {0.95, 0.97, 0.99, true};
    EXPECT_FALSE(IsSlower(row, 0.98));
    EXPECT_TRUE(IsSlower(row, 0.995));
}

TEST(Against, TheSameBuildComesToTheSameStates) {
    const ScratchFolder folder;
    const ProgramResult result =
        folder.Run("bench pyramid box-stack --sizes 4 --steps 8 --threads 1,2 --repeat 2 --against " SCREE_PROGRAM
                   " --markdown against.md -o out");
    ASSERT_EQ(result.exitCode, exitDone) << result.output;
    // Two scenes, two solvers, two numbers of threads.
    const std::string text = result.output;
    std::size_t same = 0;
    for (std::size_t at = text.find(" same\n"); at != std::string::npos; at = text.find(" same\n", at + 1)) ++same;
    EXPECT_EQ(same, 8u) << text;
    EXPECT_EQ(text.find("differs"), std::string::npos) << text;
    EXPECT_TRUE(folder.Has("out/index.html"));
    EXPECT_NE(folder.Read("against.md").find("| pyramid |"), std::string::npos);
}

TEST(Against, AnOlderBuildThatKnowsNoListOfSolversIsMeasured) {
    const ScratchFolder folder;
    {
        std::ofstream old(folder.GetPath() / "old");
        old << "#!/bin/sh\ncase \"$*\" in *si,soft*) echo 'si, soft or both' >&2; exit 2;; esac\n"
            << "exec " SCREE_PROGRAM " \"$@\"\n";
    }
    std::filesystem::permissions(folder.GetPath() / "old", std::filesystem::perms::owner_all);
    const ProgramResult result = folder.Run("bench pyramid --sizes 4 --steps 2 --repeat 1 --against ./old");
    EXPECT_EQ(result.exitCode, exitDone) << result.output;
}

TEST(Against, WhatCannotBeComparedIsRefused) {
    const ScratchFolder folder;
    const ProgramResult missing = folder.Run("bench pyramid --against nowhere");
    EXPECT_EQ(missing.exitCode, exitUsage);
    EXPECT_NE(missing.output.find("there is no program"), std::string::npos) << missing.output;
    EXPECT_EQ(folder.Run("bench pyramid --targets --against " SCREE_PROGRAM).exitCode, exitUsage);
    EXPECT_EQ(folder.Run("bench pyramid --at-least 0.9").exitCode, exitUsage);
    EXPECT_EQ(folder.Run("bench no-such-scene --against " SCREE_PROGRAM).exitCode, exitUsage);
    // A program that is none of ours.
    const ProgramResult other = folder.Run("bench pyramid --sizes 4 --steps 2 --repeat 1 --against /bin/false");
    EXPECT_EQ(other.exitCode, 4) << other.output;
    EXPECT_NE(other.output.find("/bin/false bench pyramid"), std::string::npos) << other.output;
}

}  // namespace
}  // namespace testbed
