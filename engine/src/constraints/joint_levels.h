// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which joints can be solved side by side: joints that push the same body are in different batches, in their order. So
// solving batch after batch gives the bits of solving joint after joint.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "state/joints.h"

namespace scree {

inline constexpr int jointBatchSize = 8;

class JointLevels {
public:
    /// Joints by batch and place in it; none: to spare, behind the others of the batch. Valid until the next call.
    std::span<const JointIndex> Sort(std::span<const JointIndex> joints, const BodyTable& bodies,
                                     const JointTable& table);
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_levels, m_next, m_order, m_start); }

private:
    std::vector<int> m_levels;      ///< by joint: how many before it must be solved first
    Column<BodyIndex, int> m_next;  ///< level of the next joint that pushes the body
    std::vector<JointIndex> m_order;
    std::vector<int> m_start;  ///< by level: the next place of m_order
};

/// The joints of a type in a list, if the kernels can turn their bodies; else none.
void FindJointsOfType(JointType type, std::span<const JointIndex> joints, const BodyTable& bodies,
                      const JointTable& table, std::vector<JointIndex>& found);

}  // namespace scree
