// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A joint's level is one above those of the joints before it that push one of its bodies. A counting sort by level.

#include "constraints/joint_levels.h"

#include <algorithm>

#include "base/sin_cos_terms.h"

namespace scree {

namespace {

constexpr size_t jointsOfBatch = 3;  // a batch takes as long as so many one by one

}  // namespace

bool JointLevels::CanTurn(const JointInfo& joint, const BodyTable& bodies) {
    constexpr float mostAngle = 0.1f * sin_cos::largestDirect;
    return !(Abs(bodies.position[joint.bodyA].a) > mostAngle || Abs(bodies.position[joint.bodyB].a) > mostAngle);
}

void JointLevels::Take(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies,
                       const JointTable& table) {
    m_taken.clear();
    if (bodies.IsFar()) return;
    for (const JointIndex joint : joints) {
        const JointInfo& info = table.info[joint];
        if (info.type != type) continue;
        if (!CanTurn(info, bodies)) return m_taken.clear();
        m_taken.push_back(joint);
    }
}

bool JointLevels::FindLevels(const BodyTable& bodies, const JointTable& table) {
    EnsureRows(m_next, ToSize(bodies.slots.Size()));
    for (const JointIndex joint : m_taken) {
        const JointInfo& info = table.info[joint];
        m_next[info.bodyA] = m_next[info.bodyB] = 0;
    }
    m_levels.resize(m_taken.size());
    m_start.clear(), m_ends.clear();
    for (size_t i = 0; i < m_taken.size(); ++i) {
        const JointInfo& info = table.info[m_taken[i]];
        int level = 0;
        bool pushesBoth = true;
        for (const BodyIndex body : {info.bodyA, info.bodyB}) {
            const bool isPushed = IsPushed(body, bodies);
            if (isPushed) level = std::max(level, m_next[body]);
            pushesBoth = pushesBoth && isPushed;
        }
        if (ToSize(level + 1) * jointsOfBatch > m_taken.size()) return false;
        m_next[info.bodyA] = m_next[info.bodyB] = level + 1;
        m_levels[i] = level;
        if (ToSize(level) >= m_start.size()) m_start.push_back(0), m_ends.push_back({0, true});
        ++m_start[ToSize(level)];
        m_ends[ToSize(level)].pushesAll = m_ends[ToSize(level)].pushesAll && pushesBoth;
    }
    return true;
}

std::span<const JointIndex> JointLevels::Sort(JointType type, std::span<const JointIndex> joints,
                                              const BodyTable& bodies, const JointTable& table) {
    Take(type, joints, bodies, table);
    if (!FindLevels(bodies, table)) return {};
    int begin = 0;
    for (size_t level = 0; level < m_start.size(); ++level) {
        const int batches = (m_start[level] + jointBatchSize - 1) / jointBatchSize;
        m_start[level] = begin;
        begin += batches * jointBatchSize;
        m_ends[level].end = begin / jointBatchSize;
    }
    if (ToSize(begin / jointBatchSize) * jointsOfBatch > m_taken.size()) return {};
    m_order.assign(ToSize(begin), JointIndex::none);
    for (size_t i = 0; i < m_taken.size(); ++i) m_order[ToSize(m_start[ToSize(m_levels[i])]++)] = m_taken[i];
    return m_order;
}

}  // namespace scree
