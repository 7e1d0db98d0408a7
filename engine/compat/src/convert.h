// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Values of Box2D's interface to the engine's and back. The two sides have the same meaning and units everywhere; only
// integer widths of manifolds differ.

#pragma once

#include <algorithm>
#include <cstdio>

#include "../box2d/b2_chain_shape.h"
#include "../box2d/b2_circle_shape.h"
#include "../box2d/b2_collision.h"
#include "../box2d/b2_edge_shape.h"
#include "../box2d/b2_fixture.h"
#include "../box2d/b2_polygon_shape.h"
#include "scree/chain_shape.h"
#include "scree/collision.h"
#include "scree/convex_shape.h"
#include "scree/fixture.h"
#include "scree/math.h"
#include "scree/shape.h"

namespace scree::box2d {

/// What the engine's default error handler writes, for objects that belong to no world.
inline void Complain(const char* function, const char* problem) {
    std::fprintf(stderr, "scree: %s: %s\n", function, problem);
}

/// The program's length unit, m: for functions of the engine that know no other unit.
inline constexpr float metres = 1.0f / b2_lengthUnitsPerMeter;

inline Vec2 ToScree(const b2Vec2& v) { return {v.x, v.y}; }
inline b2Vec2 ToBox2d(Vec2 v) { return {v.x, v.y}; }

inline Rot ToScree(const b2Rot& q) {
    Rot out;
    out.s = q.s;
    out.c = q.c;
    return out;
}
inline Transform ToScree(const b2Transform& xf) { return {ToScree(xf.p), ToScree(xf.q)}; }
inline b2Transform ToBox2d(const Transform& xf) {
    b2Transform out;
    out.p = ToBox2d(xf.p);
    out.q.s = xf.q.s;
    out.q.c = xf.q.c;
    return out;
}

inline AABB ToScree(const b2AABB& box) { return {ToScree(box.lowerBound), ToScree(box.upperBound)}; }
inline b2AABB ToBox2d(const AABB& box) {
    b2AABB out;
    out.lowerBound = ToBox2d(box.lowerBound);
    out.upperBound = ToBox2d(box.upperBound);
    return out;
}

inline Sweep ToScree(const b2Sweep& sweep) {
    Sweep out;
    out.localCenter = ToScree(sweep.localCenter);
    out.c0 = ToScree(sweep.c0);
    out.c = ToScree(sweep.c);
    out.a0 = sweep.a0;
    out.a = sweep.a;
    out.alpha0 = sweep.alpha0;
    return out;
}

inline RayCastInput ToScree(const b2RayCastInput& input) {
    return {ToScree(input.p1), ToScree(input.p2), input.maxFraction};
}
inline b2RayCastInput ToBox2d(const RayCastInput& input) {
    b2RayCastInput out;
    out.p1 = ToBox2d(input.p1);
    out.p2 = ToBox2d(input.p2);
    out.maxFraction = input.maxFraction;
    return out;
}

inline b2MassData ToBox2d(const MassData& data) {
    b2MassData out;
    out.mass = data.mass;
    out.center = ToBox2d(data.center);
    out.I = data.I;
    return out;
}
inline MassData ToScree(const b2MassData& data) { return {data.mass, ToScree(data.center), data.I}; }

/// All 16 bits of a mask are all of the engine's 64.
inline Filter ToScree(const b2Filter& filter) {
    const uint64_t mask = filter.maskBits == 0xFFFF ? ~uint64_t{0} : filter.maskBits;
    return {filter.categoryBits, mask, filter.groupIndex};
}

inline Manifold ToScree(const b2Manifold& manifold) {
    Manifold out{};
    out.localNormal = ToScree(manifold.localNormal);
    out.localPoint = ToScree(manifold.localPoint);
    out.type = static_cast<Manifold::Type>(manifold.type);
    out.pointCount = static_cast<int8_t>(std::clamp(manifold.pointCount, 0, maxManifoldPoints));
    for (int i = 0; i < out.pointCount; ++i) {
        const b2ManifoldPoint& p = manifold.points[i];
        out.points[i] = {ToScree(p.localPoint), p.normalImpulse, p.tangentImpulse, {}};
        out.points[i].id.key = p.id.key;
    }
    return out;
}

inline b2Manifold ToBox2d(const Manifold& manifold) {
    b2Manifold out{};
    out.localNormal = ToBox2d(manifold.localNormal);
    out.localPoint = ToBox2d(manifold.localPoint);
    out.type = static_cast<b2Manifold::Type>(manifold.type);
    out.pointCount = manifold.pointCount;
    for (int i = 0; i < manifold.pointCount; ++i) {
        const ManifoldPoint& p = manifold.points[i];
        out.points[i].localPoint = ToBox2d(p.localPoint);
        out.points[i].normalImpulse = p.normalImpulse;
        out.points[i].tangentImpulse = p.tangentImpulse;
        out.points[i].id.key = p.id.key;
    }
    return out;
}

CircleShape ToScree(const b2CircleShape& circle);
EdgeShape ToScree(const b2EdgeShape& edge);
PolygonShape ToScree(const b2PolygonShape& polygon);
ChainShape ToScree(const b2ChainShape& chain);
/// The engine's form of a polygon of any size; more vertices than its PolygonShape has make a ConvexShape.
ConvexShape ToConvex(const b2PolygonShape& polygon);
template <typename Use>
auto WithPolygon(const b2PolygonShape& polygon, Use&& use) {
    if (b2_maxPolygonVertices > maxPolygonVertices && polygon.m_count > maxPolygonVertices) {
        return use(ToConvex(polygon));
    }
    return use(ToScree(polygon));
}
/// The edge that stands for child `index` of an edge or a chain.
EdgeShape ChildEdge(const b2Shape& shape, int index);
/// Destroys a clone made with `allocator`.
void DestroyClone(b2Shape* shape, b2BlockAllocator& allocator);

/// Calls use(shape) with the engine's form of child `index`: a circle, an edge or a polygon.
template <typename Use>
auto WithChild(const b2Shape& shape, int index, Use&& use) {
    switch (shape.GetType()) {
        case b2Shape::e_circle:
            return use(ToScree(static_cast<const b2CircleShape&>(shape)));
        case b2Shape::e_polygon:
            return WithPolygon(static_cast<const b2PolygonShape&>(shape), use);
        default:
            return use(ChildEdge(shape, index));
    }
}

}  // namespace scree::box2d
