// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A joint's level is one above those of the joints before it that push one of its bodies. A counting sort by group and
// level. Which joints are connected is found by union-find.

#include "constraints/joint_levels.h"

#include <algorithm>
#include <numeric>

#include "base/sin_cos_terms.h"

namespace scree {

namespace {

constexpr size_t jointsOfBatch = 3;  // a batch takes as long as so many one by one
/// Joints of a group, enough to fill the batches of its levels. Connected ones that are more are shared level by level.
constexpr int mostOfGroup = 384;
constexpr size_t leastToGroup = 2 * mostOfGroup;  ///< fewer joints in all are not put into groups
/// Groups of another kind than the rest: joints in larger parts, and those that meet a body that cannot be pushed.
constexpr int groupOfLarge = 0, groupOfFixed = 1, firstOwnGroup = 2;

}  // namespace

bool JointLevels::PaysToTurn(const JointInfo& joint, const BodyTable& bodies) {
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
        if (!PaysToTurn(info, bodies)) return m_taken.clear();
        m_taken.push_back(joint);
    }
}

bool JointLevels::FindLevels(const BodyTable& bodies, const JointTable& table) {
    EnsureRows(m_next, ToSize(bodies.slots.Size()));
    for (const JointIndex joint : m_taken) {
        const JointInfo& info = table.info[joint];
        m_next[info.bodyA] = m_next[info.bodyB] = 0;
    }
    m_places.assign(m_taken.size(), {});
    for (size_t i = 0; i < m_taken.size(); ++i) {
        const JointInfo& info = table.info[m_taken[i]];
        Place& place = m_places[i];
        place.pushesBoth = true;
        for (const BodyIndex body : {info.bodyA, info.bodyB}) {
            const bool isPushed = IsPushed(body, bodies);
            if (isPushed) place.level = std::max(place.level, m_next[body]);
            place.pushesBoth = place.pushesBoth && isPushed;
        }
        if (ToSize(place.level + 1) * jointsOfBatch > m_taken.size()) return false;
        m_next[info.bodyA] = m_next[info.bodyB] = place.level + 1;
    }
    return true;
}

/// Deals the joints to groups; returns how many there are.
int JointLevels::FindGroups(const BodyTable& bodies, const JointTable& table) {
    const auto count = ToSize(bodies.slots.Size());
    m_connected.Reserve(count);
    EnsureRows(m_parts, count);
    for (const JointIndex joint : m_taken) {
        const JointInfo& info = table.info[joint];
        for (const BodyIndex body : {info.bodyA, info.bodyB}) {
            m_connected.Begin(body);
            m_parts[body] = {};
        }
    }
    for (size_t i = 0; i < m_taken.size(); ++i) {
        const JointInfo& info = table.info[m_taken[i]];
        if (m_places[i].pushesBoth) m_connected.Join(info.bodyA, info.bodyB);
    }
    const auto partOf = [&](size_t i) -> Part& {
        const JointInfo& info = table.info[m_taken[i]];
        return m_parts[m_connected.Find(IsPushed(info.bodyA, bodies) ? info.bodyA : info.bodyB)];
    };
    for (size_t i = 0; i < m_taken.size(); ++i) {
        Part& part = partOf(i);
        ++part.count;
        part.pushesAll = part.pushesAll && m_places[i].pushesBoth;
    }
    int last = firstOwnGroup, inLast = 0;
    for (size_t i = 0; i < m_taken.size(); ++i) {
        Part& part = partOf(i);
        if (part.group < 0 && part.count > mostOfGroup) {
            part.group = groupOfLarge;
        } else if (part.group < 0 && !part.pushesAll) {
            part.group = groupOfFixed;
        } else if (part.group < 0) {
            if (inLast + part.count > mostOfGroup) ++last, inLast = 0;
            inLast += part.count;
            part.group = last;
        }
        m_places[i].group = part.group;
    }
    return last + 1;
}

/// By group and level. None if the batches do not pay.
std::span<const JointIndex> JointLevels::Order(int groups) {
    m_depths.assign(ToSize(groups), 0);
    for (const Place& place : m_places) {
        int& depth = m_depths[ToSize(place.group)];
        depth = std::max(depth, place.level + 1);
    }
    m_levels.assign(ToSize(std::accumulate(m_depths.begin(), m_depths.end(), 0)), {});
    std::exclusive_scan(m_depths.begin(), m_depths.end(), m_depths.begin(), 0);  // the first level of each group
    const auto levelOf = [&](const Place& place) -> Level& {
        return m_levels[ToSize(m_depths[ToSize(place.group)] + place.level)];
    };
    for (const Place& place : m_places) {
        Level& level = levelOf(place);
        ++level.count;
        level.pushesAll = level.pushesAll && place.pushesBoth;
    }
    m_sections.clear();
    int batches = 0;
    for (int group = 0; group < groups; ++group) {
        const auto begin = ToSize(m_depths[ToSize(group)]);
        const size_t end = group + 1 < groups ? ToSize(m_depths[ToSize(group) + 1]) : m_levels.size();
        for (size_t i = begin; i < end; ++i) {
            Level& level = m_levels[i];
            level.next = batches * static_cast<int>(jointBatchSize);
            batches += (level.count + static_cast<int>(jointBatchSize) - 1) / static_cast<int>(jointBatchSize);
            if (group != groupOfLarge) continue;
            m_sections.push_back({batches, level.pushesAll ? Sharing::parted : Sharing::none});
        }
        if (group != groupOfLarge && begin < end)
            m_sections.push_back({batches, group == groupOfFixed ? Sharing::none : Sharing::whole});
    }
    if (ToSize(batches) * jointsOfBatch > m_taken.size()) return {};
    m_order.assign(ToSize(batches) * jointBatchSize, JointIndex::none);
    for (size_t i = 0; i < m_taken.size(); ++i) m_order[ToSize(levelOf(m_places[i]).next++)] = m_taken[i];
    return m_order;
}

std::span<const JointIndex> JointLevels::Sort(JointType type, std::span<const JointIndex> joints,
                                              const BodyTable& bodies, const JointTable& table) {
    Take(type, joints, bodies, table);
    if (!FindLevels(bodies, table)) return {};
    return Order(groupOfLarge + 1);
}

std::span<const JointIndex> JointLevels::SortByGroup(JointType type, std::span<const JointIndex> joints,
                                                     const BodyTable& bodies, const JointTable& table) {
    Take(type, joints, bodies, table);
    if (!FindLevels(bodies, table)) return {};
    if (m_taken.size() >= leastToGroup) {
        const std::span<const JointIndex> order = Order(FindGroups(bodies, table));
        if (!order.empty()) return order;
        for (Place& place : m_places) place.group = groupOfLarge;
    }
    return Order(groupOfLarge + 1);
}

}  // namespace scree
