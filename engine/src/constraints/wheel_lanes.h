// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wheel joints for the lanes of joint_lanes.h.

#pragma once

#include "constraints/joint_lanes.h"
#include "constraints/wheel.h"
#include "constraints/wheel_lane_kernels.h"

namespace scree {

template <>
struct LaneTraits<WheelRow> {
    using Batch = WheelBatch;
    static const WheelLaneKernels& Kernels() { return GetWheelLaneKernels(); }
    static float Slop(const JointStep& step) { return step.slop; }
    static void Fill(const WheelRow& row, const MassRow& massA, const MassRow& massB, size_t lane, Batch& b) {
        if (lane == 0) b.anyArmB = b.anyMotor = b.anySpring = b.anyLimit = 0;
        const Vec2 anchorA = row.localAnchorA - massA.localCenter, anchorB = row.localAnchorB - massB.localCenter;
        b.anchorAX[lane] = anchorA.x, b.anchorAY[lane] = anchorA.y;
        b.anchorBX[lane] = anchorB.x, b.anchorBY[lane] = anchorB.y;
        b.localAxisX[lane] = row.localAxisA.x, b.localAxisY[lane] = row.localAxisA.y;
        b.stiffness[lane] = row.stiffness, b.damping[lane] = row.damping, b.mostForce[lane] = row.maxSpringForce;
        b.hasMotor[lane] = row.motor.enabled ? 1.0f : 0.0f;
        b.motorSpeed[lane] = row.motor.speed, b.mostTorque[lane] = row.motor.maximum;
        b.hasLimit[lane] = row.limit.enabled ? 1.0f : 0.0f;
        b.lower[lane] = row.limit.lower, b.upper[lane] = row.limit.upper;
        b.springImpulse[lane] = row.springImpulse, b.motorImpulse[lane] = row.motor.impulse;
        b.lowerImpulse[lane] = row.limit.lowerImpulse, b.upperImpulse[lane] = row.limit.upperImpulse;
        b.anyArmB |= anchorB == vec2Zero ? 0 : 1;
        b.anyMotor |= row.motor.enabled ? 1 : 0;
        b.anySpring |= row.stiffness > 0.0f ? 1 : 0;
        b.anyLimit |= row.limit.enabled ? 1 : 0;
    }
    /// Removes the errors along and across the axis, where a limit is exceeded.
    static bool Correct(const Batch& b, size_t lane, const JointPair& pair, const JointStep& step, BodyTable& bodies,
                        WheelRow& row) {
        row.axis = {b.axisX[lane], b.axisY[lane]};
        WheelConstraint c{};
        c.pair = pair;
        c.translation = b.translation[lane];
        c.angleA = b.angleA[lane], c.angleB = b.angleB[lane];
        c.apart = {b.apartX[lane], b.apartY[lane]};
        c.reach = b.reach[lane], c.armB = b.lengthB[lane];
        const Arms arms{{b.armAX[lane], b.armAY[lane]}, {b.armBX[lane], b.armBY[lane]}, {b.gapX[lane], b.gapY[lane]}};
        PrepareAcross(arms, row.axis, c);
        return KeepsBounds(c, row, step, bodies) || SolvePosition(c, row, step, bodies);
    }
    static void Store(const Batch& b, size_t lane, WheelRow& row) {
        row.springImpulse = b.springImpulse[lane];
        row.motor.impulse = b.motorImpulse[lane];
        row.limit.lowerImpulse = b.lowerImpulse[lane], row.limit.upperImpulse = b.upperImpulse[lane];
    }
};

}  // namespace scree
