// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of eight revolute joints side by side. The same arithmetic as in revolute.cpp, lane by
// lane, hence the same bits. Plain data only, because translation units for different instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int revoluteLanes = 8;

/// Eight joints no two of which push the same body. Lanes to spare come last and repeat the first.
struct alignas(32) RevoluteBatch {
    using Row = float[revoluteLanes];

    // Of a step.
    int32_t bodyA[revoluteLanes], bodyB[revoluteLanes];
    int32_t row[revoluteLanes];  ///< of the joint in its table; −1: to spare
    Row invMassA, invIA, invMassB, invIB;
    Row referenceAngle, turnMass;                           ///< turnMass: effective
    Row hasSpring, stiffness, damping, target, mostSpring;  ///< hasSpring and the like: 1 or 0
    Row hasMotor, motorSpeed, mostMotor;
    Row hasLimit, lower, upper;
    Row springImpulse, motorImpulse, lowerImpulse, upperImpulse;
    // Of a sub-step.
    Row acts;                                 ///< 0: idle, the limits are too far to matter and there is nothing else
    Row angle;                                ///< of the joint
    Row springGamma, springBias, springMass;  ///< Spring; mass 0: there is none
    int32_t anyActs, anySpring, anyMotor;     ///< in some lane
};

struct RevoluteLaneTask {
    RevoluteBatch* batches;
    int32_t count;
    const float* position;  ///< by body: centre of mass, angle, and one more
    float* velocity;        ///< by body: v, w, and one more
    float dt, inverseDt;
    float impulseScale;  ///< of warm starting
    float angularSlop;
};

struct RevoluteLaneKernels {
    /// Which joints act, and their masses, at the bodies' present angles and speeds; scales the impulses. False if none
    /// acts.
    bool (*prepare)(const RevoluteLaneTask& task);
    void (*warmStart)(const RevoluteLaneTask& task);
    /// One iteration.
    void (*solve)(const RevoluteLaneTask& task);
    /// A bit for each lane of this batch that acts and is out of its range.
    uint32_t (*findOutOfRange)(const RevoluteLaneTask& task, const RevoluteBatch& batch);
    /// Multiplies the impulses by impulseScale.
    void (*scale)(const RevoluteLaneTask& task);
};

/// The best form this processor has. All forms give the same bits.
const RevoluteLaneKernels& GetRevoluteLaneKernels();

}  // namespace scree
