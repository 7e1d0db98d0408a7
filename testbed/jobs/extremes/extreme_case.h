// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The extremes as a table: what each case builds, for how long it runs, and which checks of survival it must pass.

#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbed/engines/lab.h"
#include "testbed/jobs/extremes/abuse.h"

namespace testbed {

/// Centres of moving bodies must stay within.
struct Bounds {
    Point lower, upper;
};

/// What is asked of a case besides finite states; a limit of 0 means that it is not asked.
struct Demands {
    bool energy = true;              ///< no gain beyond 1 %; off where the start itself holds energy, e.g. in overlaps
    std::optional<Bounds> bounds{};  ///< no moving body's centre leaves them
    double overlapShare = 0.1;       ///< 2 s after load, of the smaller body's smaller extent
    double overlap = 0.0;            ///< for the full grade, m
    double jointGap = 0.0;           ///< for the full grade, m
    double restSpeed = 0.0;    ///< all are slower at the end, at the earliest 5 s after load if it is that long, m/s
    bool restOfLoose = false;  ///< that is asked only of bodies without joints: the others swing on
    double accuracy = 0.0;     ///< for the full grade: of ExtremeCase::measure
    double maxSpeed = 0.0;     ///< faster is an explosion, m/s
};

struct ExtremeCase {
    std::string name{};   ///< "column-100"
    std::string group{};  ///< "columns"
    std::string what{};   ///< one line for readers
    std::function<scenes::Scene()> make{};
    double seconds = 5.0;
    double quickSeconds = 1.0;          ///< at most this with --quick
    double scale = 1.0;                 ///< size of the bodies, m: what pictures and energies are measured by
    std::string settings{};             ///< what the case changes of a run, as PrintSettings writes it
    Point place{};                      ///< where the scene's origin is put, m
    double restitutionThreshold = 1.0;  ///< of all fixtures, m/s
    Demands demands{};
    std::function<double(int step)> stepLength{};        ///< s; instead of the spec's
    std::function<void()> prepare{};                     ///< of the process, before the world is made
    std::function<void(LabWorld&, int step)> disturb{};  ///< before each step
    /// An error of the end state, compared with Demands::accuracy.
    std::function<double(const LabWorld& lab, double seconds)> measure{};
    /// Instead of all of the above: calls that no scene can make.
    std::optional<Abuse> abuse{};
    bool hidden = false;  ///< for the tests of the command itself
};

/// All cases, in the order of the report; hidden ones last.
[[nodiscard]] std::span<const ExtremeCase> GetExtremeCases();

// By theme; GetExtremeCases joins them.
[[nodiscard]] std::vector<ExtremeCase> MakePileCases();
[[nodiscard]] std::vector<ExtremeCase> MakeBuiltCases();
[[nodiscard]] std::vector<ExtremeCase> MakeJointCases();
[[nodiscard]] std::vector<ExtremeCase> MakeHoldingCases();
[[nodiscard]] std::vector<ExtremeCase> MakePlaceCases();
[[nodiscard]] std::vector<ExtremeCase> MakeMotionCases();
[[nodiscard]] std::vector<ExtremeCase> MakeInputCases();

}  // namespace testbed
