// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of many revolute joints, eight at a time, with the bits of one after the other.

#pragma once

#include <span>
#include <vector>

#include "constraints/joint_levels.h"
#include "constraints/revolute_lane_kernels.h"

namespace scree {

struct JointStep;

class RevoluteLanes {
public:
    /// Takes the revolute joints of this list, or none where that does not pay. To be called in every step.
    void Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table);
    [[nodiscard]] bool IsEmpty() const { return m_batches.empty(); }
    /// Some joint acted when they were prepared.
    [[nodiscard]] bool Act() const { return m_act; }

    // As the phases of joint_solver.h.
    void Prepare(const JointStep& step, const BodyTable& bodies, Column<BodyIndex, Velocity>& velocity);
    void WarmStart(Column<BodyIndex, Velocity>& velocity);
    void Solve(const JointStep& step, Column<BodyIndex, Velocity>& velocity);
    /// Removes the position errors of limits and, where there are any, of the point. True if all are within the slop.
    bool SolvePositions(const JointStep& step, BodyTable& bodies, const Column<JointRow, RevoluteRow>& rows);
    /// Writes the impulses times `scale` into the rows.
    void Store(float scale, Column<JointRow, RevoluteRow>& rows);

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_batches) + m_levels.GetMemoryBytes(); }

private:
    [[nodiscard]] RevoluteLaneTask Task();

    std::vector<RevoluteBatch> m_batches;
    JointLevels m_levels;
    bool m_act = false;
};

}  // namespace scree
