// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Soft rows of joints, one joint after the other, colour by colour.

#include "constraints/joint_net.h"

#include <type_traits>

#include "constraints/joint_tree_factors.h"

namespace scree {

namespace {

Vec2 Gap(const TreeStart& a, Vec2 armA, const TreeStart& b, Vec2 armB) {
    return {static_cast<float>(b.x - a.x + (double{armB.x} - double{armA.x})),
            static_cast<float>(b.y - a.y + (double{armB.y} - double{armA.y}))};
}
Vec2 Anchor(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Few bodies turn far in a step.
Rot TurnOf(float angle) {
    if (Abs(angle) > 0.25f) return Rot(angle);
    const float square = angle * angle;
    Rot turn;
    turn.s = angle * (1.0f - square / 6.0f * (1.0f - square / 20.0f * (1.0f - square / 42.0f)));
    turn.c = 1.0f - square / 2.0f * (1.0f - square / 12.0f * (1.0f - square / 30.0f));
    return turn;
}

/// Of a symmetric mobility; none where rounding errors would decide.
template <typename Row>
void Invert(float xx, float xy, float yy, Row& row) {
    const float determinant = xx * yy - xy * xy;
    const float inverse = determinant > 1e-9f * xx * yy ? 1.0f / determinant : 0.0f;
    row.xx = inverse * yy, row.yy = inverse * xx, row.xy = -inverse * xy;
}
/// What would stop `speed`.
template <typename Row>
Vec2 Closing(const Row& row, Vec2 speed) {
    return {row.xx * speed.x + row.xy * speed.y, row.xy * speed.x + row.yy * speed.y};
}

/// Calls visit(item) for each, shared by the workers.
template <typename Items, typename Visit>
void ForEachOf(TaskPool& pool, Items& items, Visit&& visit) {
    constexpr int least = 512;
    pool.For(static_cast<int>(items.size()), least, [&](int begin, int end, int) {
        for (int i = begin; i < end; ++i) visit(items[ToSize(i)]);
    });
}

TreePose PoseOf(const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta, BodyIndex body) {
    const TreeStart start = StartOf(bodies, delta, body);
    TreePose pose;
    pose.x = start.x, pose.y = start.y, pose.angle = start.angle;
    const Rot& q = bodies.transform[body].q;
    Turn(double{q.c}, double{q.s}, start.turn, pose);
    return pose;
}

}  // namespace

size_t JointNet::GetMemoryBytes() const {
    return m_movers.capacity() * sizeof(Mover) + m_points.capacity() * sizeof(Point) +
           m_kept.capacity() * sizeof(KeptShape) + m_welds.capacity() * sizeof(Weld) + m_rods.capacity() * sizeof(Rod) +
           m_blocks.capacity() * sizeof(Block) + m_ends.capacity() * sizeof(ColourEnd) +
           m_rowOf.capacity() * sizeof(int);
}

/// A body that joints do not push has a row for each of them: workers write what they solve.
int JointNet::AddMover(const BodyTable& bodies, BodyIndex body, bool moves) {
    if (moves && m_rowOf[body] >= 0) return m_rowOf[body];
    const int row = static_cast<int>(m_movers.size());
    Mover& mover = m_movers.emplace_back();
    mover.body = body;
    if (!moves) return row;
    m_rowOf[body] = row;
    mover.invMass = bodies.mass[body].invMass, mover.invI = bodies.mass[body].invI;
    return row;
}

void JointNet::Take(const BodyTable& bodies, const JointTable& joints, std::span<const Member> members,
                    std::span<const TreeShape> shapes, double recentScale) {
    for (const Mover& mover : m_movers) m_rowOf[mover.body] = -1;
    m_movers.clear(), m_points.clear(), m_kept.clear(), m_welds.clear(), m_rods.clear(), m_blocks.clear(),
        m_ends.clear();
    m_substeps = 0;
    if (members.empty()) return;
    m_rowOf.resize(ToSize(bodies.slots.Size()), -1);
    const auto endColour = [&](int colour) {
        m_ends.push_back({colour, m_points.size(), m_welds.size(), m_rods.size(), m_blocks.size()});
    };
    for (size_t i = 0; i < members.size(); ++i) {
        const Member& member = members[i];
        if (i > 0 && member.colour != members[i - 1].colour) endColour(members[i - 1].colour);
        const int a = AddMover(bodies, member.bodyA, member.movesA), b = AddMover(bodies, member.bodyB, member.movesB);
        float impulse[maxTreeRows];
        RecallImpulse(member.joint, shapes[i], joints, static_cast<float>(recentScale), impulse);
        const TreeShape& shape = shapes[i];
        Anchors anchors{};
        anchors.a = a, anchors.b = b;
        anchors.startA = Mul(bodies.transform[member.bodyA].q, Anchor(shape.ax, shape.ay));
        anchors.startB = Mul(bodies.transform[member.bodyB].q, Anchor(shape.bx, shape.by));
        const auto add = [&](auto& rows) -> auto& {
            auto& row = rows.emplace_back();
            static_cast<Anchors&>(row) = anchors;
            return row;
        };
        switch (shape.kind) {
            case TreeKind::point:
                add(m_points).impulse = {impulse[0], impulse[1]};
                m_kept.push_back({member.joint, shape});
                break;
            case TreeKind::pointAndAngle: {
                Weld& weld = add(m_welds);
                weld.impulse = {impulse[0], impulse[1]}, weld.turnImpulse = impulse[2];
                weld.joint = member.joint, weld.shape = shape;
                break;
            }
            case TreeKind::rod: {
                Rod& rod = add(m_rods);
                rod.impulse = impulse[0];
                rod.joint = member.joint, rod.shape = shape;
                break;
            }
            case TreeKind::slide:
            case TreeKind::line: {
                Block& block = m_blocks.emplace_back();
                block.a = a, block.b = b, block.joint = member.joint, block.shape = shape;
                for (int k = 0; k < maxTreeRows; ++k) block.impulse[k] = impulse[k];
                break;
            }
        }
    }
    endColour(members.back().colour);
}

void JointNet::Load(TaskPool& pool, const Column<BodyIndex, Velocity>& delta, const BodyTable& bodies,
                    const Column<BodyIndex, Velocity>& velocity) {
    ForEachOf(pool, m_movers, [&](Mover& mover) {
        const Velocity& v = velocity[mover.body];
        mover.v = v.v, mover.w = v.w;
        const bool isStatic = bodies.type[mover.body] == staticBody;
        const Velocity motion = isStatic ? Velocity{} : delta[mover.body];
        mover.angle = motion.w;
        mover.turn = TurnOf(motion.w);
        mover.moved = motion.v;
    });
    if (m_substeps > 0) return;
    const auto startOf = [&](int row) { return StartOf(bodies, delta, m_movers[ToSize(row)].body); };
    const auto startGap = [&](const Anchors& anchors) {
        return Gap(startOf(anchors.a), anchors.startA, startOf(anchors.b), anchors.startB);
    };
    for (Point& point : m_points) point.startGap = startGap(point);
    for (Weld& weld : m_welds) {
        weld.startGap = startGap(weld);
        const double turned = startOf(weld.b).angle - startOf(weld.a).angle;
        weld.startTurn = static_cast<float>(turned - weld.shape.reference);
    }
    for (Rod& rod : m_rods) rod.startGap = startGap(rod);
}
void JointNet::Store(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) const {
    ForEachOf(pool, m_movers, [&](const Mover& mover) {
        if (mover.invMass == 0.0f && mover.invI == 0.0f) return;
        Velocity& v = velocity[mover.body];
        v.v = mover.v, v.w = mover.w;
    });
}

inline void JointNet::TurnArms(Anchors& anchors) const {
    anchors.armA = Mul(m_movers[ToSize(anchors.a)].turn, anchors.startA);
    anchors.armB = Mul(m_movers[ToSize(anchors.b)].turn, anchors.startB);
}
inline Vec2 JointNet::GapNow(const Anchors& anchors) const {
    const Vec2 moved = m_movers[ToSize(anchors.b)].moved - m_movers[ToSize(anchors.a)].moved;
    return anchors.startGap + moved + ((anchors.armB - anchors.startB) - (anchors.armA - anchors.startA));
}
inline Vec2 JointNet::SpeedNow(const Anchors& anchors) const {
    const Mover& a = m_movers[ToSize(anchors.a)];
    const Mover& b = m_movers[ToSize(anchors.b)];
    return (b.v + Cross(b.w, anchors.armB)) - (a.v + Cross(a.w, anchors.armA));
}

inline void JointNet::Prepare(Point& point) const {
    const Mover& a = m_movers[ToSize(point.a)];
    const Mover& b = m_movers[ToSize(point.b)];
    TurnArms(point);
    point.gap = GapNow(point);
    const float mass = a.invMass + b.invMass;
    const float xx = mass + a.invI * point.armA.y * point.armA.y + b.invI * point.armB.y * point.armB.y;
    const float yy = mass + a.invI * point.armA.x * point.armA.x + b.invI * point.armB.x * point.armB.x;
    const float xy = -a.invI * point.armA.x * point.armA.y - b.invI * point.armB.x * point.armB.y;
    Invert(xx, xy, yy, point);
}

/// All three rows at once: one after the other a weld of a light body to a heavy one would feed on the turning. With
/// the turning eliminated the anchors see the inertias of both bodies in a row.
inline void JointNet::Prepare(Weld& weld) const {
    const Mover& a = m_movers[ToSize(weld.a)];
    const Mover& b = m_movers[ToSize(weld.b)];
    TurnArms(weld);
    weld.gap = GapNow(weld);
    weld.turnError = weld.startTurn + (b.angle - a.angle);
    const float turning = a.invI + b.invI;
    weld.turnMass = turning > 0.0f ? 1.0f / turning : 0.0f;
    weld.lever = weld.turnMass * Cross(1.0f, a.invI * weld.armA + b.invI * weld.armB);
    const float mass = a.invMass + b.invMass, both = a.invI * weld.turnMass * b.invI;
    const Vec2 apart = weld.armA - weld.armB;
    Invert(mass + both * apart.y * apart.y, -both * apart.x * apart.y, mass + both * apart.x * apart.x, weld);
}

inline void JointNet::TurnAxis(Rod& rod) const {
    TurnArms(rod);
    const Vec2 gap = GapNow(rod);
    const float length = gap.Length();
    rod.axis = length > static_cast<float>(rod.shape.shortest) ? (1.0f / length) * gap : vec2Zero;
    rod.error = length - static_cast<float>(rod.shape.reference);
}

inline void JointNet::Prepare(Rod& rod) const {
    const Mover& a = m_movers[ToSize(rod.a)];
    const Mover& b = m_movers[ToSize(rod.b)];
    TurnAxis(rod);
    const float onA = Cross(rod.armA, rod.axis), onB = Cross(rod.armB, rod.axis);
    const float mobility = (a.invMass + b.invMass) * Dot(rod.axis, rod.axis) + a.invI * onA * onA + b.invI * onB * onB;
    rod.mass = mobility > 0.0f ? 1.0f / mobility : 0.0f;
}

void JointNet::Prepare(Block& block, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta) const {
    const Mover& a = m_movers[ToSize(block.a)];
    const Mover& b = m_movers[ToSize(block.b)];
    MakeRows<true>(block.shape, PoseOf(bodies, delta, a.body), PoseOf(bodies, delta, b.body), block.rows);
    block.rows.count = RowCount(block.shape.kind);
    double mobility[maxTreeRows][maxTreeRows] = {}, scale[maxTreeRows] = {};
    const auto product = [](const double(&i)[3], const double(&j)[3], const Mover& mover) {
        return double{mover.invMass} * (i[0] * j[0] + i[1] * j[1]) + double{mover.invI} * i[2] * j[2];
    };
    for (int i = 0; i < block.rows.count; ++i) {
        for (int j = 0; j < block.rows.count; ++j) {
            mobility[i][j] =
                product(block.rows.a[i], block.rows.a[j], a) + product(block.rows.b[i], block.rows.b[j], b);
        }
        scale[i] = mobility[i][i];
    }
    InvertRows(mobility, block.rows.count, scale);
    for (int i = 0; i < maxTreeRows; ++i) {
        for (int j = 0; j < maxTreeRows; ++j) block.inverse[i][j] = static_cast<float>(mobility[i][j]);
    }
}

inline void JointNet::Push(const Point& point, Vec2 impulse) {
    Mover& a = m_movers[ToSize(point.a)];
    Mover& b = m_movers[ToSize(point.b)];
    a.v -= a.invMass * impulse;
    a.w -= a.invI * Cross(point.armA, impulse);
    b.v += b.invMass * impulse;
    b.w += b.invI * Cross(point.armB, impulse);
}
inline void JointNet::Push(const Weld& weld, Vec2 impulse, float turnImpulse) {
    Mover& a = m_movers[ToSize(weld.a)];
    Mover& b = m_movers[ToSize(weld.b)];
    a.v -= a.invMass * impulse;
    a.w -= a.invI * (Cross(weld.armA, impulse) + turnImpulse);
    b.v += b.invMass * impulse;
    b.w += b.invI * (Cross(weld.armB, impulse) + turnImpulse);
}
inline void JointNet::Push(const Rod& rod, float impulse) {
    Mover& a = m_movers[ToSize(rod.a)];
    Mover& b = m_movers[ToSize(rod.b)];
    a.v -= (a.invMass * impulse) * rod.axis;
    a.w -= a.invI * impulse * Cross(rod.armA, rod.axis);
    b.v += (b.invMass * impulse) * rod.axis;
    b.w += b.invI * impulse * Cross(rod.armB, rod.axis);
}
void JointNet::Push(const Block& block, const float (&impulse)[maxTreeRows]) {
    Mover& a = m_movers[ToSize(block.a)];
    Mover& b = m_movers[ToSize(block.b)];
    for (int i = 0; i < block.rows.count; ++i) {
        const double(&rowA)[3] = block.rows.a[i];
        const double(&rowB)[3] = block.rows.b[i];
        a.v += a.invMass * impulse[i] * Anchor(rowA[0], rowA[1]);
        a.w += a.invI * impulse[i] * static_cast<float>(rowA[2]);
        b.v += b.invMass * impulse[i] * Anchor(rowB[0], rowB[1]);
        b.w += b.invI * impulse[i] * static_cast<float>(rowB[2]);
    }
}

inline void JointNet::Solve(Point& point, const Softness& soft) {
    const Vec2 closing = Closing(point, SpeedNow(point) + soft.biasRate * point.gap);
    const Vec2 impulse = -soft.massScale * closing - soft.impulseScale * point.impulse;
    Push(point, impulse);
    point.impulse += impulse;
}
inline void JointNet::Solve(Weld& weld, const Softness& soft) {
    const float turnSpeed = m_movers[ToSize(weld.b)].w - m_movers[ToSize(weld.a)].w + soft.biasRate * weld.turnError;
    const Vec2 speed = SpeedNow(weld) + soft.biasRate * weld.gap;
    const Vec2 closing = Closing(weld, speed - turnSpeed * weld.lever);
    const float turnClosing = weld.turnMass * turnSpeed - Dot(weld.lever, closing);
    const Vec2 impulse = -soft.massScale * closing - soft.impulseScale * weld.impulse;
    const float turnImpulse = -soft.massScale * turnClosing - soft.impulseScale * weld.turnImpulse;
    Push(weld, impulse, turnImpulse);
    weld.impulse += impulse, weld.turnImpulse += turnImpulse;
}
inline void JointNet::Solve(Rod& rod, const Softness& soft) {
    const float speed = Dot(rod.axis, SpeedNow(rod)) + soft.biasRate * rod.error;
    const float impulse = -soft.massScale * rod.mass * speed - soft.impulseScale * rod.impulse;
    Push(rod, impulse);
    rod.impulse += impulse;
}
void JointNet::Solve(Block& block, const Softness& soft) {
    const Mover& a = m_movers[ToSize(block.a)];
    const Mover& b = m_movers[ToSize(block.b)];
    const int count = block.rows.count;
    float speed[maxTreeRows] = {}, impulse[maxTreeRows] = {};
    for (int i = 0; i < count; ++i) {
        const double(&rowA)[3] = block.rows.a[i];
        const double(&rowB)[3] = block.rows.b[i];
        speed[i] = soft.biasRate * static_cast<float>(block.rows.error[i]) + Dot(Anchor(rowA[0], rowA[1]), a.v) +
                   static_cast<float>(rowA[2]) * a.w + Dot(Anchor(rowB[0], rowB[1]), b.v) +
                   static_cast<float>(rowB[2]) * b.w;
    }
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) impulse[i] -= soft.massScale * block.inverse[i][j] * speed[j];
        impulse[i] -= soft.impulseScale * block.impulse[i];
    }
    Push(block, impulse);
    for (int i = 0; i < count; ++i) block.impulse[i] += impulse[i];
}

