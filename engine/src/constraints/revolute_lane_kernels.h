// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of eight revolute joints side by side. The same arithmetic as in revolute.cpp, lane by
// lane, hence the same bits. Plain data only, because translation units for different instruction sets share it.

#pragma once

#include "constraints/joint_lane_task.h"

namespace scree {

struct alignas(32) RevoluteBatch {
    using Row = float[jointBatchSize];

    // Of a step.
    int32_t bodyA[jointBatchSize], bodyB[jointBatchSize];
    int32_t row[jointBatchSize];  ///< of the joint in its table; −1: to spare
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

using RevoluteLaneTask = JointLaneTask<RevoluteBatch>;
using RevoluteLaneKernels = JointLaneKernels<RevoluteBatch>;

/// The best form this processor has. All forms give the same bits.
const RevoluteLaneKernels& GetRevoluteLaneKernels();

}  // namespace scree
