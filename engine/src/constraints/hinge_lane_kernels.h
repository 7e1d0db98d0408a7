// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Eight whole revolute joints side by side: the shared point besides spring, motor and limits. The same arithmetic as
// in revolute.cpp, lane by lane, hence the same bits. Plain data only, because translation units for different
// instruction sets share it.

#pragma once

#include "constraints/revolute_lane_kernels.h"

namespace scree {

struct alignas(32) HingeBatch {
    using Row = RevoluteBatch::Row;

    RevoluteBatch range;  ///< bodies and masses; spring, motor and limits
    // Of a step.
    Row anchorAX, anchorAY, anchorBX, anchorBY;  ///< from the centres of mass, in the bodies' frames
    Row impulseX, impulseY;
    Row armAX, armAY, armBX, armBY;   ///< in world coordinates
    Row kxx, kxy, kyy, inverseOfDet;  ///< inverse effective mass of the point
    int32_t hasRange;                 ///< some lane has a spring, motor or limit
};

/// Batches that are solved one after the other. Lanes to spare come last and repeat the first.
struct HingeLaneTask {
    HingeBatch* batches;
    int32_t count;
    float* position;  ///< by body: centre of mass, angle, and one more
    float* velocity;  ///< by body: v, w, and one more
    float dt, inverseDt;
    float impulseScale;       ///< of warm starting
    float slop, angularSlop;  ///< m, rad
    float mostTurn;           ///< of a correction, rad
};

/// All forms give the bits of solving joint after joint.
struct HingeLaneKernels {
    /// Arms and masses at the bodies' present positions; scales the impulses.
    void (*prepare)(const HingeLaneTask& task);
    void (*warmStart)(const HingeLaneTask& task);
    /// One iteration on velocities.
    void (*solve)(const HingeLaneTask& task);
    /// One iteration on positions. True if all joints were within the slops.
    bool (*correct)(const HingeLaneTask& task);
};

/// The best form this processor has.
const HingeLaneKernels& GetHingeLaneKernels();

}  // namespace scree
