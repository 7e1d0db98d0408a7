// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Circles, edges and polygons: every function is the engine's on a converted copy.

#include <new>
#include <type_traits>

#include "../box2d/b2_block_allocator.h"
#include "convert.h"

namespace scree::box2d {

CircleShape ToScree(const b2CircleShape& circle) {
    CircleShape out;
    out.m_p = ToScree(circle.m_p);
    out.m_radius = circle.m_radius;
    return out;
}

EdgeShape ToScree(const b2EdgeShape& edge) {
    EdgeShape out;
    out.m_vertex0 = ToScree(edge.m_vertex0);
    out.m_vertex1 = ToScree(edge.m_vertex1);
    out.m_vertex2 = ToScree(edge.m_vertex2);
    out.m_vertex3 = ToScree(edge.m_vertex3);
    out.m_oneSided = edge.m_oneSided;
    out.m_radius = edge.m_radius;
    return out;
}

PolygonShape ToScree(const b2PolygonShape& polygon) {
    PolygonShape out;
    out.m_centroid = ToScree(polygon.m_centroid);
    out.m_count = std::clamp(polygon.m_count, 0, std::min(maxPolygonVertices, b2_maxPolygonVertices));
    for (int i = 0; i < out.m_count; ++i) {
        out.m_vertices[i] = ToScree(polygon.m_vertices[i]);
        out.m_normals[i] = ToScree(polygon.m_normals[i]);
    }
    out.m_radius = polygon.m_radius;
    return out;
}

ConvexShape ToConvex(const b2PolygonShape& polygon) {
    Vec2 points[b2_maxPolygonVertices];
    const int count = std::clamp(polygon.m_count, 0, int{b2_maxPolygonVertices});
    std::transform(polygon.m_vertices, polygon.m_vertices + count, points, [](const b2Vec2& p) { return ToScree(p); });
    return MakePolygon(points, count);
}

EdgeShape ChildEdge(const b2Shape& shape, int index) {
    if (shape.GetType() == b2Shape::e_edge) return ToScree(static_cast<const b2EdgeShape&>(shape));
    b2EdgeShape edge;
    static_cast<const b2ChainShape&>(shape).GetChildEdge(&edge, index);
    return ToScree(edge);
}

namespace {

Vec2 CentroidOf(const PolygonShape& polygon) { return polygon.m_centroid; }
Vec2 CentroidOf(const ConvexShape& polygon) { return polygon.m_unitMass.center; }

/// `unit`: what a length of `polygon` is in the program's units.
template <typename S>
void Assign(b2PolygonShape& out, const S& polygon, float unit = 1.0f) {
    out.m_centroid = ToBox2d(unit * CentroidOf(polygon));
    out.m_count = polygon.m_count;
    for (int i = 0; i < polygon.m_count; ++i) {
        out.m_vertices[i] = ToBox2d(unit * polygon.m_vertices[i]);
        out.m_normals[i] = ToBox2d(polygon.m_normals[i]);
    }
}

template <typename S>
b2Shape* CloneShape(const S& shape, b2BlockAllocator* allocator) {
    void* memory = allocator != nullptr ? allocator->Allocate(static_cast<int32>(sizeof(S))) : nullptr;
    return memory != nullptr ? new (memory) S(shape) : nullptr;
}

/// Calls use(shape) with the engine's form.
template <typename S, typename Use>
auto With(const S& shape, Use&& use) {
    if constexpr (std::is_same_v<S, b2PolygonShape>) {
        return WithPolygon(shape, use);
    } else {
        return use(ToScree(shape));
    }
}

template <typename S>
bool CastRay(const S& shape, b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform) {
    RayCastOutput hit{};
    if (!With(shape, [&](const auto& s) { return s.RayCast(&hit, ToScree(input), ToScree(transform)); })) return false;
    output->normal = ToBox2d(hit.normal);
    output->fraction = hit.fraction;
    return true;
}

template <typename S>
b2AABB BoxOf(const S& shape, const b2Transform& transform) {
    AABB box;
    With(shape, [&](const auto& s) { s.ComputeAABB(&box, ToScree(transform)); });
    return ToBox2d(box);
}

template <typename S>
b2MassData MassOf(const S& shape, float density) {
    MassData data;
    With(shape, [&](const auto& s) { s.ComputeMass(&data, density); });
    return ToBox2d(data);
}

template <typename S>
void Free(S* shape, b2BlockAllocator& allocator) {
    shape->~S();
    allocator.Free(shape, static_cast<int32>(sizeof(S)));
}

}  // namespace

void DestroyClone(b2Shape* shape, b2BlockAllocator& allocator) {
    switch (shape->GetType()) {
        case b2Shape::e_circle:
            return Free(static_cast<b2CircleShape*>(shape), allocator);
        case b2Shape::e_edge:
            return Free(static_cast<b2EdgeShape*>(shape), allocator);
        case b2Shape::e_polygon:
            return Free(static_cast<b2PolygonShape*>(shape), allocator);
        case b2Shape::e_chain:
            return Free(static_cast<b2ChainShape*>(shape), allocator);
        default:
            return;
    }
}

}  // namespace scree::box2d

