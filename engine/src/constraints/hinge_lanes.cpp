// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints into lanes and impulses out of them.

#include "constraints/hinge_lanes.h"

#include <algorithm>

#include "constraints/revolute_lanes.h"

namespace scree {

void HingeLanes::Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table) {
    m_batches.clear();
    constexpr size_t fewest = 24;  // fewer are not worth the sorting
    const auto isHinge = [&](JointIndex joint) { return table.info[joint].type == e_revoluteJoint; };
    if (joints.size() < fewest || !std::ranges::all_of(joints, isHinge)) return;
    const std::span<const JointIndex> order = m_levels.Sort(e_revoluteJoint, joints, bodies, table);
    m_batches.resize(order.size() / jointBatchSize);
    for (size_t i = 0; i < order.size(); ++i) {
        const size_t lane = i % jointBatchSize;
        const bool isSpare = IsNone(order[i]);
        const JointInfo& info = table.info[isSpare ? order[i - lane] : order[i]];
        const RevoluteRow& row = table.Store<RevoluteRow>().rows[info.row];
        HingeBatch& h = m_batches[i / jointBatchSize];
        const MassRow &massA = bodies.mass[info.bodyA], &massB = bodies.mass[info.bodyB];
        FillLane<RevoluteRow>({info, row, massA, massB, isSpare}, lane, h.range);
        if (lane == 0) h.hasRange = 0;
        const bool hasRange = row.limit.enabled || row.limit.lowerImpulse != 0.0f || row.limit.upperImpulse != 0.0f ||
                              row.motor.enabled || row.motor.impulse != 0.0f || row.spring.enabled ||
                              row.spring.impulse != 0.0f;
        h.hasRange |= hasRange ? 1 : 0;
        const Vec2 a = row.localAnchorA - massA.localCenter, b = row.localAnchorB - massB.localCenter;
        h.anchorAX[lane] = a.x, h.anchorAY[lane] = a.y, h.anchorBX[lane] = b.x, h.anchorBY[lane] = b.y;
        h.impulseX[lane] = row.impulse.x, h.impulseY[lane] = row.impulse.y;
    }
}

void HingeLanes::Store(Column<JointRow, RevoluteRow>& rows) const {
    for (const HingeBatch& h : m_batches) {
        for (size_t lane = 0; lane < jointBatchSize && h.range.row[lane] >= 0; ++lane) {
            RevoluteRow& row = rows[JointRow{h.range.row[lane]}];
            row.impulse = {h.impulseX[lane], h.impulseY[lane]};
            LaneTraits<RevoluteRow>::Store(h.range, lane, row);
        }
    }
}

HingeLaneTask HingeLanes::Task(const JointStep& step, BodyTable& bodies) {
    return {.batches = m_batches.data(),
            .count = static_cast<int32_t>(m_batches.size()),
            .position = &bodies.position.data()->c.x,
            .velocity = &bodies.velocity.data()->v.x,
            .dt = step.dt,
            .inverseDt = step.inverseDt,
            .impulseScale = step.impulseScale,
            .slop = step.slop,
            .angularSlop = angularSlop,
            .mostTurn = maxAngularCorrection};
}

}  // namespace scree
