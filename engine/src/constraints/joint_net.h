// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints of nets, which are too much coupled for a direct solve: soft rows, solved one after the other. Before the move
// they also close what is open, as springs as stiff as the sub-steps carry. After it they take that speed out again
// (Catto, "Solver2D", 2024: soft constraints with relaxation).

#pragma once

#include <span>
#include <vector>

#include "base/task_pool.h"
#include "constraints/joint_tree_rows.h"

namespace scree {

class JointNet {
public:
    struct Member {
        JointIndex joint;
        BodyIndex bodyA, bodyB;
        bool movesA, movesB;
    };
    /// Joints to hold from now on, and their constants by the same places. `recentScale` makes impulses of a sub-step
    /// of those that joints keep.
    void Take(const BodyTable& bodies, const JointTable& joints, std::span<const Member> members,
              std::span<const TreeShape> shapes, double recentScale);
    [[nodiscard]] bool IsEmpty() const { return m_points.empty() && m_rods.empty() && m_blocks.empty(); }
    [[nodiscard]] size_t GetMemoryBytes() const;

    [[nodiscard]] bool Holds(BodyIndex body) const {
        return ToSize(ToInt(body)) < m_rowOf.size() && m_rowOf[body] >= 0;
    }
    /// At the present poses. Velocities are those that all forces of a sub-step of `h` seconds lead to.
    void SolveBeforeMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, float h,
                         Column<BodyIndex, Velocity>& velocity);
    void SolveAfterMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                        Column<BodyIndex, Velocity>& velocity);

    /// Calls visit(const TreeResult&) for each joint, with the impulses of the step.
    template <typename Visit>
    void ForEachResult(Visit&& visit) const {
        const auto side = [&](int row) {
            const Mover& b = m_movers[ToSize(row)];
            return TreeResult::Side{b.body, double{b.invMass}, double{b.invI}};
        };
        TreeRows rows{};
        rows.count = 2;
        for (size_t i = 0; i < m_points.size(); ++i) {
            const Point& p = m_points[i];
            const double impulse[maxTreeRows] = {double{p.total.x}, double{p.total.y}, double{p.turnTotal}};
            visit(TreeResult{m_kept[i].joint, m_kept[i].shape, rows, impulse, side(p.a), side(p.b)});
        }
        rows.count = 1;
        for (const Rod& rod : m_rods) {
            rows.axisX = double{rod.axis.x}, rows.axisY = double{rod.axis.y};
            const double impulse[maxTreeRows] = {double{rod.total}, 0.0, 0.0};
            visit(TreeResult{rod.joint, rod.shape, rows, impulse, side(rod.a), side(rod.b)});
        }
        for (const Block& block : m_blocks) {
            double impulse[maxTreeRows];
            for (int i = 0; i < maxTreeRows; ++i) impulse[i] = double{block.total[i]};
            visit(TreeResult{block.joint, block.shape, block.rows, impulse, side(block.a), side(block.b)});
        }
    }

private:
    struct Mover {
        BodyIndex body;
        float invMass, invI;  ///< 0 if joints cannot push it
        Vec2 v;
        float w;
        float angle;  ///< turned since the start of the step, rad
        Rot turn;     ///< the same
        Vec2 moved;   ///< since then, m
    };
    /// Two anchors together, and maybe no turning.
    struct Point {
        int a, b;             ///< rows of the bodies
        Vec2 startA, startB;  ///< arms at the start of the step, in world coordinates
        Vec2 startGap;        ///< from A's anchor to B's then
        Vec2 armA, armB;      ///< now
        Vec2 gap;             ///< m
        float xx, xy, yy;     ///< inverse of the mobility
        Vec2 impulse;         ///< of a sub-step
        Vec2 total;           ///< of the step so far
        float turnMass;       ///< inverse of the mobility of turning; 0: it is free
        float startTurn;      ///< error of the angle at the start of the step, rad
        float turnError, turnImpulse, turnTotal;
    };
    /// The distance of two anchors.
    struct Rod {
        int a, b;
        Vec2 startA, startB, startGap;
        Vec2 armA, armB;
        Vec2 axis;    ///< from A's anchor to B's; none while it is shorter than the shape allows
        float error;  ///< m
        float mass;   ///< inverse of the mobility
        float impulse, total;
        JointIndex joint;
        TreeShape shape;
    };
    struct KeptShape {
        JointIndex joint;
        TreeShape shape;
    };
    /// Any other kind of joint.
    struct Block {
        int a, b;
        JointIndex joint;
        TreeShape shape;
        TreeRows rows;
        float inverse[maxTreeRows][maxTreeRows];
        float impulse[maxTreeRows], total[maxTreeRows];
    };

    struct Softness {
        float biasRate, massScale, impulseScale;
    };

    int AddMover(const BodyTable& bodies, BodyIndex body, bool moves);
    void Load(TaskPool& pool, const Column<BodyIndex, Velocity>& delta, const BodyTable& bodies,
              const Column<BodyIndex, Velocity>& velocity);
    void Store(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) const;
    void TurnArms(Point& point) const;
    void Prepare(Point& point) const;
    void TurnAxis(Rod& rod) const;
    void Prepare(Rod& rod) const;
    void Prepare(Block& block, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta) const;
    void Push(const Point& point, Vec2 impulse);
    void Push(const Point& point, float turnImpulse);
    void Push(const Rod& rod, float impulse);
    void Push(const Block& block, const float (&impulse)[maxTreeRows]);
    void Solve(Point& point, const Softness& soft);
    void Solve(Rod& rod, const Softness& soft);
    void Solve(Block& block, const Softness& soft);

    std::vector<Mover> m_movers;
    std::vector<Point> m_points;
    std::vector<KeptShape> m_kept;  ///< of the points
    std::vector<Rod> m_rods;
    std::vector<Block> m_blocks;
    Column<BodyIndex, int> m_rowOf;  ///< per body of the world, −1: none
    bool m_isFirst = true;           ///< no solve yet in this step
};

}  // namespace scree
