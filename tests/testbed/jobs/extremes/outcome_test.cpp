// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Grades from endings and measurements, one fault at a time, and the way of an outcome through JSON.

#include "testbed/jobs/extremes/outcome.h"
#include "testbed/base/errors.h"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>
#include <nlohmann/json.hpp>

namespace testbed {
namespace {

ExtremeCase MakeStrictCase() {
    ExtremeCase one;
    one.name = "strict";
    one.demands = {.bounds = Bounds{{-1.0, -1.0}, {1.0, 1.0}},
                   .overlap = 0.02,
                   .jointGap = 0.01,
                   .restSpeed = 0.05,
                   .accuracy = 0.1,
                   .maxSpeed = 100.0};
    return one;
}

Grade GradeOf(const Outcome& outcome, const Ending& ending = {}) {
    return GradeCase(MakeStrictCase(), ending, outcome).grade;
}

TEST(ExtremeGrade, NothingWrongIsTheFullGrade) {
    const CaseGrade verdict = GradeCase(MakeStrictCase(), {}, {});
    EXPECT_EQ(verdict.grade, Grade::accurate);
    EXPECT_TRUE(verdict.reasons.empty());
}

TEST(ExtremeGrade, AProcessThatDidNotEndWellIsZeroWhateverItTold) {
    EXPECT_EQ(GradeOf({}, {.timedOut = true}), Grade::abort);
    EXPECT_EQ(GradeOf({}, {.signal = SIGABRT}), Grade::abort);
    EXPECT_EQ(GradeOf({}, {.exitCode = 4}), Grade::abort);
    EXPECT_EQ(GradeOf({}, {.output = false}), Grade::abort);
    const CaseGrade verdict = GradeCase(MakeStrictCase(), {.signal = SIGABRT}, {});
    ASSERT_EQ(verdict.reasons.size(), 1u);
    EXPECT_NE(verdict.reasons[0].find("signal 6"), std::string::npos) << verdict.reasons[0];
}

TEST(ExtremeGrade, EveryFaultHasItsGrade) {
    const auto with = [](auto Outcome::*field, auto value) {
        Outcome outcome;
        outcome.*field = value;
        return GradeOf(outcome);
    };
    EXPECT_EQ(with(&Outcome::finite, false), Grade::nonFinite);
    EXPECT_EQ(with(&Outcome::escapes, 1), Grade::explodes);
    EXPECT_EQ(with(&Outcome::gain, 1.5), Grade::explodes);
    EXPECT_EQ(with(&Outcome::maxSpeed, 101.0), Grade::explodes);
    EXPECT_EQ(with(&Outcome::gain, 0.02), Grade::survives);
    EXPECT_EQ(with(&Outcome::gain, 0.009), Grade::accurate);
    EXPECT_EQ(with(&Outcome::overlapShare, 0.11), Grade::survives);
    EXPECT_EQ(with(&Outcome::overlap, 0.03), Grade::survives);
    EXPECT_EQ(with(&Outcome::jointGap, 0.02), Grade::survives);
    EXPECT_EQ(with(&Outcome::restSpeed, 0.06), Grade::survives);
    EXPECT_EQ(with(&Outcome::accuracy, 0.2), Grade::survives);
    EXPECT_EQ(with(&Outcome::workRatio, 51.0), Grade::survives);
    EXPECT_EQ(with(&Outcome::repeated, 0), Grade::survives);
    EXPECT_EQ(with(&Outcome::repeated, 1), Grade::accurate);
    EXPECT_EQ(with(&Outcome::capped, 1), Grade::survives);
    EXPECT_EQ(with(&Outcome::stopped, 1), Grade::survives);
    EXPECT_EQ(with(&Outcome::refusal, std::string("no")), Grade::explodes) << "no better than what was tried";
}

TEST(ExtremeGrade, WhatIsNotAskedIsNotGraded) {
    ExtremeCase one;
    one.demands = {.energy = false, .overlapShare = 0.0};
    Outcome outcome;
    outcome.gain = 9.0;
    outcome.overlapShare = 9.0;
    outcome.overlap = 9.0;
    outcome.jointGap = 9.0;
    outcome.restSpeed = 9.0;
    outcome.accuracy = 9.0;
    outcome.escapes = 9;
    EXPECT_EQ(GradeCase(one, {}, outcome).grade, Grade::accurate);
}

TEST(ExtremeGrade, BadInputMustBeRefusedByNameAndChangeNothing) {
    ExtremeCase one;
    one.abuse = Abuse::nonFiniteBody;
    Outcome outcome;
    outcome.badCalls = outcome.refused = outcome.named = 5;
    EXPECT_EQ(GradeCase(one, {}, outcome).grade, Grade::accurate);
    outcome.named = 4;
    EXPECT_EQ(GradeCase(one, {}, outcome).grade, Grade::survives);
    outcome.named = outcome.refused = 4;
    EXPECT_EQ(GradeCase(one, {}, outcome).grade, Grade::survives);
    outcome.named = outcome.refused = 5;
    outcome.changed = true;
    EXPECT_EQ(GradeCase(one, {}, outcome).grade, Grade::survives);
}

TEST(ExtremeOutcome, ComesBackFromJsonAsItWent) {
    Outcome o;
    o.steps = 7;
    o.seconds = 0.125;
    o.shortened = true;
    o.gain = 1e-9;
    o.note = "a \"quoted\" note";
    o.repeated = 1;
    o.milliseconds = 3.5;
    const Outcome back = OutcomeFromJson(nlohmann::ordered_json::parse(ToJson(o).dump()));
    EXPECT_EQ(ToJson(back).dump(), ToJson(o).dump());
    EXPECT_EQ(back.note, o.note);
}

TEST(ExtremeOutcome, WhatIsNoNumberIsTheWorst) {
    constexpr double infinity = std::numeric_limits<double>::infinity(),
                     none = std::numeric_limits<double>::quiet_NaN();
    for (const auto field : {&Outcome::gain, &Outcome::maxSpeed, &Outcome::overlapShare, &Outcome::overlap,
                             &Outcome::jointGap, &Outcome::restSpeed, &Outcome::accuracy, &Outcome::workRatio}) {
        for (const double value : {infinity, none}) {
            Outcome o;
            o.*field = value;
            EXPECT_LT(GradeOf(o), Grade::accurate);
            const Outcome back = OutcomeFromJson(nlohmann::ordered_json::parse(ToJson(o).dump()));
            EXPECT_EQ(back.*field, infinity);
            EXPECT_EQ(GradeOf(back), GradeOf(o));
        }
    }
}

TEST(ExtremeGrade, ACaseCutShortHasNoGradeUnlessItBrokeBefore) {
    Outcome o;
    o.shortened = true;
    o.seconds = 0.05;
    EXPECT_EQ(GradeOf(o), Grade::notFinished);
    EXPECT_EQ(PrintGrade(GradeOf(o)), "");
    o.jointGap = 1.0;
    EXPECT_EQ(GradeOf(o), Grade::notFinished) << "the end may be worse";
    o.escapes = 1;
    EXPECT_EQ(GradeOf(o), Grade::explodes);
    o.finite = false;
    EXPECT_EQ(GradeOf(o), Grade::nonFinite);
}

}  // namespace
}  // namespace testbed
