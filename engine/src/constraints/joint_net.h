// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints of nets, which are too much coupled for a direct solve: soft rows, solved one after the other. Joints of one
// colour have no body in common, so workers share them. Before the move
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
        int colour;  ///< two joints of one colour below mostColours push no body in common
    };
    static constexpr int mostColours = 64;  ///< what is left over has this one
    /// Joints to hold from now on, in rising colours, and their constants by the same places. `recentScale` makes
    /// impulses of a sub-step of those that joints keep.
    void Take(const BodyTable& bodies, const JointTable& joints, std::span<const Member> members,
              std::span<const TreeShape> shapes, double recentScale);
    [[nodiscard]] bool IsEmpty() const {
        return m_points.empty() && m_welds.empty() && m_rods.empty() && m_blocks.empty();
    }
    [[nodiscard]] size_t GetMemoryBytes() const;

    [[nodiscard]] bool Holds(BodyIndex body) const {
        return ToSize(ToInt(body)) < m_rowOf.size() && m_rowOf[body] >= 0;
    }
    /// At the present poses. Velocities are those that all forces of a sub-step of `h` seconds lead to.
    void SolveBeforeMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, float h,
                         Column<BodyIndex, Velocity>& velocity);
    void SolveAfterMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                        Column<BodyIndex, Velocity>& velocity);

    /// Calls visit(const TreeResult&) for each joint, with the impulses of the step. They are those of the last
    /// sub-step as often as there were sub-steps: rows start from them again, and the mean would be late by half a
    /// step.
    template <typename Visit>
    void ForEachResult(Visit&& visit) const {
        const auto side = [&](int row) {
            const Mover& b = m_movers[ToSize(row)];
            return TreeResult::Side{b.body, double{b.invMass}, double{b.invI}};
        };
        const double times = m_substeps;
        TreeRows rows{};
        rows.count = 2;
        for (size_t i = 0; i < m_points.size(); ++i) {
            const Point& p = m_points[i];
            const double impulse[maxTreeRows] = {times * double{p.impulse.x}, times * double{p.impulse.y}, 0.0};
            visit(TreeResult{m_kept[i].joint, m_kept[i].shape, rows, impulse, side(p.a), side(p.b)});
        }
        rows.count = 3;
        for (const Weld& weld : m_welds) {
            const double impulse[maxTreeRows] = {times * double{weld.impulse.x}, times * double{weld.impulse.y},
                                                 times * double{weld.turnImpulse}};
            visit(TreeResult{weld.joint, weld.shape, rows, impulse, side(weld.a), side(weld.b)});
        }
        rows.count = 1;
        for (const Rod& rod : m_rods) {
            rows.axisX = double{rod.axis.x}, rows.axisY = double{rod.axis.y};
            const double impulse[maxTreeRows] = {times * double{rod.impulse}, 0.0, 0.0};
            visit(TreeResult{rod.joint, rod.shape, rows, impulse, side(rod.a), side(rod.b)});
        }
        for (const Block& block : m_blocks) {
            double impulse[maxTreeRows];
            for (int i = 0; i < maxTreeRows; ++i) impulse[i] = times * double{block.impulse[i]};
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
    /// One anchor on each body.
    struct Anchors {
        int a, b;             ///< rows of the bodies
        Vec2 startA, startB;  ///< arms at the start of the step, in world coordinates
        Vec2 startGap;        ///< from A's anchor to B's then
        Vec2 armA, armB;      ///< now
    };
    /// Two anchors together.
    struct Point : Anchors {
        Vec2 gap;          ///< m
        float xx, xy, yy;  ///< inverse of the mobility
        Vec2 impulse;      ///< of a sub-step
    };
    /// Two anchors together, and no turning.
    struct Weld : Anchors {
        Vec2 gap;          ///< m
        float startTurn;   ///< error of the angle at the start of the step, rad
        float turnError;   ///< rad
        float xx, xy, yy;  ///< inverse of the mobility of the anchors while the turning is stopped too
        float turnMass;    ///< inverse of the mobility of turning
        Vec2 lever;        ///< speed of the anchors by that of turning, m
        Vec2 impulse;      ///< of a sub-step
        float turnImpulse;
        JointIndex joint;
        TreeShape shape;
    };
    /// The distance of two anchors.
    struct Rod : Anchors {
        Vec2 axis;    ///< from A's anchor to B's; none while it is shorter than the shape allows
        float error;  ///< m
        float mass;   ///< inverse of the mobility
        float impulse;
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
        float impulse[maxTreeRows];
    };

    /// How many rows there are of each kind up to the end of a colour.
    struct ColourEnd {
        int colour;
        size_t points, welds, rods, blocks;
    };

    struct Softness {
        float biasRate, massScale, impulseScale;
    };

    /// Calls visit(row) for each row, colour by colour, each shared by the workers.
    template <typename Row, typename Visit>
    void ForEachRow(TaskPool& pool, std::vector<Row>& rows, size_t ColourEnd::*end, Visit&& visit);
    template <typename Visit>
    void ForEachRow(TaskPool& pool, Visit&& visit);
    int AddMover(const BodyTable& bodies, BodyIndex body, bool moves);
    void Load(TaskPool& pool, const Column<BodyIndex, Velocity>& delta, const BodyTable& bodies,
              const Column<BodyIndex, Velocity>& velocity);
    void Store(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) const;
    void TurnArms(Anchors& anchors) const;
    [[nodiscard]] Vec2 GapNow(const Anchors& anchors) const;
    [[nodiscard]] Vec2 SpeedNow(const Anchors& anchors) const;
    void Prepare(Point& point) const;
    void Prepare(Weld& weld) const;
    void TurnAxis(Rod& rod) const;
    void Prepare(Rod& rod) const;
    void Prepare(Block& block, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta) const;
    void Push(const Point& point, Vec2 impulse);
    void Push(const Weld& weld, Vec2 impulse, float turnImpulse);
    void Push(const Rod& rod, float impulse);
    void Push(const Block& block, const float (&impulse)[maxTreeRows]);
    void Solve(Point& point, const Softness& soft);
    void Solve(Weld& weld, const Softness& soft);
    void Solve(Rod& rod, const Softness& soft);
    void Solve(Block& block, const Softness& soft);

    std::vector<Mover> m_movers;
    std::vector<Point> m_points;
    std::vector<KeptShape> m_kept;  ///< of the points
    std::vector<Weld> m_welds;
    std::vector<Rod> m_rods;
    std::vector<Block> m_blocks;
    std::vector<ColourEnd> m_ends;   ///< rows of each kind lie by colour
    Column<BodyIndex, int> m_rowOf;  ///< per body of the world, −1: none
    int m_substeps = 0;              ///< solved in this step
};

}  // namespace scree
