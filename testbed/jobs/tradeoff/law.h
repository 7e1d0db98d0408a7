// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The laws of mechanics that the trade between speed and accuracy is measured on. A law is a scenario with a known
// result. Its scenes are data and run in any engine under any setting; its errors are read from the states of bodies,
// in double.

#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/lab.h"
#include "testbed/engines/run_spec.h"

namespace testbed {

/// For a quantity without a bound.
inline constexpr double noBound = std::numeric_limits<double>::infinity();

// From where on a scenario is lost (LawError::failed), where several laws share it.
inline constexpr double tornGap = 0.5;   ///< half a link of the chains and bridges, m
inline constexpr double exploded = 1.0;  ///< a gain of energy, over that of the start

/// One error that a law measures; 0 is exact.
struct LawError {
    std::string name{};
    std::string unit{};        ///< empty: relative or a number
    double game = noBound;     ///< at most this at the dial's `game`
    double precise = noBound;  ///< at most this at the dial's `precise`
    /// Errors below are the rounding of floats: they differ by luck and are plotted and compared as if they were this.
    double rounding = 1e-6;
    /// From here on the scenario is lost and the size of the error says nothing: a column lies on the floor.
    double failed = noBound;
};

/// A family of settings that is compared as a whole.
enum class Family { box2d, box2d3, sequential, soft };
[[nodiscard]] Family FamilyOf(const RunSpec& setting);
/// "Box2D 2.4.1", "Box2D 3", "Scree, sequential impulses", "Scree, soft step".
[[nodiscard]] std::string NameFamily(Family family);

/// How thorough a measurement is.
enum class Effort { quick, full };

struct Law {
    std::string name{};              ///< of files and columns, "two-disks"
    std::string title{};             ///< "Two disks collide, masses 1:1 to 1:1000"
    std::string exact{};             ///< the exact result in words
    std::vector<LawError> errors{};  ///< the first one is plotted
    /// One value per entry of `errors`.
    std::vector<double> (*measure)(const RunSpec& setting, Effort effort) = nullptr;
    /// What is timed: a scene of about the same work, tiled to about a thousand bodies.
    scenes::Scene (*costScene)() = nullptr;
    double costSeconds = 0.5;  ///< simulated time that is timed
    Point pitch{};             ///< of the tiles, m
    bool capped = true;        ///< our engine keeps Box2D's caps of speed
};

/// All laws, in the order of the report.
[[nodiscard]] std::span<const Law> GetLaws();

/// `copies` of a scene on a square grid.
[[nodiscard]] scenes::Scene Tile(const scenes::Scene& scene, int copies, Point pitch);

/// The law's scene, tiled to about `bodies` moving bodies.
[[nodiscard]] scenes::Scene MakeCostScene(const Law& law, int bodies);

// By theme; GetLaws joins them.
[[nodiscard]] std::vector<Law> MakeMotionLaws();
[[nodiscard]] std::vector<Law> MakeJointLaws();
[[nodiscard]] std::vector<Law> MakeFrictionLaws();
[[nodiscard]] std::vector<Law> MakeImpactLaws();
[[nodiscard]] std::vector<Law> MakePileLaws();

}  // namespace testbed
