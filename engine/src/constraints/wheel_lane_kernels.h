// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of eight wheel joints side by side. The same arithmetic as in wheel.cpp, lane by lane,
// hence the same bits. Plain data only, because translation units for different instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int wheelLanes = 8;

/// Eight joints no two of which push the same body. Lanes to spare come last and repeat the first.
struct alignas(32) WheelBatch {
    using Row = float[wheelLanes];

    // Of a step.
    int32_t bodyA[wheelLanes], bodyB[wheelLanes];
    int32_t row[wheelLanes];                     ///< of the joint in its table; −1: to spare
    Row anchorAX, anchorAY, anchorBX, anchorBY;  ///< from the centres of mass, in the bodies' frames
    Row localAxisX, localAxisY;                  ///< in A's frame
    Row invMassA, invIA, invMassB, invIB;
    Row stiffness, damping, mostForce;     ///< of the spring
    Row hasMotor, motorSpeed, mostTorque;  ///< 1 or 0; of the motor
    Row hasLimit, lower, upper;            ///< 1 or 0; of the translation
    Row springImpulse, motorImpulse, lowerImpulse, upperImpulse;
    // Of a sub-step.
    Row armAX, armAY, armBX, armBY, gapX, gapY;       ///< from the centres of mass; from A's anchor to B's
    Row axisX, axisY, alongA, alongB;                 ///< the row along the axis
    Row alongMass, turnMass;                          ///< effective
    Row springGamma, springBias, springMass;          ///< Spring; mass 0: there is none
    Row translation, angleA, angleB, apartX, apartY;  ///< as of WheelConstraint
    Row reach, lengthB;                               ///< where there are limits
    int32_t anyArmB, anyMotor, anySpring, anyLimit;   ///< in some lane
};

struct WheelLaneTask {
    WheelBatch* batches;
    int32_t count;
    const float* position;  ///< by body: centre of mass, angle, and one more
    float* velocity;        ///< by body: v, w, and one more
    float dt, inverseDt;
    float impulseScale;  ///< of warm starting
    float slop;
};

struct WheelLaneKernels {
    /// Arms and masses at the bodies' present positions; scales the impulses.
    void (*prepare)(const WheelLaneTask& task);
    void (*warmStart)(const WheelLaneTask& task);
    /// One iteration.
    void (*solve)(const WheelLaneTask& task);
    /// A bit for each lane of this batch whose translation may have come to a limit since prepare.
    uint32_t (*findNearLimits)(const WheelLaneTask& task, const WheelBatch& batch);
    /// Multiplies the impulses by impulseScale.
    void (*scale)(const WheelLaneTask& task);
};

/// The best form this processor has. All forms give the same bits.
const WheelLaneKernels& GetWheelLaneKernels();

}  // namespace scree
