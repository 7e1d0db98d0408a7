// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manifolds, boxes and rays of Box2D 2.4, and the functions that make manifolds of two shapes.

#pragma once

#include <limits.h>

#include "b2_api.h"
#include "b2_math.h"

class b2Shape;
class b2CircleShape;
class b2EdgeShape;
class b2PolygonShape;

const uint8 b2_nullFeature = UCHAR_MAX;

/// The two features whose crossing made a contact point.
struct B2_API b2ContactFeature {
    enum Type { e_vertex = 0, e_face = 1 };

    uint8 indexA;
    uint8 indexB;
    uint8 typeA;
    uint8 typeB;
};

/// A feature pair as fields or as one key.
union B2_API b2ContactID {
    b2ContactFeature cf;
    uint32 key;
};

/// localPoint: e_circles: centre of circle B in B; e_faceA: clip point or circle centre in B; e_faceB: clip point in A.
struct B2_API b2ManifoldPoint {
    b2Vec2 localPoint;
    float normalImpulse;
    float tangentImpulse;
    b2ContactID id;
};

/// Up to two points sharing a normal. localPoint: e_circles: centre of A; e_faceA, e_faceB: a point of that face.
struct B2_API b2Manifold {
    enum Type { e_circles, e_faceA, e_faceB };

    b2ManifoldPoint points[b2_maxManifoldPoints];
    b2Vec2 localNormal;
    b2Vec2 localPoint;
    Type type;
    int32 pointCount;
};

/// A manifold in world coordinates; the normal points from A to B.
struct B2_API b2WorldManifold {
    /// Leaves everything as it is if the manifold has no points.
    void Initialize(const b2Manifold* manifold, const b2Transform& xfA, float radiusA, const b2Transform& xfB,
                    float radiusB);

    b2Vec2 normal;
    b2Vec2 points[b2_maxManifoldPoints];
    float separations[b2_maxManifoldPoints];
};

/// What became of a contact point from one step to the next.
enum b2PointState { b2_nullState, b2_addState, b2_persistState, b2_removeState };

/// state1: the points of manifold1 persist or are removed; state2: those of manifold2 persist or are added.
B2_API void b2GetPointStates(b2PointState state1[b2_maxManifoldPoints], b2PointState state2[b2_maxManifoldPoints],
                             const b2Manifold* manifold1, const b2Manifold* manifold2);

/// An end of a segment that is clipped.
struct B2_API b2ClipVertex {
    b2Vec2 v;
    b2ContactID id;
};

/// The ray from p1 to p1 + maxFraction·(p2 − p1).
struct B2_API b2RayCastInput {
    b2Vec2 p1, p2;
    float maxFraction;
};

/// The hit is at p1 + fraction·(p2 − p1).
struct B2_API b2RayCastOutput {
    b2Vec2 normal;
    float fraction;
};

/// An axis-aligned box, closed.
struct B2_API b2AABB {
    bool IsValid() const {
        return lowerBound.IsValid() && upperBound.IsValid() && lowerBound.x <= upperBound.x &&
               lowerBound.y <= upperBound.y;
    }
    b2Vec2 GetCenter() const { return 0.5f * (lowerBound + upperBound); }
    /// Half widths.
    b2Vec2 GetExtents() const { return 0.5f * (upperBound - lowerBound); }
    float GetPerimeter() const { return 2.0f * ((upperBound.x - lowerBound.x) + (upperBound.y - lowerBound.y)); }
    /// Grows to the union with a box, or becomes the union of two.
    void Combine(const b2AABB& aabb) { Combine(*this, aabb); }
    void Combine(const b2AABB& aabb1, const b2AABB& aabb2) {
        lowerBound = b2Min(aabb1.lowerBound, aabb2.lowerBound);
        upperBound = b2Max(aabb1.upperBound, aabb2.upperBound);
    }
    bool Contains(const b2AABB& aabb) const {
        return lowerBound.x <= aabb.lowerBound.x && lowerBound.y <= aabb.lowerBound.y &&
               aabb.upperBound.x <= upperBound.x && aabb.upperBound.y <= upperBound.y;
    }
    /// False if the ray misses or starts inside.
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input) const;

    b2Vec2 lowerBound;
    b2Vec2 upperBound;
};

B2_API void b2CollideCircles(b2Manifold* manifold, const b2CircleShape* circleA, const b2Transform& xfA,
                             const b2CircleShape* circleB, const b2Transform& xfB);
B2_API void b2CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                                      const b2CircleShape* circleB, const b2Transform& xfB);
B2_API void b2CollidePolygons(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                              const b2PolygonShape* polygonB, const b2Transform& xfB);
B2_API void b2CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                                   const b2CircleShape* circleB, const b2Transform& xfB);
B2_API void b2CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                                    const b2PolygonShape* polygonB, const b2Transform& xfB);

/// Keeps the part of the segment with dot(normal, v) ≤ offset; a cut end gets vertexIndexA in its id. Returns the ends.
B2_API int32 b2ClipSegmentToLine(b2ClipVertex vOut[2], const b2ClipVertex vIn[2], const b2Vec2& normal, float offset,
                                 int32 vertexIndexA);

/// Whether two shapes (children of chains by index) overlap, skins included.
B2_API bool b2TestOverlap(const b2Shape* shapeA, int32 indexA, const b2Shape* shapeB, int32 indexB,
                          const b2Transform& xfA, const b2Transform& xfB);

inline bool b2TestOverlap(const b2AABB& a, const b2AABB& b) {
    return !(b.lowerBound.x > a.upperBound.x || b.lowerBound.y > a.upperBound.y || a.lowerBound.x > b.upperBound.x ||
             a.lowerBound.y > b.upperBound.y);
}
