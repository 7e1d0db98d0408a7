// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manifolds of two shapes, world manifolds, point states, clipping, rays against boxes.

#include "../box2d/b2_distance.h"
#include "convert.h"
#include "scree/distance.h"

using namespace scree::box2d;

void b2WorldManifold::Initialize(const b2Manifold* manifold, const b2Transform& xfA, float radiusA,
                                 const b2Transform& xfB, float radiusB) {
    if (manifold == nullptr || manifold->pointCount == 0) return;
    const scree::Manifold converted = ToScree(*manifold);
    scree::WorldManifold world{};
    world.Initialize(&converted, ToScree(xfA), radiusA, ToScree(xfB), radiusB);
    normal = ToBox2d(world.normal);
    for (int i = 0; i < converted.pointCount; ++i) {
        points[i] = ToBox2d(world.points[i]);
        separations[i] = world.separations[i];
    }
}

namespace {

bool HasPoint(const b2Manifold& manifold, const b2ContactID& id) {
    for (int i = 0; i < manifold.pointCount; ++i) {
        if (manifold.points[i].id.key == id.key) return true;
    }
    return false;
}

}  // namespace

void b2GetPointStates(b2PointState state1[b2_maxManifoldPoints], b2PointState state2[b2_maxManifoldPoints],
                      const b2Manifold* manifold1, const b2Manifold* manifold2) {
    for (int i = 0; i < b2_maxManifoldPoints; ++i) state1[i] = state2[i] = b2_nullState;
    for (int i = 0; i < manifold1->pointCount; ++i) {
        state1[i] = HasPoint(*manifold2, manifold1->points[i].id) ? b2_persistState : b2_removeState;
    }
    for (int i = 0; i < manifold2->pointCount; ++i) {
        state2[i] = HasPoint(*manifold1, manifold2->points[i].id) ? b2_persistState : b2_addState;
    }
}

bool b2AABB::RayCast(b2RayCastOutput* output, const b2RayCastInput& input) const {
    // The ray is inside between the latest entry and the earliest exit of the two slabs.
    float enter = -b2_maxFloat;
    float leave = b2_maxFloat;
    b2Vec2 normal(0.0f, 0.0f);
    const b2Vec2 d = input.p2 - input.p1;
    for (int axis = 0; axis < 2; ++axis) {
        const float start = input.p1(axis);
        if (b2Abs(d(axis)) < b2_epsilon) {
            if (start < lowerBound(axis) || start > upperBound(axis)) return false;
            continue;
        }
        const float toLower = (lowerBound(axis) - start) / d(axis);
        const float toUpper = (upperBound(axis) - start) / d(axis);
        const float in = b2Min(toLower, toUpper);
        if (in > enter) {
            enter = in;
            normal.SetZero();
            normal(axis) = d(axis) > 0.0f ? -1.0f : 1.0f;
        }
        leave = b2Min(leave, b2Max(toLower, toUpper));
        if (enter > leave) return false;
    }
    if (enter < 0.0f || enter > input.maxFraction) return false;
    output->fraction = enter;
    output->normal = normal;
    return true;
}

namespace {

/// Runs one of the engine's functions and keeps what Box2D leaves alone: nothing.
template <typename Function, typename A, typename B>
void Collide(b2Manifold* manifold, Function function, const A& shapeA, const b2Transform& xfA, const B& shapeB,
             const b2Transform& xfB) {
    scree::Manifold result{};
    const auto a = ToScree(shapeA);
    const auto b = ToScree(shapeB);
    function(&result, &a, ToScree(xfA), &b, ToScree(xfB));
    *manifold = ToBox2d(result);
}

}  // namespace

void b2CollideCircles(b2Manifold* manifold, const b2CircleShape* circleA, const b2Transform& xfA,
                      const b2CircleShape* circleB, const b2Transform& xfB) {
    Collide(manifold, scree::CollideCircles, *circleA, xfA, *circleB, xfB);
}
void b2CollidePolygonAndCircle(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                               const b2CircleShape* circleB, const b2Transform& xfB) {
    Collide(manifold, scree::CollidePolygonAndCircle, *polygonA, xfA, *circleB, xfB);
}
void b2CollidePolygons(b2Manifold* manifold, const b2PolygonShape* polygonA, const b2Transform& xfA,
                       const b2PolygonShape* polygonB, const b2Transform& xfB) {
    Collide(manifold, scree::CollidePolygons, *polygonA, xfA, *polygonB, xfB);
}
void b2CollideEdgeAndCircle(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                            const b2CircleShape* circleB, const b2Transform& xfB) {
    Collide(manifold, scree::CollideEdgeAndCircle, *edgeA, xfA, *circleB, xfB);
}
void b2CollideEdgeAndPolygon(b2Manifold* manifold, const b2EdgeShape* edgeA, const b2Transform& xfA,
                             const b2PolygonShape* polygonB, const b2Transform& xfB) {
    Collide(manifold, scree::CollideEdgeAndPolygon, *edgeA, xfA, *polygonB, xfB);
}

int32 b2ClipSegmentToLine(b2ClipVertex vOut[2], const b2ClipVertex vIn[2], const b2Vec2& normal, float offset,
                          int32 vertexIndexA) {
    const float distance[2] = {b2Dot(normal, vIn[0].v) - offset, b2Dot(normal, vIn[1].v) - offset};
    int32 count = 0;
    for (int i = 0; i < 2; ++i) {
        if (distance[i] <= 0.0f) vOut[count++] = vIn[i];
    }
    if (distance[0] * distance[1] < 0.0f) {
        const float share = distance[0] / (distance[0] - distance[1]);
        b2ClipVertex& cut = vOut[count++];
        cut.v = vIn[0].v + share * (vIn[1].v - vIn[0].v);
        cut.id.cf.indexA = static_cast<uint8>(vertexIndexA);
        cut.id.cf.indexB = vIn[0].id.cf.indexB;
        cut.id.cf.typeA = b2ContactFeature::e_vertex;
        cut.id.cf.typeB = b2ContactFeature::e_face;
    }
    return count;
}

bool b2TestOverlap(const b2Shape* shapeA, int32 indexA, const b2Shape* shapeB, int32 indexB, const b2Transform& xfA,
                   const b2Transform& xfB) {
    b2DistanceInput input;
    input.proxyA.Set(shapeA, indexA);
    input.proxyB.Set(shapeB, indexB);
    if (input.proxyA.m_count < 1 || input.proxyB.m_count < 1) return false;  // refused with the reason
    input.transformA = xfA;
    input.transformB = xfB;
    input.useRadii = true;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    return output.distance < 10.0f * b2_epsilon;
}
