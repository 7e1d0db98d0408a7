// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints into lanes and impulses out of them.

#include "constraints/hinge_lanes.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "constraints/revolute_lanes.h"

namespace scree {

namespace {

/// Nothing but the point acts or has acted.
bool IsPoint(const RevoluteRow& row) {
    const auto isZero = [](float impulse) { return std::bit_cast<uint32_t>(impulse) == 0; };
    return !row.limit.enabled && !row.motor.enabled && !row.spring.enabled && isZero(row.motor.impulse) &&
           isZero(row.spring.impulse) && isZero(row.limit.lowerImpulse) && isZero(row.limit.upperImpulse);
}

}  // namespace

void HingeLanes::Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table) {
    m_batches.clear();
    constexpr size_t fewest = 24;  // fewer are not worth the sorting
    const auto isHinge = [&](JointIndex joint) { return table.info[joint].type == e_revoluteJoint; };
    if (joints.size() < fewest || !std::ranges::all_of(joints, isHinge)) return;
    if (std::ranges::equal(joints, m_inTurn)) return;
    const std::span<const JointIndex> order = m_levels.Sort(e_revoluteJoint, joints, bodies, table);
    if (order.empty()) m_inTurn.assign(joints.begin(), joints.end());
    const Column<JointRow, RevoluteRow>& rows = table.Store<RevoluteRow>().rows;
    m_batches.resize(order.size() / jointBatchSize);
    for (size_t i = 0; i < m_batches.size(); ++i) {
        HingeBatch& h = m_batches[i];
        const std::span<const JointIndex> lanes = order.subspan(i * jointBatchSize, jointBatchSize);
        h.hasRange = 0;
        for (size_t lane = 0; lane < jointBatchSize; ++lane) {
            const bool isSpare = IsNone(lanes[lane]);
            const JointInfo& info = table.info[lanes[isSpare ? 0 : lane]];
            const RevoluteRow& row = rows[info.row];
            const MassRow &massA = bodies.mass[info.bodyA], &massB = bodies.mass[info.bodyB];
            PutBodies({info, massA, massB, isSpare}, lane, h.range);
            const Vec2 a = row.localAnchorA - massA.localCenter, b = row.localAnchorB - massB.localCenter;
            h.anchorAX[lane] = a.x, h.anchorAY[lane] = a.y, h.anchorBX[lane] = b.x, h.anchorBY[lane] = b.y;
            h.impulseX[lane] = row.impulse.x, h.impulseY[lane] = row.impulse.y;
            if (!IsPoint(row)) h.hasRange = 1;
        }
        if (h.hasRange == 0) continue;
        for (size_t lane = 0; lane < jointBatchSize; ++lane) {
            const JointInfo& info = table.info[lanes[IsNone(lanes[lane]) ? 0 : lane]];
            LaneTraits<RevoluteRow>::Fill(rows[info.row], bodies.mass[info.bodyA], bodies.mass[info.bodyB], lane,
                                          h.range);
        }
    }
}

void HingeLanes::Store(Column<JointRow, RevoluteRow>& rows) const {
    for (const HingeBatch& h : m_batches) {
        for (size_t lane = 0; lane < jointBatchSize && h.range.row[lane] >= 0; ++lane) {
            RevoluteRow& row = rows[JointRow{h.range.row[lane]}];
            row.impulse = {h.impulseX[lane], h.impulseY[lane]};
            if (h.hasRange != 0) LaneTraits<RevoluteRow>::Store(h.range, lane, row);
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
