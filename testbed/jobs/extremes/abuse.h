// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Calls that no well-behaved scene makes: bad values in every field, bad polygons, destruction in the middle of things,
// many thousand bodies made and destroyed. Each can be done to either engine. A crash ends the process, so each belongs
// into a process of its own.

#pragma once

#include <string>
#include <string_view>

#include "testbed/engines/run_spec.h"

namespace testbed {

enum class Abuse {
    nonFiniteBody,      ///< NaN and infinity in every field of a body definition and in every setter
    nonFiniteFixture,   ///< the same in fixtures and shapes
    nonFiniteJoint,     ///< the same in every field of every kind of joint
    nonFiniteQuery,     ///< the same in boxes and rays of queries
    nonFiniteStep,      ///< the same in the time step and in gravity
    denormals,          ///< the smallest numbers in every field
    huge,               ///< the largest finite numbers in every field
    badPolygons,        ///< degenerate, spiked, clockwise, self-crossing, near-duplicate vertices
    badDensity,         ///< zero and negative
    churn,              ///< bodies added and removed in every step
    destroyTouching,    ///< bodies destroyed while they touch others
    destroyInCallback,  ///< bodies destroyed inside of contact callbacks
    handleReuse,        ///< a body made and destroyed more often than 2^16 times
    crash,              ///< for tests: ends the process by a signal
    hang,               ///< for tests: never returns
    chatter,            ///< for tests: writes a line to standard output, as engines may
};

/// What became of it.
struct AbuseResult {
    int calls = 0;          ///< bad calls made
    int refused = 0;        ///< of these, refused or corrected
    int named = 0;          ///< of these, refused with an error that names the field
    bool changed = false;   ///< a refused call changed the world
    bool finite = true;     ///< afterwards
    bool replaced = false;  ///< another shape than the given one was put in its place
    std::string note;       ///< what was accepted that should not have been
};

/// Whether an engine's calls can be abused: there is no code for those of Box2D 3.
[[nodiscard]] bool CanAbuse(std::string_view engine);
/// Throws std::invalid_argument for an engine that cannot.
[[nodiscard]] AbuseResult RunAbuse(const RunSpec& setting, Abuse abuse);
[[nodiscard]] AbuseResult AbuseScree(bool soft, Abuse abuse);
[[nodiscard]] AbuseResult AbuseBox2d(Abuse abuse);

}  // namespace testbed
