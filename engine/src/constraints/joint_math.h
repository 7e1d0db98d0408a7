// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Building blocks of joints for sequential impulses (Catto, "Iterative Dynamics with Temporal Coherence", 2005). They
// are one row of a Jacobian, a shared point as a 2×2 block, one-sided limits, bounded motors, and springs. Springs are
// soft constraints (Catto, "Soft Constraints: Reinventing the Spring", GDC 2011).

#pragma once

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "base/compiler.h"
#include "state/bodies.h"
#include "state/frames.h"
#include "state/joints.h"

namespace scree {

/// What joints need to know of a step.
struct JointStep {
    float dt, inverseDt;
    float impulseScale;  ///< of warm starting: dt / last dt, 0 without
    float slop;          ///< position error that counts as none, m
    /// Into how many solves the time step falls, and which of them this is. In a soft step each has two parts, before
    /// and after the move.
    int substeps = 1, substep = 0;
    int parts = 1;

    [[nodiscard]] static JointStep Half(float dt, int substeps, int substep, float impulseScale, float slop) {
        const float h = dt / static_cast<float>(substeps);
        return {0.5f * h, 1.0f / h, impulseScale, slop, substeps, substep, 2};
    }
    /// Of a share of something that is to go in a time step: what goes in this solve of what is left. Exact where it is
    /// known once in each.
    [[nodiscard]] float ShareNow(float share) const {
        return share / (static_cast<float>(substeps) - share * static_cast<float>(substep));
    }
};

/// What Prepare reads.
struct JointInput {
    const JointStep& step;
    const BodyTable& bodies;
    const JointInfo& info;
};

/// The two bodies of a joint.
struct JointPair {
    BodyIndex a, b;
    MassRow massA, massB;
};

/// Velocities or positions of both while they are being changed.
template <typename T>
struct PairState {
    T a, b;
};
using PairVelocity = PairState<Velocity>;
using PairPosition = PairState<Position>;  ///< in the frame of the pair

inline JointPair MakePair(const JointInput& in) {
    return {in.info.bodyA, in.info.bodyB, in.bodies.mass[in.info.bodyA], in.bodies.mass[in.info.bodyB]};
}

/// Whether impulses move any of the two.
inline bool IsMoved(const JointPair& p) {
    return p.massA.invMass > 0.0f || p.massA.invI > 0.0f || p.massB.invMass > 0.0f || p.massB.invI > 0.0f;
}

inline PairPosition PoseOf(const JointPair& p, const BodyTable& bodies) {
    const Vec2 frame = FrameOf(bodies, p.a, p.b);
    return {PositionIn(frame, bodies, p.a), PositionIn(frame, bodies, p.b)};
}

/// Number by number: the next joint reads what this one wrote, and a wide read of narrow writes has to wait for them.
inline void Copy(const Velocity& from, Velocity& to) { to.v.x = from.v.x, to.v.y = from.v.y, to.w = from.w; }
inline void Copy(const Position& from, Position& to) { to.c.x = from.c.x, to.c.y = from.c.y, to.a = from.a; }

template <typename T>
SCREE_INLINE PairState<T> Load(const JointPair& p, const Column<BodyIndex, T>& column) {
    PairState<T> state;
    Copy(column[p.a], state.a);
    Copy(column[p.b], state.b);
    return state;
}

/// Bodies without mass are not written: they cannot change, and many joints may share one.
template <typename T>
SCREE_INLINE void Store(const JointPair& p, const PairState<T>& state, Column<BodyIndex, T>& column) {
    if (p.massA.invMass > 0.0f) Copy(state.a, column[p.a]);
    if (p.massB.invMass > 0.0f) Copy(state.b, column[p.b]);
}

/// Only how they turn: the rest is neither read nor written.
SCREE_INLINE PairVelocity LoadTurning(const JointPair& p, const Column<BodyIndex, Velocity>& column) {
    PairVelocity v{};
    v.a.w = column[p.a].w, v.b.w = column[p.b].w;
    return v;
}
SCREE_INLINE void StoreTurning(const JointPair& p, const PairVelocity& v, Column<BodyIndex, Velocity>& column) {
    if (p.massA.invMass > 0.0f) column[p.a].w = v.a.w;
    if (p.massB.invMass > 0.0f) column[p.b].w = v.b.w;
}

/// Positions in the frame of the pair.
SCREE_INLINE PairPosition Load(const JointPair& p, const BodyTable& bodies) {
    return bodies.IsFar() ? PoseOf(p, bodies) : Load(p, bodies.position);
}
inline void StoreFar(const JointPair& p, const PairPosition& pose, BodyTable& bodies) {
    const Vec2 frame = FrameOf(bodies, p.a, p.b);
    if (p.massA.invMass > 0.0f) StorePosition(frame, pose.a, p.a, bodies);
    if (p.massB.invMass > 0.0f) StorePosition(frame, pose.b, p.b, bodies);
}
SCREE_INLINE void Store(const JointPair& p, const PairPosition& pose, BodyTable& bodies) {
    bodies.IsFar() ? StoreFar(p, pose, bodies) : Store(p, pose, bodies.position);
}

SCREE_INLINE void ApplyImpulse(const MassRow& mass, Vec2 impulse, float turn, Velocity& body) {
    body.v += mass.invMass * impulse;
    body.w += mass.invI * turn;
}
SCREE_INLINE void ApplyImpulse(const MassRow& mass, Vec2 impulse, float turn, Position& body) {
    body.c += mass.invMass * impulse;
    body.a += mass.invI * turn;
}
SCREE_INLINE void Turn(const MassRow& mass, float turn, Velocity& body) { body.w += mass.invI * turn; }
SCREE_INLINE void Turn(const MassRow& mass, float turn, Position& body) { body.a += mass.invI * turn; }

/// Impulses of the last step as the first guess of this one. What is not finite would stay so for ever: start anew.
inline float Scaled(float impulse, float scale) { return std::isfinite(impulse) ? impulse * scale : 0.0f; }
inline Vec2 Scaled(Vec2 impulse, float scale) { return impulse.IsValid() ? scale * impulse : vec2Zero; }

/// 1 / x, 0 for 0: nothing moves where there is no mass to move.
inline float InverseOrZero(float x) { return x > 0.0f ? 1.0f / x : 0.0f; }

/// The arms of both anchors from the centres of mass, and how far apart the anchors are.
struct Arms {
    Vec2 a, b;
    Vec2 gap;  ///< from A's anchor to B's
};
inline Arms MakeArms(const JointPair& p, const PairPosition& pose, const Rot& turnA, Vec2 localAnchorA,
                     Vec2 localAnchorB) {
    const Vec2 a = Mul(turnA, localAnchorA - p.massA.localCenter);
    const Vec2 b = Mul(Rot(pose.b.a), localAnchorB - p.massB.localCenter);
    return {a, b, pose.b.c + b - pose.a.c - a};
}
inline Arms MakeArms(const JointPair& p, const PairPosition& pose, Vec2 localAnchorA, Vec2 localAnchorB) {
    return MakeArms(p, pose, Rot(pose.a.a), localAnchorA, localAnchorB);
}

/// One row of a Jacobian: its speed is axis·(vB − vA) + armB·wB − armA·wA.
struct AxisRow {
    Vec2 axis{0.0f, 0.0f};
    float armA = 0.0f, armB = 0.0f;
};

/// Relative turning: the row with no axis and arms of 1.
struct TurnRow {
    operator AxisRow() const { return {{0.0f, 0.0f}, 1.0f, 1.0f}; }  // NOLINT(google-explicit-constructor)
};
inline constexpr TurnRow turning{};

/// Sliding along an axis that is fixed in A: A's arm reaches to B's anchor.
inline AxisRow MakeSlide(const Arms& arms, Vec2 axis) {
    return {axis, Cross(arms.gap + arms.a, axis), Cross(arms.b, axis)};
}

SCREE_INLINE float Speed(const AxisRow& row, const PairVelocity& v) {
    return Dot(row.axis, v.b.v - v.a.v) + row.armB * v.b.w - row.armA * v.a.w;
}
SCREE_INLINE float Speed(TurnRow, const PairVelocity& v) { return v.b.w - v.a.w; }

/// 1 / (effective mass) of two rows against each other; of one row for i = j.
inline float Coupling(const JointPair& p, const AxisRow& i, const AxisRow& j) {
    return (p.massA.invMass + p.massB.invMass) * Dot(i.axis, j.axis) + p.massA.invI * i.armA * j.armA +
           p.massB.invI * i.armB * j.armB;
}
inline float InverseMass(const JointPair& p, const AxisRow& row) { return Coupling(p, row, row); }
inline float InverseMass(const JointPair& p, TurnRow) { return p.massA.invI + p.massB.invI; }

template <typename T>
SCREE_INLINE void Apply(const JointPair& p, const AxisRow& row, float impulse, PairState<T>& state) {
    ApplyImpulse(p.massA, -impulse * row.axis, -impulse * row.armA, state.a);
    ApplyImpulse(p.massB, impulse * row.axis, impulse * row.armB, state.b);
}
template <typename T>
SCREE_INLINE void Apply(const JointPair& p, TurnRow, float impulse, PairState<T>& state) {
    Turn(p.massA, -impulse, state.a);
    Turn(p.massB, impulse, state.b);
}

/// Both anchors together: an impulse at the point, equal and opposite.
template <typename T>
SCREE_INLINE void ApplyPoint(const JointPair& p, const Arms& arms, Vec2 impulse, PairState<T>& state) {
    ApplyImpulse(p.massA, -impulse, -Cross(arms.a, impulse), state.a);
    ApplyImpulse(p.massB, impulse, Cross(arms.b, impulse), state.b);
}
SCREE_INLINE Vec2 PointSpeed(const Arms& arms, const PairVelocity& v) {
    return v.b.v + Cross(v.b.w, arms.b) - v.a.v - Cross(v.a.w, arms.a);
}
/// Inverse effective mass of the point.
inline Mat22 PointMatrix(const JointPair& p, const Arms& arms) {
    const float m = p.massA.invMass + p.massB.invMass;
    const float iA = p.massA.invI, iB = p.massB.invI;
    Mat22 k;
    k.ex.x = m + iA * arms.a.y * arms.a.y + iB * arms.b.y * arms.b.y;
    k.ex.y = -iA * arms.a.x * arms.a.y - iB * arms.b.x * arms.b.y;
    k.ey.x = k.ex.y;
    k.ey.y = m + iA * arms.a.x * arms.a.x + iB * arms.b.x * arms.b.x;
    return k;
}

/// Adds to an accumulated impulse that may only push (≥ 0); returns the change. A gap ≥ 0 may be closed within the step
/// but not beyond.
SCREE_INLINE float SolveLimit(float& accumulated, float speed, float gap, float inverseDt, float mass) {
    const float total = Max(accumulated - mass * (speed + Max(gap, 0.0f) * inverseDt), 0.0f);
    const float change = total - accumulated;
    accumulated = total;
    return change;
}

/// The exponent of a normal number above 0; 0 of others.
SCREE_INLINE int ExponentOf(float x) {
    return x >= std::numeric_limits<float>::min() ? (std::bit_cast<int>(x) >> 23) - 127 : 0;
}
/// 2 to the power of −126…127. Products with it have the digits of the other factor: what may leave the range of
/// numbers is brought near 1 by them.
SCREE_INLINE float PowerOfTwo(int exponent) { return std::bit_cast<float>((exponent + 127) << 23); }

/// Adds to an accumulated impulse of either sign, at most `most`; returns the change.
SCREE_INLINE float SolveBounded(float& accumulated, float impulse, float most) {
    const float total = Clamp(accumulated + impulse, -most, most);
    const float change = total - accumulated;
    accumulated = total;
    return change;
}
/// The same for a vector, by its length.
SCREE_INLINE Vec2 SolveBounded(Vec2& accumulated, Vec2 impulse, float most) {
    Vec2 total = accumulated + impulse;
    const float squared = total.LengthSquared();
    if (squared > 0x1p-100f && squared < 0x1p100f) {
        if (squared > most * most) total *= most / std::sqrt(squared);
    } else {  // squares are out of range
        const float scale = PowerOfTwo(-Min(ExponentOf(Max(Abs(total.x), Abs(total.y))), 126));
        const float scaled = (scale * total).LengthSquared(), bound = scale * most;
        if (scaled > bound * bound) total *= bound / std::sqrt(scaled);
    }
    const Vec2 change = total - accumulated;
    accumulated = total;
    return change;
}

/// A spring in one row, as an implicit Euler step: the row gives way by gamma per unit of impulse.
struct Spring {
    float gamma = 0.0f;
    float bias = 0.0f;  ///< m/s or rad/s
    float mass = 0.0f;  ///< effective, of the softened row
};
struct SpringInput {
    float stiffness, damping;
    float error;        ///< of the coordinate, m or rad
    float inverseMass;  ///< of the rigid row
};
inline Spring MakeSpring(const SpringInput& in, float dt) {
    Spring s;
    s.gamma = InverseOrZero(dt * (in.damping + dt * in.stiffness));
    s.bias = in.error * dt * in.stiffness * s.gamma;
    s.mass = InverseOrZero(in.inverseMass + s.gamma);
    return s;
}
/// Adds to the accumulated impulse, which gets at most `most`; returns the change.
SCREE_INLINE float SolveSpring(const Spring& spring, float speed, float& accumulated,
                               float most = std::numeric_limits<float>::infinity()) {
    const float change = -spring.mass * (speed + spring.bias + spring.gamma * accumulated);
    if (most < std::numeric_limits<float>::infinity()) return SolveBounded(accumulated, change, most);
    accumulated += change;
    return change;
}

/// A symmetric matrix; rows and columns x, y, z.
struct Symmetric3 {
    float xx, xy, xz, yy, yz, zz;
};
struct Three {
    float x, y, z;
};
/// A symmetric matrix whose rows have units of their own, with a diagonal brought near 1 by powers of two. Determinants
/// of others leave the range of numbers where masses or lengths are far from 1.
struct Scaled2 {
    Mat22 k;
    float x, y;  ///< what rows and columns are multiplied by
};
struct Scaled3 {
    Symmetric3 k;
    float x, y, z;
};
/// Brings an entry of the diagonal near 1, from both sides.
inline float ScaleOf(float diagonal) { return PowerOfTwo(-(ExponentOf(diagonal) >> 1)); }
inline Scaled2 Scale(const Mat22& k) {
    const float x = ScaleOf(k.ex.x), y = ScaleOf(k.ey.y), mixed = x * k.ex.y * y;
    return {{{x * k.ex.x * x, mixed}, {mixed, y * k.ey.y * y}}, x, y};
}
inline Scaled3 Scale(const Symmetric3& k) {
    const float x = ScaleOf(k.xx), y = ScaleOf(k.yy), z = ScaleOf(k.zz);
    return {{x * k.xx * x, x * k.xy * y, x * k.xz * z, y * k.yy * y, y * k.yz * z, z * k.zz * z}, x, y, z};
}
/// By Cramer's rule. Zero for a singular matrix.
inline Vec2 Solve(const Scaled2& a, Vec2 b) {
    const Vec2 x = a.k.Solve({a.x * b.x, a.y * b.y});
    return {a.x * x.x, a.y * x.y};
}
inline Three Solve(const Scaled3& a, const Three& b) {
    const Symmetric3& m = a.k;
    const float x = a.x * b.x, y = a.y * b.y, z = a.z * b.z;
    const float cx = m.yy * m.zz - m.yz * m.yz;
    const float cy = m.xz * m.yz - m.xy * m.zz;
    const float cz = m.xy * m.yz - m.xz * m.yy;
    float det = m.xx * cx + m.xy * cy + m.xz * cz;
    if (det != 0.0f) det = 1.0f / det;
    const float dyy = m.xx * m.zz - m.xz * m.xz;
    const float dyz = m.xy * m.xz - m.xx * m.yz;
    const float dzz = m.xx * m.yy - m.xy * m.xy;
    return {a.x * (det * (cx * x + cy * y + cz * z)), a.y * (det * (cy * x + dyy * y + dyz * z)),
            a.z * (det * (cz * x + dyz * y + dzz * z))};
}

/// How far a coordinate is outside its range, with its sign: what the position iterations remove. A range narrower than
/// two slops counts as a single value.
inline float LimitError(const LimitState& limit, float coordinate, float slop) {
    if (limit.upper - limit.lower < 2.0f * slop) return coordinate - limit.lower;
    return coordinate - Clamp(coordinate, limit.lower, limit.upper);
}

/// Prepares the spring of a row with this coordinate; the impulse of the last step as the step scales it.
inline Spring PrepareSpring(SpringState& state, float coordinate, float inverseMass, const JointStep& step) {
    const bool acts = state.enabled && state.stiffness > 0.0f && inverseMass > 0.0f;
    state.impulse = acts ? Scaled(state.impulse, step.impulseScale) : 0.0f;
    if (!acts) return {};
    return MakeSpring({state.stiffness, state.damping, coordinate - state.target, inverseMass}, step.dt);
}

inline void ClearLimit(LimitState& limit) { limit.lowerImpulse = limit.upperImpulse = 0.0f; }
inline void ScaleLimit(LimitState& limit, float scale) {
    limit.lowerImpulse = Scaled(limit.lowerImpulse, scale);
    limit.upperImpulse = Scaled(limit.upperImpulse, scale);
}

struct LimitInput {
    float coordinate;  ///< at the start of the step
    float mass;        ///< effective, of the row
    float inverseDt;
};
/// Solves both ends of a limited row. Most often neither pushes.
template <typename Row>
SCREE_INLINE void SolveLimits(const JointPair& p, const Row& row, LimitState& limit, PairVelocity& v,
                              const LimitInput& in) {
    float speed = Speed(row, v);
    const float lower = SolveLimit(limit.lowerImpulse, speed, in.coordinate - limit.lower, in.inverseDt, in.mass);
    if (lower != 0.0f) {
        Apply(p, row, lower, v);
        speed = Speed(row, v);
    }
    const float upper = SolveLimit(limit.upperImpulse, -speed, limit.upper - in.coordinate, in.inverseDt, in.mass);
    if (upper != 0.0f) Apply(p, row, -upper, v);
}

}  // namespace scree
