// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Never worse with more sub-steps: every case of what is built flush and of what joints must hold, with 2 to 32
// sub-steps. SCREE_LONG=1 runs the cases for their whole time, else for that of their quick form.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "testbed/jobs/extremes/extreme_case.h"
#include "testbed/jobs/extremes/run_case.h"

namespace testbed {
namespace {

std::vector<ExtremeCase> GetCases() {
    std::vector<ExtremeCase> all = MakeBuiltCases();
    for (ExtremeCase& one : MakeHoldingCases()) all.push_back(std::move(one));
    return all;
}

Outcome RunWith(const ExtremeCase& one, int substeps) {
    RunSpec spec = MakeSpec("scree");
    spec.solver = SoftStep{substeps};
    const bool isLong = std::getenv("SCREE_LONG") != nullptr;
    return RunCase(one, spec, {.quick = !isLong, .repeats = false, .cpuSeconds = isLong ? 600.0 : 60.0}).outcome;
}

/// Chaos and rounding may bring an error that is far from what is allowed up or down.
void ExpectNoWorse(const char* figure, double error, double before, double allowed, int substeps) {
    if (allowed <= 0.0) return;
    EXPECT_LE(error, std::max(1.1 * before, 0.25 * allowed)) << figure << " with " << substeps << " sub-steps";
}

class MoreSubsteps : public testing::TestWithParam<std::string> {};

TEST_P(MoreSubsteps, AreNeverWorse) {
    const std::vector<ExtremeCase> cases = GetCases();
    const auto one = std::ranges::find(cases, GetParam(), &ExtremeCase::name);
    ASSERT_NE(one, cases.end());
    const Demands& asked = one->demands;
    Outcome game;
    for (const int substeps : {2, 4, 8, 16, 32}) {
        const Outcome now = RunWith(*one, substeps);
        ASSERT_TRUE(now.finite && !now.shortened) << substeps;
        if (substeps < 4) continue;
        if (substeps == 4) game = now;
        EXPECT_LE(now.escapes, game.escapes) << substeps;
        if (asked.energy) ExpectNoWorse("gain", now.gain, game.gain, 0.01, substeps);
        ExpectNoWorse("overlap", now.overlap, game.overlap, asked.overlap, substeps);
        ExpectNoWorse("joint gap", now.jointGap, game.jointGap, asked.jointGap, substeps);
        ExpectNoWorse("error", now.accuracy, game.accuracy, asked.accuracy, substeps);
        ExpectNoWorse("speed", now.maxSpeed, game.maxSpeed, asked.maxSpeed, substeps);
        ExpectNoWorse("rest", now.restSpeed, game.restSpeed, asked.restSpeed, substeps);
    }
}

std::vector<std::string> GetNames() {
    std::vector<std::string> names;
    for (const ExtremeCase& one : GetCases()) names.push_back(one.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Cases, MoreSubsteps, testing::ValuesIn(GetNames()), [](const auto& of) {
    std::string name = of.param;
    std::ranges::replace_if(
        name, [](char c) { return c == '-' || c == '.'; }, '_');
    return name;
});

}  // namespace
}  // namespace testbed
