// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The position pass of contacts: pushes overlapping bodies apart by a share of the overlap. It does not touch
// velocities, so no energy is added. It evaluates the manifold anew at the corrected poses in every iteration.

#include "base/compiler.h"
#include "constraints/contact_rows.h"
#include "state/frames.h"

namespace scree {

namespace {

struct ContactSample {
    Vec2 normal, point;
    float separation;
};

/// Normal, point and separation of one manifold point at the present poses.
SCREE_INLINE ContactSample Evaluate(const ContactPositionRow& row, const Transform& xfA, const Transform& xfB,
                                    int index) {
    ContactSample out;
    switch (row.type) {
        case Manifold::e_circles: {
            const Vec2 a = Mul(xfA, row.localPoint);
            const Vec2 b = Mul(xfB, row.localPoints[0]);
            out.normal = b - a;
            out.normal.Normalize();
            out.point = 0.5f * (a + b);
            out.separation = Dot(b - a, out.normal) - row.radius;
            return out;
        }
        case Manifold::e_faceA: {
            out.normal = Mul(xfA.q, row.localNormal);
            out.point = Mul(xfB, row.localPoints[index]);
            out.separation = Dot(out.point - Mul(xfA, row.localPoint), out.normal) - row.radius;
            return out;
        }
        default: {
            const Vec2 faceNormal = Mul(xfB.q, row.localNormal);
            out.point = Mul(xfA, row.localPoints[index]);
            out.separation = Dot(out.point - Mul(xfB, row.localPoint), faceNormal) - row.radius;
            out.normal = -faceNormal;  // from A to B
            return out;
        }
    }
}

inline Transform PlaceBody(const Position& position, Vec2 localCenter) {
    Transform xf;
    xf.q.Set(position.a);
    xf.p = position.c - Mul(xf.q, localCenter);
    return xf;
}

}  // namespace

float SolveContactPositions(const ContactRows& rows, BodyTable& bodies, const PushApart& how) {
    const float slop = linearSlop * how.lengthScale, largest = maxLinearCorrection * how.lengthScale;
    float smallest = 0.0f;
    for (const ContactPositionRow& row : rows.position) {
        const Vec2 frame = FrameOf(bodies, row.bodyA, row.bodyB);
        Position a = PositionIn(frame, bodies, row.bodyA);
        Position b = PositionIn(frame, bodies, row.bodyB);
        for (int i = 0; i < row.pointCount; ++i) {
            const Transform xfA = PlaceBody(a, row.massA.localCenter);
            const Transform xfB = PlaceBody(b, row.massB.localCenter);
            const ContactSample s = Evaluate(row, xfA, xfB, i);
            smallest = Min(s.separation, smallest);  // which leaves out what is not a number

            // Leaves a slop of overlap, so that contacts persist.
            const float correction = Clamp(how.share * (s.separation + slop), -largest, 0.0f);
            const Vec2 rA = s.point - a.c;
            const Vec2 rB = s.point - b.c;
            const float crossA = Cross(rA, s.normal);
            const float crossB = Cross(rB, s.normal);
            const float k = row.massA.invMass + row.massB.invMass + row.massA.invI * crossA * crossA +
                            row.massB.invI * crossB * crossB;
            const float impulse = k > 0.0f ? -correction / k : 0.0f;
            const Vec2 push = impulse * s.normal;
            a.c -= row.massA.invMass * push;
            a.a -= row.massA.invI * Cross(rA, push);
            b.c += row.massB.invMass * push;
            b.a += row.massB.invI * Cross(rB, push);
        }
        // Bodies without mass are not written: what blows up must not reach the ground, which others stand on.
        if (row.massA.invMass > 0.0f) StorePosition(frame, a, row.bodyA, bodies);
        if (row.massB.invMass > 0.0f) StorePosition(frame, b, row.bodyB, bodies);
    }
    return smallest;
}

}  // namespace scree
