// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How accurate a step is to be: a mark on a dial, or the errors that a program accepts.

#pragma once

#include <cstdint>

namespace scree {

/// What World::Step(timeStep, accuracy) does. Contacts are equally stiff at all marks; joints are rigid.
enum class Accuracy : uint8_t {
    draft,    ///< 4 velocity and 2 position iterations of sequential impulses
    game,     ///< soft step, 4 sub-steps
    fine,     ///< 8 sub-steps
    precise,  ///< 16 sub-steps
};

/// Errors to stay below. Sub-steps are picked for each island (bodies that are connected by touching contacts and
/// joints, static bodies not counted) from what the last such step found at its bodies alone, hence deterministically:
/// a sudden load is met one step late. Islands share the numbers least, 1, 2, 3, 4, 6, 8, 12, …, most, rounded up, and
/// after a blow their number falls by 1/32 a step. Bodies that nothing touches take the least.
struct Tolerance {
    /// Of the outlines of two shapes, m; more than linearSlop · WorldDef::lengthScale.
    float overlap = 0.01f;
    float jointGap = 0.001f;  ///< between the anchors of a joint, m
    int leastSubsteps = 4;    ///< ≥ 1
    int mostSubsteps = 32;    ///< ≥ leastSubsteps
};

}  // namespace scree
