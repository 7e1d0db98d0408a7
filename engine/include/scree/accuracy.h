// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How accurate a step is to be: a mark on a dial, or the errors that a program accepts.

#pragma once

#include <cstdint>

namespace scree {

/// What World::Step(timeStep, accuracy) does. Contacts get stiffer with the number of sub-steps; joints are rigid.
enum class Accuracy : uint8_t {
    draft,    ///< 4 velocity and 2 position iterations of sequential impulses
    game,     ///< soft step, 4 sub-steps
    fine,     ///< 8 sub-steps
    precise,  ///< 16 sub-steps
};

/// Errors to stay below. Sub-steps are picked for the whole world, from what the last such step found alone, hence
/// deterministically: a sudden load is met one step late.
struct Tolerance {
    float overlap = 0.01f;    ///< of the skins of two shapes, m; more than linearSlop, which stays at rest
    float jointGap = 0.001f;  ///< between the anchors of a joint, m
    int leastSubsteps = 4;    ///< ≥ 1
    int mostSubsteps = 32;    ///< ≥ leastSubsteps
};

}  // namespace scree
