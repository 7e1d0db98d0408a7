// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contact constraints in the form the solver iterates over, for one island at a time. Sequential impulses with warm
// starting (Catto, "Iterative Dynamics with Temporal Coherence", GDC 2005). Two-point manifolds are solved as one
// block: the 2×2 linear complementarity problem by enumeration of its four cases. The position pass is separate
// (non-linear projected Gauss-Seidel, as Box2D 2.4 does it).

#pragma once

#include <span>
#include <vector>

#include "scree/collision.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// One contact point of a velocity constraint.
struct ContactPointRow {
    Vec2 rA, rB;  ///< from the centres of mass
    float normalImpulse, tangentImpulse;
    float normalMass, tangentMass;
    float velocityBias;  ///< restitution, m/s
};

/// One contact in the velocity pass.
struct ContactVelocityRow {
    BodyIndex bodyA, bodyB;
    ContactIndex contact;
    int pointCount;
    float invMassA, invMassB, invIA, invIB;
    Vec2 normal;
    float friction, tangentSpeed;
    /// Effective mass of the two normals together: K and its inverse; only if `block`.
    float k11, k12, k22;
    float inv11, inv12, inv22;
    bool block;
    ContactPointRow points[maxManifoldPoints];
};

/// One contact in the position pass, in local coordinates because the bodies move between iterations.
struct ContactPositionRow {
    BodyIndex bodyA, bodyB;
    MassRow massA, massB;
    Vec2 localNormal, localPoint;
    Vec2 localPoints[maxManifoldPoints];
    float radius;  ///< of both shapes together
    int pointCount;
    Manifold::Type type;
};

/// Scratch of the contact solver, reused from island to island.
struct ContactRows {
    std::vector<ContactVelocityRow> velocity;
    std::vector<ContactPositionRow> position;
};

struct ContactPrepareInput {
    const BodyTable& bodies;
    const FixtureTable& fixtures;
    const ContactTable& contacts;
    std::span<const ContactIndex> island;  ///< contacts to prepare, in order
    float impulseScale;                    ///< dt / last dt; 0 without warm starting
    bool restitution = true;               ///< some contact may bounce
    bool atOutlines = false;               ///< as in BlockInput
    float lengthScale = 1.0f;
};

/// Fills `rows` for contacts of one or more islands from the bodies' present positions and velocities.
void PrepareContacts(const ContactPrepareInput& input, ContactRows& rows);
/// Applies the impulses of the last step.
void WarmStartContacts(const ContactRows& rows, Column<BodyIndex, Velocity>& velocity);
/// One iteration over all contacts: friction, then normals. Without `friction` no contact has any.
void SolveContactVelocities(ContactRows& rows, Column<BodyIndex, Velocity>& velocity, bool friction = true);
/// Sum of the normal impulses of the contact with this position in the list.
inline float GetPressure(const ContactRows& rows, int at) {
    const ContactVelocityRow& row = rows.velocity[ToSize(at)];
    float pressure = 0.0f;
    for (int i = 0; i < row.pointCount; ++i) pressure += row.points[i].normalImpulse;
    return pressure;
}
/// Writes the impulses back into the manifolds.
void StoreContactImpulses(const ContactRows& rows, Column<ContactIndex, Manifold>& manifold);
/// How overlaps are removed.
struct PushApart {
    float share = baumgarte;   ///< of the overlap beyond one slop, in one iteration
    float lengthScale = 1.0f;  ///< factor on slop and largest push
};
/// One iteration of position correction; returns the smallest separation seen, m.
float SolveContactPositions(const ContactRows& rows, BodyTable& bodies, const PushApart& how = {});

}  // namespace scree