template <typename Row, typename Visit>
void JointNet::ForEachRow(TaskPool& pool, std::vector<Row>& rows, size_t ColourEnd::*end, Visit&& visit) {
    constexpr int least = 512;
    size_t begin = 0;
    for (const ColourEnd& colour : m_ends) {
        const auto visitRange = [&, begin](int from, int to, int) {
            for (int i = from; i < to; ++i) visit(rows[begin + ToSize(i)]);
        };
        const int count = static_cast<int>(colour.*end - begin);
        begin = colour.*end;
        colour.colour < mostColours ? pool.For(count, least, visitRange) : visitRange(0, count, 0);
    }
}
template <typename Visit>
void JointNet::ForEachRow(TaskPool& pool, Visit&& visit) {
    ForEachRow(pool, m_points, &ColourEnd::points, visit);
    ForEachRow(pool, m_welds, &ColourEnd::welds, visit);
    ForEachRow(pool, m_rods, &ColourEnd::rods, visit);
    ForEachRow(pool, m_blocks, &ColourEnd::blocks, visit);
}

void JointNet::SolveBeforeMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                               float h, Column<BodyIndex, Velocity>& velocity) {
    constexpr float turns = 0.25f;  // of a spring in a sub-step
    constexpr float dampingRatio = 2.0f;
    constexpr float turn = 2.0f * pi * turns, damping = 2.0f * dampingRatio + turn;
    constexpr float impulseScale = 1.0f / (1.0f + turn * damping);
    const Softness soft{turn / (damping * h), 1.0f - impulseScale, impulseScale};
    Load(pool, delta, bodies, velocity);
    ForEachRow(pool, m_points, &ColourEnd::points, [&](Point& point) {
        Prepare(point);
        Push(point, point.impulse);
    });
    ForEachRow(pool, m_welds, &ColourEnd::welds, [&](Weld& weld) {
        Prepare(weld);
        Push(weld, weld.impulse, weld.turnImpulse);
    });
    ForEachRow(pool, m_rods, &ColourEnd::rods, [&](Rod& rod) {
        Prepare(rod);
        Push(rod, rod.impulse);
    });
    ForEachRow(pool, m_blocks, &ColourEnd::blocks, [&](Block& block) {
        Prepare(block, bodies, delta);
        Push(block, block.impulse);
    });
    ForEachRow(pool, [&](auto& row) { Solve(row, soft); });
    ++m_substeps;
    Store(pool, velocity);
}

void JointNet::SolveAfterMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                              Column<BodyIndex, Velocity>& velocity) {
    constexpr Softness rigid{0.0f, 1.0f, 0.0f};
    Load(pool, delta, bodies, velocity);
    // The mobility of points and welds changes little in a sub-step.
    const auto renew = [&](auto& row) {
        using Row = std::remove_cvref_t<decltype(row)>;
        if constexpr (std::is_same_v<Row, Block>) {
            Prepare(row, bodies, delta);
        } else if constexpr (std::is_same_v<Row, Rod>) {
            TurnAxis(row);
        } else {
            TurnArms(row);
        }
    };
    ForEachRow(pool, [&](auto& row) {
        renew(row);
        Solve(row, rigid);
    });
    Store(pool, velocity);
}

}  // namespace scree
