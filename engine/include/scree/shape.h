// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Collision shapes in body coordinates: circle, edge (line segment), convex polygon. A shape is a value: CreateFixture
// copies it, so it can live on the stack.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/math.h"
#include "scree/settings.h"

namespace scree {

/// Mass, centre and rotational inertia of a shape.
struct MassData {
    float mass = 0.0f;        ///< kg
    Vec2 center{0.0f, 0.0f};  ///< centre of mass in body coordinates, m
    float I = 0.0f;           ///< inertia about the body's ORIGIN, kg·m²
};

/// A ray from p1 towards p2; only the part up to p1 + maxFraction·(p2 − p1) is tested.
struct RayCastInput {
    Vec2 p1, p2;
    float maxFraction;
};

/// Where a ray enters a shape: the point is p1 + fraction·(p2 − p1).
struct RayCastOutput {
    Vec2 normal;
    float fraction;
};

/// What is common to all shapes. The shape of a fixture is a circle, an edge, a polygon or a ConvexShape; valid ones
/// hold no pointers and can be copied byte by byte. A chain (chain_shape.h) is a definition that makes edges.
class SCREE_API Shape {
public:
    enum Type : uint8_t {
        e_circle = 0,
        e_edge = 1,
        e_polygon = 2,
        e_convex = 3,     ///< capsules, ellipses and others: convex_shape.h
        e_typeCount = 4,  ///< number of types that a fixture can have
        e_chain = 4,      ///< never the type of a fixture
    };

    virtual ~Shape() = default;
    [[nodiscard]] Type GetType() const { return m_type; }

    /// True if the world point p lies in the shape placed at xf. Edges have no inside: always false.
    [[nodiscard]] virtual bool TestPoint(const Transform& xf, Vec2 p) const = 0;
    /// Casts a ray against the shape placed at xf; false if it misses or starts inside.
    virtual bool RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const = 0;
    /// The tight box around the shape placed at xf, radius (skin) included.
    virtual void ComputeAABB(AABB* aabb, const Transform& xf) const = 0;
    /// Mass, centre and inertia at `density` kg/m². Edges have none.
    virtual void ComputeMass(MassData* massData, float density) const = 0;

    Type m_type;
    /// Rounding radius, m: a circle's radius; the skin of edges and polygons (polygonRadius).
    float m_radius;

protected:
    Shape(Type type, float radius) : m_type(type), m_radius(radius) {}
    Shape(const Shape&) = default;
    Shape& operator=(const Shape&) = default;
};

/// A solid disk.
class SCREE_API CircleShape final : public Shape {
public:
    CircleShape() : Shape(e_circle, 0.0f), m_p(0.0f, 0.0f) {}

    bool TestPoint(const Transform& xf, Vec2 p) const override;
    bool RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const override;
    void ComputeAABB(AABB* aabb, const Transform& xf) const override;
    void ComputeMass(MassData* massData, float density) const override;

    Vec2 m_p;  ///< centre in body coordinates
};

/// A line segment from m_vertex1 to m_vertex2, massless. One-sided edges collide only on the right of v1→v2 and use the
/// ghost vertices m_vertex0 and m_vertex3 of their neighbours to give smooth contacts at seams.
class SCREE_API EdgeShape final : public Shape {
public:
    EdgeShape() : Shape(e_edge, polygonRadius) {}

    /// A one-sided edge v1→v2 with the neighbours' far vertices v0 and v3.
    void SetOneSided(Vec2 v0, Vec2 v1, Vec2 v2, Vec2 v3);
    /// An edge that collides on both sides.
    void SetTwoSided(Vec2 v1, Vec2 v2);

    bool TestPoint(const Transform& xf, Vec2 p) const override;
    bool RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const override;
    void ComputeAABB(AABB* aabb, const Transform& xf) const override;
    void ComputeMass(MassData* massData, float density) const override;

    Vec2 m_vertex1{0.0f, 0.0f}, m_vertex2{0.0f, 0.0f};
    Vec2 m_vertex0{0.0f, 0.0f}, m_vertex3{0.0f, 0.0f};
    bool m_oneSided = false;
};

/// A convex polygon, counter-clockwise, 3 to maxPolygonVertices vertices.
class SCREE_API PolygonShape final : public Shape {
public:
    PolygonShape() : Shape(e_polygon, polygonRadius), m_centroid(0.0f, 0.0f) {}

    /// Makes the convex hull of `count` points (3…8). Points nearer than half of linearSlop are merged.
    /// Returns false and leaves the shape unchanged if the points are not finite, too few, too many or nearly
    /// collinear.
    [[nodiscard]] bool Set(const Vec2* points, int count);
    /// An axis-aligned box with half extents hx, hy (> 0).
    void SetAsBox(float hx, float hy);
    /// A box with half extents hx, hy around `center`, turned by `angle` rad.
    void SetAsBox(float hx, float hy, Vec2 center, float angle);
    /// True if convex, counter-clockwise and finite.
    [[nodiscard]] bool Validate() const;

    bool TestPoint(const Transform& xf, Vec2 p) const override;
    bool RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const override;
    void ComputeAABB(AABB* aabb, const Transform& xf) const override;
    void ComputeMass(MassData* massData, float density) const override;

    Vec2 m_centroid;
    Vec2 m_vertices[maxPolygonVertices]{};
    Vec2 m_normals[maxPolygonVertices]{};
    int m_count = 0;
};

}  // namespace scree
