// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies that nothing touches, eight at a time: forces, damping, motion, pose. The same arithmetic as body by body in
// solve_islands.cpp and solve_soft.cpp, hence the same bits (the dissertation, §5.2.1). Plain data only, because
// translation units for different instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

/// Columns of the body table, four floats a row, and the constants of the step.
struct IsolatedBodiesTask {
    float* velocity;       ///< v, w
    float* position;       ///< centre of mass, angle, its rest
    float* startPosition;  ///< written: the position before
    float* transform;      ///< origin, sine, cosine
    const float* mass;     ///< 1/mass, 1/inertia, local centre
    const float* force;    ///< force, torque; not read without `hasForces`
    const float* motion;   ///< linear damping, angular damping, gravity scale, mass
    bool hasForces;        ///< some body has damping, a gravity scale or a force
    bool hasLimit;         ///< of motion
    int32_t substeps;      ///< of the soft step; 0: sequential impulses
    float dt;
    float gravityX, gravityY;
    float maxTranslation, maxRotation;
    float slowLinear, slowAngular;  ///< squares of the speeds up to which a body counts as slow
};

enum class IsolatedMove : int32_t {
    refused,  ///< nothing was written: one of them is not dynamic, or fast enough for a cap, or too large afterwards
    fast,     ///< moved, and none is slow
    slow,     ///< moved, and some are slow enough for the sleep timer to run
};

/// Moves the bodies of eight different rows through one step without constraints.
using MoveIsolatedFunction = IsolatedMove (*)(const IsolatedBodiesTask& task, const int32_t* eight);

/// The best form this processor has. All forms give the same bits.
MoveIsolatedFunction GetMoveIsolated();

}  // namespace scree
