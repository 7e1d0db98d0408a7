// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The direct solve of joints whose bodies form trees, statics not counted: chains, bridges between fixed points,
// mobiles, ragdolls, cars. Four joints that do not depend on each other are taken side by side. Each hands its parent
// the mobility that is left to it. So a tree takes time in proportion to its joints, however many meet in a body.
// Sources: Featherstone, "A Divide-and-Conquer Articulated-Body Algorithm", Int. J. Robotics Research 18, 1999.
// Drumwright, "Fast Dynamic Simulation of Highly Articulated Robots with Contact via Θ(n²) Time Dense Generalized
// Inertia Matrix Inversion", 2012. The same system as that of the forest beside it.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "constraints/joint_batch_kernels.h"
#include "constraints/joint_tree_rows.h"
#include "constraints/load_bearers.h"

namespace scree {

/// A joint that may be taken over.
struct TreeEdge {
    JointIndex joint;
    BodyIndex bodyA, bodyB;
    bool movesA, movesB;
    TreeKind kind;
    int shape;            ///< index of its shape in Refresh
    bool isTree = false;  ///< it was

    /// Gives the same plan.
    [[nodiscard]] bool IsLike(const TreeEdge& other) const {
        return joint == other.joint && bodyA == other.bodyA && bodyB == other.bodyB && movesA == other.movesA &&
               movesB == other.movesB && kind == other.kind;
    }
};

struct TreeCourse;

/// What may change from step to step.
struct TreeInput {
    std::span<const TreeShape> shapes;  ///< read until the next call
    double recentScale;                 ///< makes impulses of a sub-step of the stored ones
    double compliance;                  ///< jointCompliance
    const LoadBearers* bearers;         ///< null: none
};

/// What a solve of some batches needs besides them. Of one solve nothing is left for the next, so a worker has one of
/// these for all that it solves, and it stays in the cache.
struct JointBatchScratch {
    std::vector<BodyRow> aimed, next, mobility, shift, impulse;
    std::vector<LaneRow> nextAngle, left;
    std::vector<SolveNotes<2>> points;
    std::vector<SolveNotes<rowLimit>> rows;

    void Ensure(size_t bodyCount, size_t pointCount, size_t rowCount);
    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(aimed, next, mobility, shift, impulse, nextAngle, left, points, rows);
    }
};

class JointBatches {
public:
    /// Takes over the links whose bodies form trees, and puts them into an order that stays until the next call.
    void Plan(std::span<TreeEdge> links);
    /// For links like those that were planned, whose shapes have other indices.
    void Renumber(std::span<const TreeEdge> links);
    void Refresh(const BodyTable& bodies, const JointTable& joints, const TreeInput& input);
    [[nodiscard]] bool IsEmpty() const { return m_order.empty(); }
    /// Makes room in a scratch: later steps are not to allocate because another worker has these batches.
    void EnsureRoom(JointBatchScratch& scratch) const {
        scratch.Ensure(m_bodies.size(), m_points.size(), m_rows.size());
    }
    [[nodiscard]] size_t GetMemoryBytes() const;

    // As of JointTree; the scratch has room.
    void Factorize(const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, double h,
                   JointBatchScratch& scratch);
    void SolveBeforeMove(Column<BodyIndex, Velocity>& velocity, JointBatchScratch& scratch);
    void SolveAfterMove(Column<BodyIndex, Velocity>& velocity, JointBatchScratch& scratch);

    /// Calls visit(const TreeResult&) for each joint.
    template <typename Visit>
    void ForEachResult(Visit&& visit) const {
        TreeRows ofKernels{};  // as far as they leave any
        for (const Place& place : m_places) {
            double impulse[maxTreeRows] = {};
            ofKernels.count = RowCount(place.kind);
            const auto lane = ToSize(place.lane);
            if (place.isPoint) {
                const PointBatch& batch = m_points[ToSize(place.batch)];
                const double sign = place.childIsB ? 1.0 : -1.0;
                for (int i = 0; i < 2; ++i) impulse[i] = sign * batch.total[i].v[lane];
            } else {
                const RowBatch& batch = m_rows[ToSize(place.batch)];
                for (int i = 0; i < batch.count; ++i) impulse[i] = batch.total[i].v[lane];
                if (place.isLine) ofKernels.axisX = batch.axis[0].v[lane], ofKernels.axisY = batch.axis[1].v[lane];
            }
            const TreeRows& rows = place.other >= 0 ? m_others[ToSize(place.other)].rows : ofKernels;
            const TreeResult::Side child = SideOf(place.child), parent = SideOf(place.parent);
            visit(TreeResult{place.joint, m_shapes[ToSize(place.shape)], rows, impulse, place.childIsB ? parent : child,
                             place.childIsB ? child : parent});
        }
    }

private:
    /// Where a joint is.
    struct Place {
        int shape;
        JointIndex joint;
        int batch, lane;
        TreeKind kind;
        bool isPoint, isLine;
        bool childIsB;
        int child, parent;  ///< rows of bodies
        int other;          ///< in m_others, −1: a point or on a line
    };
    /// Neither a point nor on a line.
    struct Other {
        int place;
        TreeRows rows;
    };

    int AddRow(BodyIndex body);
    [[nodiscard]] TreeResult::Side SideOf(int row) const {
        const double(&mass)[4] = m_mass[ToSize(row)].v;
        return {m_bodies[ToSize(row)], mass[0], mass[1]};
    }
    void PutIntoLanes();
    void ListRootsAndOthers();
    static void SetLine(const Place& place, const TreeShape& s, RowBatch& batch);
    [[nodiscard]] JointBatchTask Task(JointBatchScratch& scratch);
    template <typename SpinOf>
    void LoadVelocities(const Column<BodyIndex, Velocity>& velocity, SpinOf&& spinOf);
    void StoreVelocities(Column<BodyIndex, Velocity>& velocity) const;
    void MakeJacobians();
    void MarkLoaded(const LoadBearers* bearers);
    [[nodiscard]] bool FindLoadedTrees();
    void FactorizeForVelocities(const JointBatchTask& task);
    void MeasureRows(const JointBatchTask& task) const;
    /// The most that the solve leaves, as `left` of the task.
    [[nodiscard]] double AimAll(const JointBatchTask& task) const;
    [[nodiscard]] std::vector<TreeCourse> MeasureTrees(const JointBatchTask& task) const;
    [[nodiscard]] bool GiveWay(const JointBatchTask& task, double compliance) const;

    std::vector<BodyIndex> m_bodies;  ///< per row: the body, −1: none; statics have a row for each joint
    std::vector<Place> m_places;
    std::vector<Other> m_others;
    std::span<const TreeShape> m_shapes;
    std::vector<PointBatch> m_points;
    std::vector<RowBatch> m_rows;
    std::vector<int32_t> m_order, m_roots;
    std::vector<BodyRow> m_pose, m_course, m_velocity, m_mass;  ///< per row, as those of the task
    std::vector<LaneRow> m_stiffness;
    std::vector<int> m_tree;  ///< per row: the tree that it belongs to, by a row of that
    double m_h = 1.0, m_compliance = 0.0;
    std::vector<uint8_t> m_isLoaded;  ///< per row that stands for a tree: it bears a load; empty: none does
    std::vector<uint8_t> m_isChosen;  ///< of these, pulled ones; scratch
    std::vector<LaneRow> m_kept;      ///< stiffnesses, scratch
    bool m_isForVelocities = false;   ///< factors of some trees are not for aiming
};

}  // namespace scree