using namespace scree::box2d;

b2Shape* b2CircleShape::Clone(b2BlockAllocator* allocator) const { return CloneShape(*this, allocator); }
bool b2CircleShape::TestPoint(const b2Transform& transform, const b2Vec2& p) const {
    return ToScree(*this).TestPoint(ToScree(transform), ToScree(p));
}
bool b2CircleShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                            int32) const {
    return CastRay(*this, output, input, transform);
}
void b2CircleShape::ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32) const {
    *aabb = BoxOf(*this, transform);
}
void b2CircleShape::ComputeMass(b2MassData* massData, float density) const { *massData = MassOf(*this, density); }

void b2EdgeShape::SetOneSided(const b2Vec2& v0, const b2Vec2& v1, const b2Vec2& v2, const b2Vec2& v3) {
    m_vertex0 = v0;
    m_vertex1 = v1;
    m_vertex2 = v2;
    m_vertex3 = v3;
    m_oneSided = true;
}
void b2EdgeShape::SetTwoSided(const b2Vec2& v1, const b2Vec2& v2) {
    m_vertex1 = v1;
    m_vertex2 = v2;
    m_oneSided = false;
}
b2Shape* b2EdgeShape::Clone(b2BlockAllocator* allocator) const { return CloneShape(*this, allocator); }
bool b2EdgeShape::TestPoint(const b2Transform&, const b2Vec2&) const { return false; }
bool b2EdgeShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                          int32) const {
    return CastRay(*this, output, input, transform);
}
void b2EdgeShape::ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32) const {
    *aabb = BoxOf(*this, transform);
}
void b2EdgeShape::ComputeMass(b2MassData* massData, float density) const { *massData = MassOf(*this, density); }

void b2PolygonShape::Set(const b2Vec2* points, int32 count) {
    if (points == nullptr || count < 3 || count > b2_maxPolygonVertices) {
        return Complain("b2PolygonShape::Set", "give 3 to b2_maxPolygonVertices points");
    }
    scree::Vec2 copies[b2_maxPolygonVertices];
    // The hull merges points that are nearer than a distance in metres.
    std::transform(points, points + count, copies, [](const b2Vec2& p) { return metres * ToScree(p); });
    const auto complain = [] { Complain("b2PolygonShape::Set", "give finite points that do not lie on one line"); };
    if (count > scree::maxPolygonVertices) {
        const scree::ConvexShape large = scree::MakePolygon(copies, count);
        return large.Validate() ? Assign(*this, large, b2_lengthUnitsPerMeter) : complain();
    }
    scree::PolygonShape polygon;
    if (!polygon.Set(copies, count)) return complain();
    Assign(*this, polygon, b2_lengthUnitsPerMeter);
}
void b2PolygonShape::SetAsBox(float hx, float hy) {
    scree::PolygonShape polygon;
    polygon.SetAsBox(hx, hy);
    Assign(*this, polygon);
}
void b2PolygonShape::SetAsBox(float hx, float hy, const b2Vec2& center, float angle) {
    scree::PolygonShape polygon;
    polygon.SetAsBox(hx, hy, ToScree(center), angle);
    Assign(*this, polygon);
}
b2Shape* b2PolygonShape::Clone(b2BlockAllocator* allocator) const { return CloneShape(*this, allocator); }
bool b2PolygonShape::TestPoint(const b2Transform& transform, const b2Vec2& p) const {
    return WithPolygon(*this, [&](const auto& s) { return s.TestPoint(ToScree(transform), ToScree(p)); });
}
bool b2PolygonShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                             int32) const {
    return CastRay(*this, output, input, transform);
}
void b2PolygonShape::ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32) const {
    *aabb = BoxOf(*this, transform);
}
void b2PolygonShape::ComputeMass(b2MassData* massData, float density) const { *massData = MassOf(*this, density); }
bool b2PolygonShape::Validate() const {
    return WithPolygon(*this, [](const auto& s) { return s.Validate(); });
}
