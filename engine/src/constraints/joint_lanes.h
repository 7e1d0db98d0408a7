// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Springs, motors and limits of many joints of a type, eight at a time, with the bits of one after the other. Threads
// share groups of joints that no body connects, and where there are none the batches of a level.

#pragma once

#include <algorithm>
#include <bit>
#include <functional>
#include <span>
#include <vector>

#include "base/task_pool.h"
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
    void Plan(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table, TaskPool& pool) {
        m_acts = false;
        if (Refill(joints, bodies, table, pool)) return;
        m_planned.clear();
        m_batches.resize(m_levels.SortByGroup(Row::type, joints, bodies, table).size() / jointBatchSize);
        if (m_batches.empty()) return;
        Fill(bodies, table, pool);
        m_planned.assign(joints.begin(), joints.end());
    }
    [[nodiscard]] bool IsEmpty() const { return m_batches.empty(); }
    /// Of the last plan, if it took some.
    [[nodiscard]] size_t CountJoints() const { return m_levels.CountTaken(); }
    /// Some joint acted when they were prepared.
    [[nodiscard]] bool Act() const { return m_acts; }

    // As the phases of joint_solver.h.
    void Prepare(const JointStep& step, BodyTable& bodies, TaskPool& pool) {
        bool acts[maxWorkers] = {};
        ForAll(pool, [&](std::span<Batch> part, int /*begin*/, int worker) {
            acts[worker] = Traits::Kernels().prepare(Task(step, bodies, part)) || acts[worker];
        });
        m_acts = std::ranges::any_of(acts, std::identity());
    }
    void WarmStart(const JointStep& step, BodyTable& bodies, TaskPool& pool) {
        ForSections(pool, [&](std::span<Batch> part, int) { Traits::Kernels().warmStart(Task(step, bodies, part)); });
    }
    void Solve(const JointStep& step, BodyTable& bodies, TaskPool& pool) {
        ForSections(pool, [&](std::span<Batch> part, int) { Traits::Kernels().solve(Task(step, bodies, part)); });
    }
    /// What is out of its range is looked at joint by joint. True if all is within the slop.
    bool SolvePositions(const JointStep& step, BodyTable& bodies, Column<JointRow, Row>& rows, TaskPool& pool) {
        bool isOff[maxWorkers] = {};
        ForSections(pool, [&](std::span<Batch> part, int worker) {
            if (!Correct(part, step, bodies, rows)) isOff[worker] = true;
        });
        return std::ranges::none_of(isOff, std::identity());
    }
    void SolvePositionsAndWarmStart(const JointStep& step, BodyTable& bodies, Column<JointRow, Row>& rows,
                                    TaskPool& pool) {
        ForSections(pool, [&](std::span<Batch> part, int) {
            Correct(part, step, bodies, rows);
            Traits::Kernels().warmStart(Task(step, bodies, part));
        });
    }
    /// Writes the impulses times step.impulseScale into the rows.
    void Store(const JointStep& step, BodyTable& bodies, Column<JointRow, Row>& rows, TaskPool& pool) {
        ForAll(pool, [&](std::span<Batch> part, int /*begin*/, int /*worker*/) {
            Traits::Kernels().scale(Task(step, bodies, part));
            for (const Batch& batch : part) {
                for (size_t lane = 0; lane < jointBatchSize && batch.row[lane] >= 0; ++lane) {
                    Traits::Store(batch, lane, rows[JointRow{batch.row[lane]}]);
                }
            }
        });
    }

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(m_batches, m_planned) + m_levels.GetMemoryBytes(); }

