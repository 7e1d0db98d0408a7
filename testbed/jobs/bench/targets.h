// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The speed that the engine has to reach, as data, and its verdict on measured rows. The table holds what Box2D 2.4.1
// took on one machine (2 cores of a Zen 3 server), and what ours may take there. Only quotients of its columns are
// used, and each is compared with a ratio of one run, so that a target means the same on every machine.

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/jobs/bench/row.h"

namespace testbed {

/// A scene at its default size, continuous collision off.
struct SpeedTarget {
    std::string_view scene;
    double boxTwoDMs;       ///< Box2D's total on the machine of the table
    double ratioOne;        ///< Box2D's total / ours at one thread, at least
    double ratioTwo;        ///< the same at two threads
    double boxTwoDWorstMs;  ///< Box2D's slowest step on that machine
    double worstMs;         ///< ours at most: half of the best rival's slowest step
};

[[nodiscard]] std::span<const SpeedTarget> SpeedTargets();

/// Whether the cost of continuous collision is judged in this scene.
[[nodiscard]] bool IsContinuousTarget(std::string_view scene);

enum class Verdict { met, missed, isVoid, notMeasured };

/// One target and what was measured for it.
struct TargetResult {
    std::string law{};    ///< e.g. "total, 1 thread"
    std::string scene{};  ///< empty: all scenes together
    Verdict verdict = Verdict::notMeasured;
    double measured = 0;
    double needed = 0;
    bool atLeast = true;  ///< whether `measured` must not be below (else: above) `needed`
    std::string note{};   ///< the setting it was measured with, or why it is void
};

/// Judges all targets for which `rows` holds what they need; the others come back as not measured. Where both solvers
/// ran, the faster one whose ratio is not void counts.
[[nodiscard]] std::vector<TargetResult> JudgeTargets(std::span<const BenchRow> rows);

/// A line per result and a last line that counts the verdicts.
[[nodiscard]] std::string FormatTargets(std::span<const TargetResult> results);

/// True when a target was missed or its measurement is void.
[[nodiscard]] bool HasMiss(std::span<const TargetResult> results);

}  // namespace testbed
