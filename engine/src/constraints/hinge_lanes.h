// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Many revolute joints that are solved in turn, eight at a time where they push different bodies, with the bits of one
// after the other.

#pragma once

#include <span>
#include <vector>

#include "constraints/hinge_lane_kernels.h"
#include "constraints/joint_levels.h"
#include "constraints/joint_math.h"

namespace scree {

class HingeLanes {
public:
    /// Takes all of these joints, or none: where one is of another type, or where it does not pay.
    void Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table);
    void Clear() { m_batches.clear(); }
    [[nodiscard]] bool IsEmpty() const { return m_batches.empty(); }

    // As the phases of joint_solver.h.
    void Prepare(const JointStep& step, BodyTable& bodies) { GetHingeLaneKernels().prepare(Task(step, bodies)); }
    void WarmStart(const JointStep& step, BodyTable& bodies) { GetHingeLaneKernels().warmStart(Task(step, bodies)); }
    void Solve(const JointStep& step, BodyTable& bodies) { GetHingeLaneKernels().solve(Task(step, bodies)); }
    bool SolvePositions(const JointStep& step, BodyTable& bodies) {
        return GetHingeLaneKernels().correct(Task(step, bodies));
    }
    /// Writes the impulses into the rows.
    void Store(Column<JointRow, RevoluteRow>& rows) const;

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_batches, m_inTurn) + m_levels.GetMemoryBytes(); }
    void MatchRoomOf(const HingeLanes& other) {
        MatchRoom(m_batches, other.m_batches), MatchRoom(m_inTurn, other.m_inTurn);
        m_levels.MatchRoomOf(other.m_levels);
    }

private:
    [[nodiscard]] HingeLaneTask Task(const JointStep& step, BodyTable& bodies);

    std::vector<HingeBatch> m_batches;
    JointLevels m_levels;
    std::vector<JointIndex> m_inTurn;  ///< joints for which it did not pay of late
};

}  // namespace scree
