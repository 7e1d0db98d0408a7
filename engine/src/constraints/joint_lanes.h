// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of many joints of a type, eight at a time, with the bits of one after the other.

#pragma once

#include <bit>
#include <span>
#include <vector>

#include "constraints/joint_lane_task.h"
#include "constraints/joint_levels.h"
#include "constraints/joint_math.h"

namespace scree {

/// What the lanes ask of a type of joints beside its row: its Batch, its kernels, and how a joint gets into a lane and
/// out of it.
template <typename Row>
struct LaneTraits;

/// A joint that gets into a lane; or a lane to spare, which repeats one.
struct LaneJoint {
    const JointInfo& info;
    const MassRow &massA, &massB;
    bool isSpare;
};
template <typename Batch>
void PutBodies(const LaneJoint& from, size_t lane, Batch& batch) {
    batch.bodyA[lane] = ToInt(from.info.bodyA), batch.bodyB[lane] = ToInt(from.info.bodyB);
    batch.row[lane] = from.isSpare ? -1 : ToInt(from.info.row);
    batch.invMassA[lane] = from.massA.invMass, batch.invIA[lane] = from.massA.invI;
    batch.invMassB[lane] = from.massB.invMass, batch.invIB[lane] = from.massB.invI;
}

template <typename Row>
class JointLanes {
    using Traits = LaneTraits<Row>;
    using Batch = typename Traits::Batch;

public:
    /// Takes the joints of the type from this list, or none where that does not pay. To be called in every step.
    void Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table) {
        m_acts = false;
        const std::span<const JointIndex> order = m_levels.Sort(Row::type, joints, bodies, table);
        m_batches.resize(order.size() / jointBatchSize);
        for (size_t i = 0; i < order.size(); ++i) {
            const size_t lane = i % jointBatchSize;
            const bool isSpare = IsNone(order[i]);
            const JointInfo& info = table.info[isSpare ? order[i - lane] : order[i]];
            Batch& batch = m_batches[i / jointBatchSize];
            const MassRow &massA = bodies.mass[info.bodyA], &massB = bodies.mass[info.bodyB];
            PutBodies({info, massA, massB, isSpare}, lane, batch);
            Traits::Fill(table.Store<Row>().rows[info.row], massA, massB, lane, batch);
        }
    }
    [[nodiscard]] bool IsEmpty() const { return m_batches.empty(); }
    /// Some joint acted when they were prepared.
    [[nodiscard]] bool Act() const { return m_acts; }

    // As the phases of joint_solver.h.
    void Prepare(const JointStep& step, BodyTable& bodies) { m_acts = Traits::Kernels().prepare(Task(step, bodies)); }
    void WarmStart(const JointStep& step, BodyTable& bodies) { Traits::Kernels().warmStart(Task(step, bodies)); }
    void Solve(const JointStep& step, BodyTable& bodies) { Traits::Kernels().solve(Task(step, bodies)); }
    /// What is out of its range is looked at joint by joint. True if all is within the slop.
    bool SolvePositions(const JointStep& step, BodyTable& bodies, Column<JointRow, Row>& rows) {
        const JointLaneTask<Batch> task = Task(step, bodies);
        bool solved = true;
        for (const Batch& batch : m_batches) {
            for (uint32_t left = Traits::Kernels().findOutOfRange(task, batch); left != 0; left &= left - 1) {
                const auto lane = static_cast<size_t>(std::countr_zero(left));
                if (batch.row[lane] < 0) continue;
                const BodyIndex a{batch.bodyA[lane]}, b{batch.bodyB[lane]};
                const JointPair pair{a, b, bodies.mass[a], bodies.mass[b]};
                solved = Traits::Correct(batch, lane, pair, step, bodies, rows[JointRow{batch.row[lane]}]) && solved;
            }
        }
        return solved;
    }
    /// Writes the impulses times step.impulseScale into the rows.
    void Store(const JointStep& step, BodyTable& bodies, Column<JointRow, Row>& rows) {
        Traits::Kernels().scale(Task(step, bodies));
        for (const Batch& batch : m_batches) {
            for (size_t lane = 0; lane < jointBatchSize && batch.row[lane] >= 0; ++lane) {
                Traits::Store(batch, lane, rows[JointRow{batch.row[lane]}]);
            }
        }
    }

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_batches) + m_levels.GetMemoryBytes(); }

private:
    [[nodiscard]] JointLaneTask<Batch> Task(const JointStep& step, BodyTable& bodies) {
        static_assert(sizeof(Position) == 4 * sizeof(float) && sizeof(Velocity) == 4 * sizeof(float));
        return {.batches = m_batches.data(),
                .count = static_cast<int32_t>(m_batches.size()),
                .position = &bodies.position.data()->c.x,
                .velocity = &bodies.velocity.data()->v.x,
                .dt = step.dt,
                .inverseDt = step.inverseDt,
                .impulseScale = step.impulseScale,
                .slop = Traits::Slop(step)};
    }

    std::vector<Batch> m_batches;
    JointLevels m_levels;
    bool m_acts = false;
};

}  // namespace scree
