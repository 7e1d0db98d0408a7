// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Evaluates a local manifold at two placements: manifold, transforms, radii → world normal, points midway between the
// two surfaces, separations. Conventions of Box2D 2.4.

#include <cfloat>

#include "scree/collision.h"

namespace scree {
namespace {

/// A shape's placement and rounding radius.
struct Side {
    const Transform& xf;
    float radius;
};

void EvaluateCircles(WorldManifold* out, const Manifold& manifold, const Side& a, const Side& b) {
    const Vec2 centerA = Mul(a.xf, manifold.localPoint);
    const Vec2 centerB = Mul(b.xf, manifold.points[0].localPoint);
    out->normal = {1.0f, 0.0f};  // concentric circles have no direction: any will do
    if (DistanceSquared(centerA, centerB) > FLT_EPSILON * FLT_EPSILON) {
        out->normal = centerB - centerA;
        out->normal.Normalize();
    }
    const Vec2 surfaceA = centerA + a.radius * out->normal;
    const Vec2 surfaceB = centerB - b.radius * out->normal;
    out->points[0] = 0.5f * (surfaceA + surfaceB);
    out->separations[0] = Dot(surfaceB - surfaceA, out->normal);
}

/// The face belongs to `reference`, the points to `incident`; the normal points from the former to the latter.
void EvaluateFace(WorldManifold* out, const Manifold& manifold, const Side& reference, const Side& incident) {
    const Vec2 normal = Mul(reference.xf.q, manifold.localNormal);
    const Vec2 planePoint = Mul(reference.xf, manifold.localPoint);
    for (int i = 0; i < manifold.pointCount; ++i) {
        const Vec2 clipPoint = Mul(incident.xf, manifold.points[i].localPoint);
        const Vec2 onReference = clipPoint + (reference.radius - Dot(clipPoint - planePoint, normal)) * normal;
        const Vec2 onIncident = clipPoint - incident.radius * normal;
        out->points[i] = 0.5f * (onReference + onIncident);
        out->separations[i] = Dot(onIncident - onReference, normal);
    }
    out->normal = normal;
}

}  // namespace

void WorldManifold::Initialize(const Manifold* manifold, const Transform& xfA, float radiusA, const Transform& xfB,
                               float radiusB) {
    if (manifold->pointCount == 0) return;
    const Side a{xfA, radiusA};
    const Side b{xfB, radiusB};
    switch (manifold->type) {
        case Manifold::e_circles:
            EvaluateCircles(this, *manifold, a, b);
            break;
        case Manifold::e_faceA:
            EvaluateFace(this, *manifold, a, b);
            break;
        case Manifold::e_faceB:
            EvaluateFace(this, *manifold, b, a);
            normal = -normal;
            break;
    }
}

}  // namespace scree
