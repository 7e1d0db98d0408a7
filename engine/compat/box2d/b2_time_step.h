// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a step takes and how long its stages took.

#pragma once

#include "b2_api.h"
#include "b2_math.h"

/// Wall times of the last step, ms. The stages of this engine are mapped onto Box2D's: engine/compat/README.md.
struct B2_API b2Profile {
    float step;
    float collide;
    float solve;
    float solveInit;
    float solveVelocity;
    float solvePosition;
    float broadphase;
    float solveTOI;
};

/// Input of a step.
struct B2_API b2TimeStep {
    float dt;
    float inv_dt;
    float dtRatio;
    int32 velocityIterations;
    int32 positionIterations;
    bool warmStarting;
};

/// Centre of mass and angle.
struct B2_API b2Position {
    b2Vec2 c;
    float a;
};

/// Linear and angular velocity.
struct B2_API b2Velocity {
    b2Vec2 v;
    float w;
};

struct B2_API b2SolverData {
    b2TimeStep step;
    b2Position* positions;
    b2Velocity* velocities;
};
