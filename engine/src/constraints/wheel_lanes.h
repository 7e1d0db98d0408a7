// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of many wheel joints, eight at a time. Joints that push the same body are in different
// batches, in their order. So the bits are those of solving the joints one after the other.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "constraints/wheel_lane_kernels.h"
#include "state/joints.h"

namespace scree {

struct JointStep;

class WheelLanes {
public:
    /// Takes the wheel joints of this list, or none where that does not pay. To be called in every step.
    void Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table);
    [[nodiscard]] bool IsEmpty() const { return m_batches.empty(); }

    // As the phases of joint_solver.h.
    void Prepare(const JointStep& step, const BodyTable& bodies);
    void WarmStart(Column<BodyIndex, Velocity>& velocity);
    void Solve(const JointStep& step, Column<BodyIndex, Velocity>& velocity);
    /// Removes the position errors of limits and, where there are any, of the axis. True if all are within the slop.
    bool SolvePositions(const JointStep& step, BodyTable& bodies, Column<JointRow, WheelRow>& rows);
    /// Writes the impulses times `scale` into the rows.
    void Store(float scale, Column<JointRow, WheelRow>& rows);

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_batches, m_taken, m_level, m_order, m_start); }

private:
    struct Taken {
        JointIndex joint;
        int level;  ///< how many joints before it must be solved first
    };

    void FindLevels(const BodyTable& bodies, const JointTable& table);
    void Fill(const BodyTable& bodies, const JointTable& table);
    [[nodiscard]] WheelLaneTask Task();

    std::vector<WheelBatch> m_batches;
    std::vector<Taken> m_taken;
    Column<BodyIndex, int> m_level;   ///< of the next joint that pushes the body
    std::vector<JointIndex> m_order;  ///< by batch and lane; none: to spare
    std::vector<int> m_start;         ///< by level: the next place of m_order
};

}  // namespace scree
