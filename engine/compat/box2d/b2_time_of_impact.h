// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// When two moving shapes first touch.

#pragma once

#include "b2_api.h"
#include "b2_distance.h"
#include "b2_math.h"

/// The motions are followed from 0 to tMax.
struct B2_API b2TOIInput {
    b2DistanceProxy proxyA;
    b2DistanceProxy proxyB;
    b2Sweep sweepA;
    b2Sweep sweepB;
    float tMax;
};

struct B2_API b2TOIOutput {
    enum State { e_unknown, e_failed, e_overlapped, e_touching, e_separated };

    State state;
    float t;
};

/// The shapes are said to touch when they are b2_linearSlop inside each other's skins.
B2_API void b2TimeOfImpact(b2TOIOutput* output, const b2TOIInput* input);
