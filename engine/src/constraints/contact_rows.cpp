// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Preparation, warm start and velocity iterations of contact constraints.

#include "constraints/contact_rows.h"

#include "base/compiler.h"
#include "constraints/contact_block.h"
#include "geometry/outline.h"
#include "state/frames.h"

namespace scree {

namespace {

// Forced inline: at -O2 the call costs a tenth of the whole solve.
SCREE_INLINE void ApplyImpulse(Velocity& a, Velocity& b, const ContactVelocityRow& row, const ContactPointRow& point,
                               Vec2 impulse) {
    a.v -= row.invMassA * impulse;
    a.w -= row.invIA * Cross(point.rA, impulse);
    b.v += row.invMassB * impulse;
    b.w += row.invIB * Cross(point.rB, impulse);
}

SCREE_INLINE Vec2 RelativeVelocity(const Velocity& a, const Velocity& b, const ContactPointRow& point) {
    return b.v + Cross(b.w, point.rB) - a.v - Cross(a.w, point.rA);
}

/// Effective mass of one point along a direction.
float EffectiveMass(const ContactVelocityRow& row, const ContactPointRow& point, Vec2 direction) {
    const float crossA = Cross(point.rA, direction);
    const float crossB = Cross(point.rB, direction);
    const float k = row.invMassA + row.invMassB + row.invIA * crossA * crossA + row.invIB * crossB * crossB;
    return k > 0.0f ? 1.0f / k : 0.0f;
}

void PrepareBlock(ContactVelocityRow& row) {
    row.block = row.pointCount == 2;
    if (!row.block) return;
    const float a1 = Cross(row.points[0].rA, row.normal), b1 = Cross(row.points[0].rB, row.normal);
    const float a2 = Cross(row.points[1].rA, row.normal), b2 = Cross(row.points[1].rB, row.normal);
    const float invMass = row.invMassA + row.invMassB;
    row.k11 = invMass + row.invIA * a1 * a1 + row.invIB * b1 * b1;
    row.k22 = invMass + row.invIA * a2 * a2 + row.invIB * b2 * b2;
    row.k12 = invMass + row.invIA * a1 * a2 + row.invIB * b1 * b2;
    float det = row.k11 * row.k22 - row.k12 * row.k12;
    if (row.k11 * row.k11 < maxConditionNumber * det) {
        det = 1.0f / det;
        row.inv11 = det * row.k22;
        row.inv12 = -det * row.k12;
        row.inv22 = det * row.k11;
    } else {
        row.block = false;
        row.pointCount = 1;  // the points coincide for the solver
    }
}

ContactPositionRow MakePositionRow(const ContactPrepareInput& in, ContactIndex contact, float radius) {
    const ContactPair& pair = in.contacts.pair[contact];
    const Manifold& m = in.contacts.manifold[contact];
    ContactPositionRow row;
    row.bodyA = pair.bodyA;
    row.bodyB = pair.bodyB;
    row.massA = in.bodies.mass[pair.bodyA];
    row.massB = in.bodies.mass[pair.bodyB];
    row.localNormal = m.localNormal;
    row.localPoint = m.localPoint;
    row.radius = radius;
    row.pointCount = m.pointCount;
    row.type = m.type;
    for (int i = 0; i < m.pointCount; ++i) row.localPoints[i] = m.points[i].localPoint;
    return row;
}

ContactVelocityRow MakeVelocityRow(const ContactPrepareInput& in, ContactIndex contact, float radiusA, float radiusB) {
    const ContactPair& pair = in.contacts.pair[contact];
    const Manifold& m = in.contacts.manifold[contact];
    const ContactMaterial& material = in.contacts.material[contact];
    const MassRow& massA = in.bodies.mass[pair.bodyA];
    const MassRow& massB = in.bodies.mass[pair.bodyB];
    const Velocity& velocityA = in.bodies.velocity[pair.bodyA];
    const Velocity& velocityB = in.bodies.velocity[pair.bodyB];

    WorldManifold world;
    const Vec2 frame = FrameOf(in.bodies, pair.bodyA, pair.bodyB);
    const Vec2 centreA = CentreIn(frame, in.bodies, pair.bodyA), centreB = CentreIn(frame, in.bodies, pair.bodyB);
    world.Initialize(&m, TransformIn(frame, in.bodies, pair.bodyA), radiusA, TransformIn(frame, in.bodies, pair.bodyB),
                     radiusB);

    ContactVelocityRow row;
    row.bodyA = pair.bodyA;
    row.bodyB = pair.bodyB;
    row.contact = contact;
    row.pointCount = m.pointCount;
    row.invMassA = massA.invMass;
    row.invMassB = massB.invMass;
    row.invIA = massA.invI;
    row.invIB = massB.invI;
    row.normal = world.normal;
    row.friction = material.friction;
    row.tangentSpeed = material.tangentSpeed;
    const Vec2 tangent = Cross(row.normal, 1.0f);
    for (int i = 0; i < m.pointCount; ++i) {
        ContactPointRow& p = row.points[i];
        p.normalImpulse = in.impulseScale * m.points[i].normalImpulse;
        p.tangentImpulse = in.impulseScale * m.points[i].tangentImpulse;
        p.rA = world.points[i] - centreA;
        p.rB = world.points[i] - centreB;
        p.normalMass = EffectiveMass(row, p, row.normal);
        p.tangentMass = EffectiveMass(row, p, tangent);
        p.velocityBias = 0.0f;
        if (!in.restitution) continue;
        const float closing = Dot(row.normal, RelativeVelocity(velocityA, velocityB, p));
        p.velocityBias = closing < -material.restitutionThreshold ? -material.restitution * closing : 0.0f;
    }
    PrepareBlock(row);
    return row;
}

inline void SolveFriction(ContactVelocityRow& row, Velocity& a, Velocity& b) {
    const Vec2 tangent = Cross(row.normal, 1.0f);
    for (int i = 0; i < row.pointCount; ++i) {
        ContactPointRow& p = row.points[i];
        const float speed = Dot(RelativeVelocity(a, b, p), tangent) - row.tangentSpeed;
        const float limit = row.friction * p.normalImpulse;
        const float total = Clamp(p.tangentImpulse - p.tangentMass * speed, -limit, limit);
        const float change = total - p.tangentImpulse;
        p.tangentImpulse = total;
        ApplyImpulse(a, b, row, p, change * tangent);
    }
}

inline void SolveNormal(ContactVelocityRow& row, ContactPointRow& p, Velocity& a, Velocity& b) {
    const float speed = Dot(RelativeVelocity(a, b, p), row.normal);
    const float total = Max(p.normalImpulse - p.normalMass * (speed - p.velocityBias), 0.0f);
    const float change = total - p.normalImpulse;
    p.normalImpulse = total;
    ApplyImpulse(a, b, row, p, change * row.normal);
}

/// The total impulses x ≥ 0 with normal speeds K·x + q ≥ 0 and x·(K·x + q) = 0. The four cases (both push, only one,
/// none) are tried in that order; with none found (rounding) the impulses stay as they are.
inline bool SolveBlockProblem(const ContactVelocityRow& row, Vec2 q, Vec2& x) {
    x = {-(row.inv11 * q.x + row.inv12 * q.y), -(row.inv12 * q.x + row.inv22 * q.y)};
    if (x.x >= 0.0f && x.y >= 0.0f) return true;
    x = {-row.points[0].normalMass * q.x, 0.0f};
    if (x.x >= 0.0f && row.k12 * x.x + q.y >= 0.0f) return true;
    x = {0.0f, -row.points[1].normalMass * q.y};
    if (x.y >= 0.0f && row.k12 * x.y + q.x >= 0.0f) return true;
    x = vec2Zero;
    return q.x >= 0.0f && q.y >= 0.0f;
}

inline void SolveBlock(ContactVelocityRow& row, Velocity& a, Velocity& b) {
    ContactPointRow& p1 = row.points[0];
    ContactPointRow& p2 = row.points[1];
    const Vec2 old{p1.normalImpulse, p2.normalImpulse};
    Vec2 q{Dot(RelativeVelocity(a, b, p1), row.normal) - p1.velocityBias,
           Dot(RelativeVelocity(a, b, p2), row.normal) - p2.velocityBias};
    q -= {row.k11 * old.x + row.k12 * old.y, row.k12 * old.x + row.k22 * old.y};
    Vec2 total;
    if (!SolveBlockProblem(row, q, total)) return;
    const Vec2 change = total - old;
    p1.normalImpulse = total.x;
    p2.normalImpulse = total.y;
    const Vec2 impulse1 = change.x * row.normal;
    const Vec2 impulse2 = change.y * row.normal;
    a.v -= row.invMassA * (impulse1 + impulse2);
    a.w -= row.invIA * (Cross(p1.rA, impulse1) + Cross(p2.rA, impulse2));
    b.v += row.invMassB * (impulse1 + impulse2);
    b.w += row.invIB * (Cross(p1.rB, impulse1) + Cross(p2.rB, impulse2));
}

void PrepareRange(const ContactPrepareInput& input, size_t begin, size_t end, ContactRows& rows) {
    const auto radiusOf = [&](FixtureIndex fixture) {
        const Shape& shape = *input.fixtures.shape[fixture];
        return input.atOutlines ? OutlineRadius(shape, input.lengthScale) : shape.m_radius;
    };
    for (size_t i = begin; i < end; ++i) {
        const ContactIndex contact = input.island[i];
        const ContactPair& pair = input.contacts.pair[contact];
        const float radiusA = radiusOf(pair.fixtureA), radiusB = radiusOf(pair.fixtureB);
        rows.velocity[i] = MakeVelocityRow(input, contact, radiusA, radiusB);
        rows.position[i] = MakePositionRow(input, contact, radiusA + radiusB);
    }
}

}  // namespace

void PrepareContacts(const ContactPrepareInput& input, ContactRows& rows) {
    rows.velocity.resize(input.island.size());
    rows.position.resize(input.island.size());
    PrepareRange(input, 0, input.island.size(), rows);
}

void WarmStartContacts(const ContactRows& rows, Column<BodyIndex, Velocity>& velocity) {
    for (const ContactVelocityRow& row : rows.velocity) {
        Velocity& stateA = velocity[row.bodyA];
        Velocity& stateB = velocity[row.bodyB];
        Velocity a = stateA;
        Velocity b = stateB;
        const Vec2 tangent = Cross(row.normal, 1.0f);
        for (int i = 0; i < row.pointCount; ++i) {
            const ContactPointRow& p = row.points[i];
            ApplyImpulse(a, b, row, p, p.normalImpulse * row.normal + p.tangentImpulse * tangent);
        }
        if (row.invMassA > 0.0f) stateA = a;
        if (row.invMassB > 0.0f) stateB = b;
    }
}

void SolveContactVelocities(ContactRows& rows, Column<BodyIndex, Velocity>& velocity, bool friction) {
    for (ContactVelocityRow& row : rows.velocity) {
        Velocity& stateA = velocity[row.bodyA];
        Velocity& stateB = velocity[row.bodyB];
        Velocity a = stateA;
        Velocity b = stateB;
        if (friction) SolveFriction(row, a, b);
        if (row.block) {
            SolveBlock(row, a, b);
        } else {
            for (int i = 0; i < row.pointCount; ++i) SolveNormal(row, row.points[i], a, b);
        }
        // Bodies without mass are not written: what blows up must not reach the ground, which others stand on.
        if (row.invMassA > 0.0f) stateA = a;
        if (row.invMassB > 0.0f) stateB = b;
    }
}

void StoreContactImpulses(const ContactRows& rows, Column<ContactIndex, Manifold>& manifold) {
    for (const ContactVelocityRow& row : rows.velocity) {
        Manifold& m = manifold[row.contact];
        for (int i = 0; i < row.pointCount; ++i) {
            m.points[i].normalImpulse = row.points[i].normalImpulse;
            m.points[i].tangentImpulse = row.points[i].tangentImpulse;
        }
    }
}

}  // namespace scree
