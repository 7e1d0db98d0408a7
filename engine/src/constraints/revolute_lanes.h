// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Revolute joints for the lanes of joint_lanes.h.

#pragma once

#include "constraints/joint_lanes.h"
#include "constraints/revolute.h"
#include "constraints/revolute_lane_kernels.h"

namespace scree {

template <>
struct LaneTraits<RevoluteRow> {
    using Batch = RevoluteBatch;
    static const RevoluteLaneKernels& Kernels() { return GetRevoluteLaneKernels(); }
    static float Slop(const JointStep&) { return angularSlop; }
    static void Fill(const RevoluteRow& row, const MassRow& massA, const MassRow& massB, size_t lane, Batch& b) {
        if (lane == 0) b.anyActs = b.anyMotor = b.anySpring = 0;
        b.referenceAngle[lane] = row.referenceAngle;
        b.turnMass[lane] = InverseOrZero(massA.invI + massB.invI);
        b.hasSpring[lane] = row.spring.enabled ? 1.0f : 0.0f;
        b.stiffness[lane] = row.spring.stiffness, b.damping[lane] = row.spring.damping;
        b.target[lane] = row.spring.target, b.mostSpring[lane] = row.spring.maximum;
        b.hasMotor[lane] = row.motor.enabled ? 1.0f : 0.0f;
        b.motorSpeed[lane] = row.motor.speed, b.mostMotor[lane] = row.motor.maximum;
        b.hasLimit[lane] = row.limit.enabled ? 1.0f : 0.0f;
        b.lower[lane] = row.limit.lower, b.upper[lane] = row.limit.upper;
        b.springImpulse[lane] = row.spring.impulse, b.motorImpulse[lane] = row.motor.impulse;
        b.lowerImpulse[lane] = row.limit.lowerImpulse, b.upperImpulse[lane] = row.limit.upperImpulse;
        b.anyMotor |= row.motor.enabled ? 1 : 0;
        b.anySpring |= row.spring.enabled ? 1 : 0;
    }
    /// Removes the errors of limit and point.
    static bool Correct(const Batch& b, size_t lane, const JointPair& pair, const JointStep& step, BodyTable& bodies,
                        const RevoluteRow& row) {
        RevoluteConstraint c{};
        c.pair = pair;
        c.turnMass = b.turnMass[lane];
        return SolvePosition(c, row, step, bodies);
    }
    static void Store(const Batch& b, size_t lane, RevoluteRow& row) {
        row.spring.impulse = b.springImpulse[lane];
        row.motor.impulse = b.motorImpulse[lane];
        row.limit.lowerImpulse = b.lowerImpulse[lane], row.limit.upperImpulse = b.upperImpulse[lane];
    }
};

}  // namespace scree
