// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Batches → lanes. What is out of its range is looked at joint by joint.

#include "constraints/revolute_lanes.h"

#include <bit>

#include "constraints/revolute.h"

namespace scree {

void RevoluteLanes::Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table) {
    static_assert(revoluteLanes == jointBatchSize);
    m_act = false;
    const auto fill = [&bodies](RevoluteBatch& b, size_t lane, const JointInfo& info, const RevoluteRow& row,
                                bool isSpare) {
        if (lane == 0) b.anyActs = b.anyMotor = b.anySpring = 0;
        const MassRow &massA = bodies.mass[info.bodyA], &massB = bodies.mass[info.bodyB];
        b.bodyA[lane] = ToInt(info.bodyA), b.bodyB[lane] = ToInt(info.bodyB);
        b.row[lane] = isSpare ? -1 : ToInt(info.row);
        b.invMassA[lane] = massA.invMass, b.invIA[lane] = massA.invI;
        b.invMassB[lane] = massB.invMass, b.invIB[lane] = massB.invI;
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
    };
    FillBatches<RevoluteRow>(m_levels.Sort(e_revoluteJoint, joints, bodies, table), table, m_batches, fill);
}

RevoluteLaneTask RevoluteLanes::Task() {
    return {.batches = m_batches.data(),
            .count = static_cast<int32_t>(m_batches.size()),
            .position = nullptr,
            .velocity = nullptr,
            .dt = 0.0f,
            .inverseDt = 0.0f,
            .impulseScale = 1.0f,
            .angularSlop = angularSlop};
}

void RevoluteLanes::Prepare(const JointStep& step, const BodyTable& bodies, Column<BodyIndex, Velocity>& velocity) {
    static_assert(sizeof(Position) == 4 * sizeof(float) && sizeof(Velocity) == 4 * sizeof(float));
    RevoluteLaneTask task = Task();
    task.position = &bodies.position.data()->c.x;
    task.velocity = &velocity.data()->v.x;
    task.dt = step.dt, task.inverseDt = step.inverseDt, task.impulseScale = step.impulseScale;
    m_act = GetRevoluteLaneKernels().prepare(task);
}

void RevoluteLanes::WarmStart(Column<BodyIndex, Velocity>& velocity) {
    RevoluteLaneTask task = Task();
    task.velocity = &velocity.data()->v.x;
    GetRevoluteLaneKernels().warmStart(task);
}

void RevoluteLanes::Solve(const JointStep& step, Column<BodyIndex, Velocity>& velocity) {
    RevoluteLaneTask task = Task();
    task.velocity = &velocity.data()->v.x;
    task.dt = step.dt, task.inverseDt = step.inverseDt;
    GetRevoluteLaneKernels().solve(task);
}

bool RevoluteLanes::SolvePositions(const JointStep& step, BodyTable& bodies,
                                   const Column<JointRow, RevoluteRow>& rows) {
    RevoluteLaneTask task = Task();
    task.position = &bodies.position.data()->c.x;
    bool solved = true;
    for (const RevoluteBatch& b : m_batches) {
        if (b.anyActs == 0) continue;
        for (uint32_t left = GetRevoluteLaneKernels().findOutOfRange(task, b); left != 0; left &= left - 1) {
            const auto lane = ToSize(std::countr_zero(left));
            if (b.row[lane] < 0) continue;
            RevoluteConstraint c{};
            c.pair.a = BodyIndex{b.bodyA[lane]}, c.pair.b = BodyIndex{b.bodyB[lane]};
            c.pair.massA = bodies.mass[c.pair.a], c.pair.massB = bodies.mass[c.pair.b];
            c.turnMass = b.turnMass[lane];
            solved = SolvePosition(c, rows[JointRow{b.row[lane]}], step, bodies) && solved;
        }
    }
    return solved;
}

void RevoluteLanes::Store(float scale, Column<JointRow, RevoluteRow>& rows) {
    RevoluteLaneTask task = Task();
    task.impulseScale = scale;
    GetRevoluteLaneKernels().scale(task);
    for (const RevoluteBatch& b : m_batches) {
        for (size_t lane = 0; lane < revoluteLanes && b.row[lane] >= 0; ++lane) {
            RevoluteRow& row = rows[JointRow{b.row[lane]}];
            row.spring.impulse = b.springImpulse[lane];
            row.motor.impulse = b.motorImpulse[lane];
            row.limit.lowerImpulse = b.lowerImpulse[lane], row.limit.upperImpulse = b.upperImpulse[lane];
        }
    }
}

}  // namespace scree
