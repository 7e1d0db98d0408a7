// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Soft rows of joints, one joint after the other.

#include "constraints/joint_net.h"

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
           m_kept.capacity() * sizeof(KeptShape) + m_rods.capacity() * sizeof(Rod) +
           m_blocks.capacity() * sizeof(Block) + m_rowOf.capacity() * sizeof(int);
}

int JointNet::AddMover(const BodyTable& bodies, BodyIndex body, bool moves) {
    int& row = m_rowOf[body];
    if (row >= 0) return row;
    row = static_cast<int>(m_movers.size());
    const MassRow& mass = bodies.mass[body];
    Mover& mover = m_movers.emplace_back();
    mover.body = body;
    mover.invMass = moves ? mass.invMass : 0.0f, mover.invI = moves ? mass.invI : 0.0f;
    return row;
}

void JointNet::Take(const BodyTable& bodies, const JointTable& joints, std::span<const Member> members,
                    std::span<const TreeShape> shapes, double recentScale) {
    for (const Mover& mover : m_movers) m_rowOf[mover.body] = -1;
    m_movers.clear(), m_points.clear(), m_kept.clear(), m_rods.clear(), m_blocks.clear();
    m_isFirst = true;
    if (members.empty()) return;
    m_rowOf.resize(ToSize(bodies.slots.Size()), -1);
    for (size_t i = 0; i < members.size(); ++i) {
        const Member& member = members[i];
        const int a = AddMover(bodies, member.bodyA, member.movesA), b = AddMover(bodies, member.bodyB, member.movesB);
        float impulse[maxTreeRows];
        RecallImpulse(member.joint, shapes[i], joints, static_cast<float>(recentScale), impulse);
        const TreeShape& shape = shapes[i];
        const Vec2 startA = Mul(bodies.transform[member.bodyA].q, Anchor(shape.ax, shape.ay));
        const Vec2 startB = Mul(bodies.transform[member.bodyB].q, Anchor(shape.bx, shape.by));
        switch (shape.kind) {
            case TreeKind::point:
            case TreeKind::pointAndAngle: {
                Point& point = m_points.emplace_back();
                point.a = a, point.b = b, point.startA = startA, point.startB = startB;
                point.impulse = {impulse[0], impulse[1]};
                point.total = {0.0f, 0.0f};
                const float mobility = m_movers[ToSize(a)].invI + m_movers[ToSize(b)].invI;
                const bool turns = shape.kind == TreeKind::point || mobility <= 0.0f;
                point.turnMass = turns ? 0.0f : 1.0f / mobility;
                point.turnImpulse = turns ? 0.0f : impulse[2];
                point.startTurn = point.turnError = point.turnTotal = 0.0f;
                m_kept.push_back({member.joint, shape});
                break;
            }
            case TreeKind::rod: {
                Rod& rod = m_rods.emplace_back();
                rod.a = a, rod.b = b, rod.startA = startA, rod.startB = startB;
                rod.impulse = impulse[0], rod.total = 0.0f;
                rod.axis = {0.0f, 0.0f};
                rod.joint = member.joint, rod.shape = shape;
                break;
            }
            case TreeKind::slide:
            case TreeKind::line: {
                Block& block = m_blocks.emplace_back();
                block.a = a, block.b = b, block.joint = member.joint, block.shape = shape;
                for (int k = 0; k < maxTreeRows; ++k) block.impulse[k] = impulse[k], block.total[k] = 0.0f;
                break;
            }
        }
    }
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
    if (!m_isFirst) return;
    m_isFirst = false;
    const auto startOf = [&](int row) { return StartOf(bodies, delta, m_movers[ToSize(row)].body); };
    for (size_t i = 0; i < m_points.size(); ++i) {
        Point& point = m_points[i];
        const TreeStart startA = startOf(point.a), startB = startOf(point.b);
        point.startGap = Gap(startA, point.startA, startB, point.startB);
        if (point.turnMass > 0.0f)
            point.startTurn = static_cast<float>(startB.angle - startA.angle - m_kept[i].shape.reference);
    }
    for (Rod& rod : m_rods) rod.startGap = Gap(startOf(rod.a), rod.startA, startOf(rod.b), rod.startB);
}
void JointNet::Store(TaskPool& pool, Column<BodyIndex, Velocity>& velocity) const {
    ForEachOf(pool, m_movers, [&](const Mover& mover) {
        if (mover.invMass == 0.0f && mover.invI == 0.0f) return;
        Velocity& v = velocity[mover.body];
        v.v = mover.v, v.w = mover.w;
    });
}

inline void JointNet::TurnArms(Point& point) const {
    point.armA = Mul(m_movers[ToSize(point.a)].turn, point.startA);
    point.armB = Mul(m_movers[ToSize(point.b)].turn, point.startB);
}

