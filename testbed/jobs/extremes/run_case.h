// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs one case in this process and watches it: what a crash leaves behind is for the process that started this one.

#pragma once

#include <string>

#include "testbed/jobs/extremes/outcome.h"

namespace testbed {

struct CaseBudget {
    bool quick = false;
    bool repeats = true;      ///< run it twice where there is time, and compare the ends
    double cpuSeconds = 7.0;  ///< processor time after which the case is cut short
};

struct CaseRun {
    Outcome outcome;
    std::string picture;  ///< SVG of the worst moment; empty: there is none
};
/// A case keeps what it is about: its own settings apply after those of `setting`.
[[nodiscard]] CaseRun RunCase(const ExtremeCase& one, const RunSpec& setting, const CaseBudget& budget);

/// Smallest extent of a body's fixtures, m; infinity without any.
[[nodiscard]] double SmallestExtent(const scenes::Scene& scene, int body);

/// Kinetic and potential energy of the dynamic bodies, J.
[[nodiscard]] double SumEnergy(const scenes::Scene& scene, std::span<const BodyReading> bodies, Point gravity);

}  // namespace testbed