private:
    /// Fewer batches are not worth sharing; one takes some 50 to 100 ns.
    static int Least(const TaskPool& pool) { return pool.SharesAlways() ? 2 : 32; }

    /// False unless the joints have the places already that they would get.
    bool Refill(std::span<const JointIndex> joints, const BodyTable& bodies, const JointTable& table, TaskPool& pool) {
        if (m_batches.empty() || bodies.IsFar() || !std::ranges::equal(joints, m_planned)) return false;
        const size_t taken = m_levels.CountTaken();
        const auto isOfType = [&](JointIndex joint) { return table.info[joint].type == Row::type; };
        if (taken != joints.size() && static_cast<size_t>(std::ranges::count_if(joints, isOfType)) != taken)
            return false;
        return Fill(bodies, table, pool);
    }
    /// By the order of the plan. True if that was for what the batches were filled with before.
    bool Fill(const BodyTable& bodies, const JointTable& table, TaskPool& pool) {
        const std::span<const JointIndex> order = m_levels.GetOrder();
        bool isOther[maxWorkers] = {};
        ForAll(pool, [&](std::span<Batch> part, int begin, int worker) {
            for (size_t k = 0; k < part.size(); ++k) {
                const auto own = order.subspan((ToSize(begin) + k) * jointBatchSize, jointBatchSize);
                isOther[worker] = !FillBatch(own, bodies, table, part[k]) || isOther[worker];
            }
        });
        return std::ranges::none_of(isOther, std::identity());
    }
    /// True if its joints would be where they are.
    static bool FillBatch(std::span<const JointIndex> order, const BodyTable& bodies, const JointTable& table,
                          Batch& batch) {
        bool stays = true;
        for (size_t lane = 0; lane < jointBatchSize; ++lane) {
            const bool isSpare = IsNone(order[lane]);
            const JointInfo& info = table.info[isSpare ? order[0] : order[lane]];
            if (info.type != Row::type) return false;
            const MassRow &massA = bodies.mass[info.bodyA], &massB = bodies.mass[info.bodyB];
            stays = stays && batch.bodyA[lane] == ToInt(info.bodyA) && batch.bodyB[lane] == ToInt(info.bodyB) &&
                    (batch.invMassA[lane] > 0.0f) == JointLevels::IsPushed(info.bodyA, bodies) &&
                    (batch.invMassB[lane] > 0.0f) == JointLevels::IsPushed(info.bodyB, bodies) &&
                    JointLevels::PaysToTurn(info, bodies);
            PutBodies({info, massA, massB, isSpare}, lane, batch);
            Traits::Fill(table.Store<Row>().rows[info.row], massA, massB, lane, batch);
        }
        return stays;
    }
    static bool Correct(std::span<Batch> part, const JointStep& step, BodyTable& bodies, Column<JointRow, Row>& rows) {
        bool isOff = false;
        const JointLaneTask<Batch> task = Task(step, bodies, part);
        for (const Batch& batch : part) {
            for (uint32_t left = Traits::Kernels().findOutOfRange(task, batch); left != 0; left &= left - 1) {
                const auto lane = static_cast<size_t>(std::countr_zero(left));
                if (batch.row[lane] < 0) continue;
                const BodyIndex a{batch.bodyA[lane]}, b{batch.bodyB[lane]};
                const JointPair pair{a, b, bodies.mass[a], bodies.mass[b]};
                isOff = !Traits::Correct(batch, lane, pair, step, bodies, rows[JointRow{batch.row[lane]}]) || isOff;
            }
        }
        return !isOff;
    }
    /// Calls visit(batches, number of the first, worker) for parts of all batches, in any order.
    template <typename Visit>
    void ForAll(TaskPool& pool, Visit&& visit) {
        pool.For(static_cast<int>(m_batches.size()), Least(pool), [&](int begin, int end, int worker) {
            visit(std::span(m_batches).subspan(ToSize(begin), ToSize(end - begin)), begin, worker);
        });
    }
    /// Calls visit(batches, worker) for all batches, those that follow on each other in their order.
    template <typename Visit>
    void ForSections(TaskPool& pool, Visit&& visit) {
        if (!pool.IsOpen()) return visit(std::span(m_batches), 0);
        const std::span<const JointSection> sections = m_levels.GetSections();
        const auto endOf = [&](size_t i) { return ToSize(sections[i].end); };
        const auto part = [&](size_t begin, size_t end) { return std::span(m_batches).subspan(begin, end - begin); };
        for (size_t i = 0, begin = 0; i < sections.size(); begin = endOf(i - 1)) {
            const size_t first = i;
            const Sharing sharing = sections[i++].sharing;
            while (sharing == Sharing::whole && i < sections.size() && sections[i].sharing == sharing) ++i;
            const size_t count = endOf(i - 1) - begin;
            if (sharing == Sharing::none || count < ToSize(Least(pool))) {
                visit(part(begin, endOf(i - 1)), 0);
            } else if (sharing == Sharing::parted) {
                pool.For(static_cast<int>(count), 2, [&](int from, int to, int worker) {
                    visit(part(begin + ToSize(from), begin + ToSize(to)), worker);
                });
            } else {
                pool.For(static_cast<int>(i - first), 2, [&](int from, int to, int worker) {
                    const size_t at = first + ToSize(from);
                    visit(part(at == first ? begin : endOf(at - 1), endOf(first + ToSize(to) - 1)), worker);
                });
            }
        }
    }
    [[nodiscard]] static JointLaneTask<Batch> Task(const JointStep& step, BodyTable& bodies, std::span<Batch> batches) {
        static_assert(sizeof(Position) == 4 * sizeof(float) && sizeof(Velocity) == 4 * sizeof(float));
        return {.batches = batches.data(),
                .count = static_cast<int32_t>(batches.size()),
                .position = &bodies.position.data()->c.x,
                .velocity = &bodies.velocity.data()->v.x,
                .dt = step.dt,
                .inverseDt = step.inverseDt,
                .impulseScale = step.impulseScale,
                .slop = Traits::Slop(step)};
    }

    std::vector<Batch> m_batches;
    JointLevels m_levels;
    std::vector<JointIndex> m_planned;  ///< the list for which these are
    bool m_acts = false;
};

}  // namespace scree
