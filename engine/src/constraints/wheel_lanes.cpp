// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Batches → lanes. What has come near a limit is looked at joint by joint.

#include "constraints/wheel_lanes.h"

#include <bit>

#include "constraints/wheel.h"

namespace scree {

void WheelLanes::Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table) {
    static_assert(wheelLanes == jointBatchSize);
    const auto fill = [&bodies](WheelBatch& b, size_t lane, const JointInfo& info, const WheelRow& row, bool isSpare) {
        if (lane == 0) b.anyArmB = b.anyMotor = b.anySpring = b.anyLimit = 0;
        const MassRow &massA = bodies.mass[info.bodyA], &massB = bodies.mass[info.bodyB];
        const Vec2 anchorA = row.localAnchorA - massA.localCenter, anchorB = row.localAnchorB - massB.localCenter;
        b.bodyA[lane] = ToInt(info.bodyA), b.bodyB[lane] = ToInt(info.bodyB);
        b.row[lane] = isSpare ? -1 : ToInt(info.row);
        b.anchorAX[lane] = anchorA.x, b.anchorAY[lane] = anchorA.y;
        b.anchorBX[lane] = anchorB.x, b.anchorBY[lane] = anchorB.y;
        b.localAxisX[lane] = row.localAxisA.x, b.localAxisY[lane] = row.localAxisA.y;
        b.invMassA[lane] = massA.invMass, b.invIA[lane] = massA.invI;
        b.invMassB[lane] = massB.invMass, b.invIB[lane] = massB.invI;
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
    };
    FillBatches<WheelRow>(m_levels.Sort(e_wheelJoint, joints, bodies, table), table, m_batches, fill);
}

WheelLaneTask WheelLanes::Task() {
    return {.batches = m_batches.data(),
            .count = static_cast<int32_t>(m_batches.size()),
            .position = nullptr,
            .velocity = nullptr,
            .dt = 0.0f,
            .inverseDt = 0.0f,
            .impulseScale = 1.0f,
            .slop = 0.0f};
}

void WheelLanes::Prepare(const JointStep& step, const BodyTable& bodies) {
    static_assert(sizeof(Position) == 4 * sizeof(float) && sizeof(Velocity) == 4 * sizeof(float));
    WheelLaneTask task = Task();
    task.position = &bodies.position.data()->c.x;
    task.dt = step.dt, task.impulseScale = step.impulseScale;
    GetWheelLaneKernels().prepare(task);
}

void WheelLanes::WarmStart(Column<BodyIndex, Velocity>& velocity) {
    WheelLaneTask task = Task();
    task.velocity = &velocity.data()->v.x;
    GetWheelLaneKernels().warmStart(task);
}

void WheelLanes::Solve(const JointStep& step, Column<BodyIndex, Velocity>& velocity) {
    WheelLaneTask task = Task();
    task.velocity = &velocity.data()->v.x;
    task.dt = step.dt, task.inverseDt = step.inverseDt;
    GetWheelLaneKernels().solve(task);
}

bool WheelLanes::SolvePositions(const JointStep& step, BodyTable& bodies, Column<JointRow, WheelRow>& rows) {
    WheelLaneTask task = Task();
    task.position = &bodies.position.data()->c.x;
    task.slop = step.slop;
    bool solved = true;
    for (const WheelBatch& b : m_batches) {
        if (b.anyLimit == 0) continue;
        for (uint32_t left = GetWheelLaneKernels().findNearLimits(task, b); left != 0; left &= left - 1) {
            const auto lane = ToSize(std::countr_zero(left));
            if (b.row[lane] < 0) continue;
            WheelRow& row = rows[JointRow{b.row[lane]}];
            row.axis = {b.axisX[lane], b.axisY[lane]};
            WheelConstraint c{};
            c.pair.a = BodyIndex{b.bodyA[lane]}, c.pair.b = BodyIndex{b.bodyB[lane]};
            c.pair.massA = bodies.mass[c.pair.a], c.pair.massB = bodies.mass[c.pair.b];
            c.translation = b.translation[lane];
            c.angleA = b.angleA[lane], c.angleB = b.angleB[lane];
            c.apart = {b.apartX[lane], b.apartY[lane]};
            c.reach = b.reach[lane], c.armB = b.lengthB[lane];
            const Arms arms{
                {b.armAX[lane], b.armAY[lane]}, {b.armBX[lane], b.armBY[lane]}, {b.gapX[lane], b.gapY[lane]}};
            PrepareAcross(arms, row.axis, c);
            if (!KeepsBounds(c, row, step, bodies)) solved = SolvePosition(c, row, step, bodies) && solved;
        }
    }
    return solved;
}

void WheelLanes::Store(float scale, Column<JointRow, WheelRow>& rows) {
    WheelLaneTask task = Task();
    task.impulseScale = scale;
    GetWheelLaneKernels().scale(task);
    for (const WheelBatch& b : m_batches) {
        for (size_t lane = 0; lane < wheelLanes && b.row[lane] >= 0; ++lane) {
            WheelRow& row = rows[JointRow{b.row[lane]}];
            row.springImpulse = b.springImpulse[lane];
            row.motor.impulse = b.motorImpulse[lane];
            row.limit.lowerImpulse = b.lowerImpulse[lane], row.limit.upperImpulse = b.upperImpulse[lane];
        }
    }
}

}  // namespace scree
