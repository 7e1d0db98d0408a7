// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of eight wheel joints side by side. The same arithmetic as in wheel.cpp, lane by lane,
// hence the same bits. Plain data only, because translation units for different instruction sets share it.

#pragma once

#include "constraints/joint_lane_task.h"

namespace scree {

struct alignas(32) WheelBatch {
    using Row = float[jointBatchSize];

    // Of a step.
    int32_t bodyA[jointBatchSize], bodyB[jointBatchSize];
    int32_t row[jointBatchSize];                 ///< of the joint in its table; −1: to spare
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

using WheelLaneTask = JointLaneTask<WheelBatch>;
using WheelLaneKernels = JointLaneKernels<WheelBatch>;

/// The best form this processor has. All forms give the same bits.
const WheelLaneKernels& GetWheelLaneKernels();

}  // namespace scree
