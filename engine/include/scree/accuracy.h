// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How accurate a step should be: a named accuracy, or the errors that a program accepts.

#pragma once

#include <cstdint>

namespace scree {

/// What World::Step(timeStep, accuracy) does. Contacts of the soft step are equally stiff in all; its joints are rigid,
/// but for those of nets.
enum class Accuracy : uint8_t {
    draft,    ///< 4 velocity and 2 position iterations of sequential impulses
    game,     ///< soft step, 4 sub-steps
    fine,     ///< 8 sub-steps
    precise,  ///< 16 sub-steps
};

/// Errors to stay below. Each island (bodies that touching contacts and joints connect, without static bodies) has
/// its own number of sub-steps. It follows from the errors of its bodies in the last such step. So it is
/// deterministic, and reacts to a sudden load one step late. The numbers are 1, 2, 3, 4, 6, 8, 12, … within the limits
/// below, rounded up. After a sudden load the number falls by 1/32 a step. Bodies that nothing touches take the least.
struct Tolerance {
    /// Of the outlines of two shapes, m; more than linearSlop · WorldDef::lengthScale.
    float overlap = 0.01f;
    float jointGap = 0.001f;  ///< between the anchors of a joint, m
    int leastSubsteps = 4;    ///< ≥ 1
    int mostSubsteps = 32;    ///< ≥ leastSubsteps
};

}  // namespace scree
