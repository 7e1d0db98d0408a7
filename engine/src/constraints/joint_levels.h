// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which joints can be solved side by side: joints that push the same body are in different batches, in their order. So
// solving batch after batch gives the bits of solving joint after joint.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "constraints/joint_lane_task.h"
#include "state/bodies.h"
#include "state/joints.h"

namespace scree {

/// Batches up to `end` that are in no other level before them.
struct JointLevel {
    int end;
    bool pushesAll;  ///< no body in it is one that cannot be pushed: several threads may write to all of them
};

class JointLevels {
public:
    /// The joints of a type in this list, by batch and place in it; none: to spare, behind the others of the batch. No
    /// joints where that does not pay, or where the kernels cannot turn the bodies. Valid until the next call.
    std::span<const JointIndex> Sort(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies,
                                     const JointTable& table);
    /// What the last call returned, if it returned joints, and how many of the list are of the type.
    [[nodiscard]] std::span<const JointIndex> GetOrder() const { return m_order; }
    [[nodiscard]] size_t CountTaken() const { return m_taken.size(); }
    /// The kernels can turn the bodies of the joint.
    [[nodiscard]] static bool CanTurn(const JointInfo& joint, const BodyTable& bodies);
    [[nodiscard]] static bool IsPushed(BodyIndex body, const BodyTable& bodies) {
        return bodies.mass[body].invMass > 0.0f;
    }
    /// Of the batches, in their order.
    [[nodiscard]] std::span<const JointLevel> GetLevels() const { return m_ends; }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_taken, m_levels, m_next, m_order, m_start, m_ends); }

private:
    void Take(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table);
    /// False where they are so many that their batches do not pay.
    bool FindLevels(const BodyTable& bodies, const JointTable& table);

    std::vector<JointIndex> m_taken;
    std::vector<int> m_levels;      ///< by joint: how many before it must be solved first
    Column<BodyIndex, int> m_next;  ///< level of the next joint that pushes the body
    std::vector<JointIndex> m_order;
    std::vector<int> m_start;  ///< by level: how many joints; then the next place of m_order
    std::vector<JointLevel> m_ends;
};

}  // namespace scree
