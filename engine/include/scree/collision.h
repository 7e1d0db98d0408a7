// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contact manifolds: what the narrow phase computes for two touching shapes, in Box2D 2.4's form.

#pragma once

#include "scree/api.h"
#include "scree/math.h"
#include "scree/shape.h"

namespace scree {

/// Names the two features (vertex or face) whose crossing made a contact point.
struct ContactFeature {
    enum Type : uint8_t { e_vertex = 0, e_face = 1 };

    uint8_t indexA, indexB;  ///< index of the vertex or face on each shape
    uint8_t typeA, typeB;
};

/// The feature as fields or as one key to match points across steps.
union ContactID {
    ContactFeature cf;
    uint32_t key;
};

/// A point of a manifold, in local coordinates so that it can be re-evaluated as the bodies move. For e_circles it is
/// the centre of circle B, in B; for e_faceA a clip point or circle centre, in B; for e_faceB a clip point, in A.
struct ManifoldPoint {
    Vec2 localPoint;
    float normalImpulse;   ///< N·s, from the last solve; warm-starts the next
    float tangentImpulse;  ///< N·s
    ContactID id;
};

/// Up to two points sharing a normal. For e_faceA, localNormal and localPoint are normal and mid point of the face of
/// A, in A. For e_faceB, they are those of B. For e_circles, localPoint is the centre of A.
struct Manifold {
    enum Type : uint8_t { e_circles, e_faceA, e_faceB };

    ManifoldPoint points[maxManifoldPoints];
    Vec2 localNormal;
    Vec2 localPoint;
    Type type;
    int8_t pointCount = 0;
};

/// A manifold in world coordinates.
struct SCREE_API WorldManifold {
    Vec2 normal;                           ///< from A to B
    Vec2 points[maxManifoldPoints];        ///< midway between the two surfaces
    float separations[maxManifoldPoints];  ///< m, negative is overlap (radii included)

    /// Evaluates `manifold` for shapes with radii radiusA and radiusB placed at xfA and xfB.
    void Initialize(const Manifold* manifold, const Transform& xfA, float radiusA, const Transform& xfB, float radiusB);
};

/// Manifold of two shapes; pointCount 0 when they are apart. Impulses are not set.
SCREE_API void CollideCircles(Manifold* manifold, const CircleShape* circleA, const Transform& xfA,
                              const CircleShape* circleB, const Transform& xfB);
SCREE_API void CollidePolygonAndCircle(Manifold* manifold, const PolygonShape* polygonA, const Transform& xfA,
                                       const CircleShape* circleB, const Transform& xfB);
SCREE_API void CollidePolygons(Manifold* manifold, const PolygonShape* polygonA, const Transform& xfA,
                               const PolygonShape* polygonB, const Transform& xfB);
SCREE_API void CollideEdgeAndCircle(Manifold* manifold, const EdgeShape* edgeA, const Transform& xfA,
                                    const CircleShape* circleB, const Transform& xfB);
SCREE_API void CollideEdgeAndPolygon(Manifold* manifold, const EdgeShape* edgeA, const Transform& xfA,
                                     const PolygonShape* polygonB, const Transform& xfB);

}  // namespace scree
