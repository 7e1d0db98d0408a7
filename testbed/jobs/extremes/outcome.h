// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a case came to: measurements by the process that ran it, and the grade that they are worth.

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {

/// Measured while a case ran. Everything but times is deterministic.
struct Outcome {
    int steps = 0;
    double seconds = 0.0;    ///< simulated
    bool shortened = false;  ///< the budget was used up before the end
    bool finite = true;
    std::string refusal;        ///< the engine refused the scene with this message
    double gain = 0.0;          ///< worst gain of energy over that of the start
    int escapes = 0;            ///< moving bodies beyond the bounds at the worst moment
    double maxSpeed = 0.0;      ///< m/s
    double overlapShare = 0.0;  ///< worst 2 s after load, of the smaller body's smaller extent
    double overlap = 0.0;       ///< the same in m
    double jointGap = 0.0;      ///< worst at any time, m
    double restSpeed = -1.0;    ///< of the fastest body at the end; −1: not asked
    double accuracy = -1.0;     ///< of ExtremeCase::measure; −1: not asked
    int contacts = 0;           ///< most in a step
    double workRatio = 1.0;     ///< most contacts and pairs in a step over the median of the last third
    int capped = 0;             ///< bodies slowed by a speed cap, summed
    int stopped = 0;            ///< bodies that the engine stopped because they became non-finite, summed
    int repeated = -1;          ///< a second run had the same states at its end: 1 yes, 0 no, −1 not run
    int worstStep = 0;          ///< the step of the picture
    double milliseconds = 0.0;  ///< of the slowest step
    int badCalls = 0, refused = 0, named = 0;  ///< of an abuse
    bool changed = false;                      ///< a refused call changed the world
    bool replaced = false;                     ///< another shape than the given one was taken
    std::string note;
};

[[nodiscard]] nlohmann::ordered_json ToJson(const Outcome& outcome);
/// A number that is not finite is null in JSON and comes back as infinity, which no demand allows. Throws FileError.
[[nodiscard]] Outcome OutcomeFromJson(const nlohmann::ordered_json& fields);

/// How the process that ran a case ended.
struct Ending {
    bool timedOut = false;
    int signal = 0;      ///< that ended it; 0: none
    int exitCode = 0;    ///< if no signal did
    bool output = true;  ///< it told its outcome
};

/// `notFinished` is no grade: the time was over before the end, and nothing went wrong until then.
enum class Grade { notFinished = -1, abort = 0, nonFinite = 1, explodes = 2, survives = 3, accurate = 4 };
/// "not finished", "aborts or hangs", "non-finite", …
[[nodiscard]] std::string NameGrade(Grade grade);
/// "4" … "0"; empty for `notFinished`.
[[nodiscard]] std::string PrintGrade(Grade grade);

struct CaseGrade {
    Grade grade = Grade::accurate;
    std::vector<std::string> reasons;  ///< why it is not the full grade
};
[[nodiscard]] CaseGrade GradeCase(const ExtremeCase& one, const Ending& ending, const Outcome& outcome);

}  // namespace testbed