inline void JointNet::Prepare(Point& point) const {
    const Mover& a = m_movers[ToSize(point.a)];
    const Mover& b = m_movers[ToSize(point.b)];
    TurnArms(point);
    point.gap = point.startGap + (b.moved - a.moved) + ((point.armB - point.startB) - (point.armA - point.startA));
    point.turnError = point.startTurn + (b.angle - a.angle);
    const float mass = a.invMass + b.invMass;
    const float xx = mass + a.invI * point.armA.y * point.armA.y + b.invI * point.armB.y * point.armB.y;
    const float yy = mass + a.invI * point.armA.x * point.armA.x + b.invI * point.armB.x * point.armB.x;
    const float xy = -a.invI * point.armA.x * point.armA.y - b.invI * point.armB.x * point.armB.y;
    const float determinant = xx * yy - xy * xy;
    const float inverse = determinant > 1e-9f * xx * yy ? 1.0f / determinant : 0.0f;
    point.xx = inverse * yy, point.yy = inverse * xx, point.xy = -inverse * xy;
}

inline void JointNet::TurnAxis(Rod& rod) const {
    const Mover& a = m_movers[ToSize(rod.a)];
    const Mover& b = m_movers[ToSize(rod.b)];
    rod.armA = Mul(a.turn, rod.startA), rod.armB = Mul(b.turn, rod.startB);
    const Vec2 gap = rod.startGap + (b.moved - a.moved) + ((rod.armB - rod.startB) - (rod.armA - rod.startA));
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
inline void JointNet::Push(const Point& point, float turnImpulse) {
    m_movers[ToSize(point.a)].w -= m_movers[ToSize(point.a)].invI * turnImpulse;
    m_movers[ToSize(point.b)].w += m_movers[ToSize(point.b)].invI * turnImpulse;
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
    const Mover& a = m_movers[ToSize(point.a)];
    const Mover& b = m_movers[ToSize(point.b)];
    if (point.turnMass > 0.0f) {
        const float turnSpeed = b.w - a.w + soft.biasRate * point.turnError;
        const float turnImpulse = -soft.massScale * point.turnMass * turnSpeed - soft.impulseScale * point.turnImpulse;
        Push(point, turnImpulse);
        point.turnImpulse += turnImpulse;
    }
    const Vec2 speed = (b.v + Cross(b.w, point.armB)) - (a.v + Cross(a.w, point.armA)) + soft.biasRate * point.gap;
    const Vec2 closing{point.xx * speed.x + point.xy * speed.y, point.xy * speed.x + point.yy * speed.y};
    const Vec2 impulse = -soft.massScale * closing - soft.impulseScale * point.impulse;
    Push(point, impulse);
    point.impulse += impulse;
}
inline void JointNet::Solve(Rod& rod, const Softness& soft) {
    const Mover& a = m_movers[ToSize(rod.a)];
    const Mover& b = m_movers[ToSize(rod.b)];
    const float speed =
        Dot(rod.axis, (b.v + Cross(b.w, rod.armB)) - (a.v + Cross(a.w, rod.armA))) + soft.biasRate * rod.error;
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

void JointNet::SolveBeforeMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                               float h, Column<BodyIndex, Velocity>& velocity) {
    constexpr float turns = 0.25f;  // of a spring in a sub-step
    constexpr float dampingRatio = 2.0f;
    constexpr float turn = 2.0f * pi * turns, damping = 2.0f * dampingRatio + turn;
    constexpr float impulseScale = 1.0f / (1.0f + turn * damping);
    const Softness soft{turn / (damping * h), 1.0f - impulseScale, impulseScale};
    Load(pool, delta, bodies, velocity);
    // Pushes come in order, what they push with is made side by side.
    const bool isShared = pool.IsOpen();
    if (isShared) ForEachOf(pool, m_points, [this](Point& point) { Prepare(point); });
    for (Point& point : m_points) {
        if (!isShared) Prepare(point);
        Push(point, point.impulse);
        if (point.turnMass > 0.0f) Push(point, point.turnImpulse);
    }
    for (Rod& rod : m_rods) {
        Prepare(rod);
        Push(rod, rod.impulse);
    }
    for (Block& block : m_blocks) {
        Prepare(block, bodies, delta);
        Push(block, block.impulse);
    }
    for (Point& point : m_points) Solve(point, soft);
    for (Rod& rod : m_rods) Solve(rod, soft);
    for (Block& block : m_blocks) Solve(block, soft);
    Store(pool, velocity);
}

void JointNet::SolveAfterMove(TaskPool& pool, const BodyTable& bodies, const Column<BodyIndex, Velocity>& delta,
                              Column<BodyIndex, Velocity>& velocity) {
    constexpr Softness rigid{0.0f, 1.0f, 0.0f};
    Load(pool, delta, bodies, velocity);
    for (Point& point : m_points) {
        TurnArms(point);  // the mobility changes little in a sub-step
        Solve(point, rigid);
        point.total += point.impulse;
        point.turnTotal += point.turnImpulse;
    }
    for (Rod& rod : m_rods) {
        TurnAxis(rod);
        Solve(rod, rigid);
        rod.total += rod.impulse;
    }
    for (Block& block : m_blocks) {
        Prepare(block, bodies, delta);
        Solve(block, rigid);
        for (int i = 0; i < maxTreeRows; ++i) block.total[i] += block.impulse[i];
    }
    Store(pool, velocity);
}

}  // namespace scree
