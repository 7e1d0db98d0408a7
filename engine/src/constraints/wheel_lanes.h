// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of many wheel joints, eight at a time, with the bits of one after the other.

#pragma once

#include <span>
#include <vector>

#include "constraints/joint_levels.h"
#include "constraints/wheel_lane_kernels.h"

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

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_batches) + m_levels.GetMemoryBytes(); }

private:
    [[nodiscard]] WheelLaneTask Task();

    std::vector<WheelBatch> m_batches;
    JointLevels m_levels;
};

}  // namespace scree
