// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Further convex shapes: capsules, rounded polygons, polygons of up to 64 vertices, ellipses, circle sectors, and any
// convex shape that can say how far it reaches (a support function). All are one type: a convex core whose sides are
// straight or gently curved, grown by a radius. The Make functions turn a description into that form.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/collision.h"
#include "scree/shape.h"

namespace scree {

/// A convex core of 1 (disk), 2 (capsule) or up to maxConvexVertices vertices, counter-clockwise, grown by m_radius. A
/// curved side is a quadratic Bézier arc between its vertices. Contacts, the box and the mass use the arcs; distances,
/// overlap tests, casts and times of impact use the straight core, which lies inside by at most m_error.
class SCREE_API ConvexShape final : public Shape {
public:
    /// Empty, refused by CreateFixture: fill it by a Make function.
    ConvexShape() : Shape(e_convex, polygonRadius) {}

    /// True if finite, convex and counter-clockwise.
    [[nodiscard]] bool Validate() const;
    /// The point of the core (arcs included, radius not) that reaches farthest along `direction`, body coordinates.
    [[nodiscard]] Vec2 GetSupportPoint(Vec2 direction) const;
    [[nodiscard]] bool IsCurved(int side) const { return (m_curvedSides >> side & 1u) != 0; }

    /// As for polygons the skin does not count, but the radius of capsules and rounded polygons does.
    [[nodiscard]] bool TestPoint(const Transform& xf, Vec2 p) const override;
    bool RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const override;
    void ComputeAABB(AABB* aabb, const Transform& xf) const override;
    void ComputeMass(MassData* massData, float density) const override;

    int m_count = 0;
    uint64_t m_curvedSides = 0;            ///< bit i: the side from vertex i to the next is an arc
    float m_solidRadius = 0.0f;            ///< the part of m_radius that is solid: all or, for a skin, nothing, m
    float m_error = 0.0f;                  ///< largest distance of an arc from its chord, m
    MassData m_unitMass;                   ///< at 1 kg/m²
    const char* m_badField = nullptr;      ///< the argument that a Make function refused; null for a valid shape
    Vec2 m_vertices[maxConvexVertices]{};  ///< of the core
    Vec2 m_normals[maxConvexVertices]{};   ///< of the chords, outwards
    Vec2 m_controls[maxConvexVertices]{};  ///< Bézier control point of each side, where its end tangents meet
};

/// A segment p1…p2 grown by `radius` > 0; equal ends make a disk. As with every Make function, a bad argument gives a
/// shape that CreateFixture refuses with the argument's name.
[[nodiscard]] SCREE_API ConvexShape MakeCapsule(Vec2 p1, Vec2 p2, float radius);
/// The convex hull of 3…64 points, with the skin of a PolygonShape.
[[nodiscard]] SCREE_API ConvexShape MakePolygon(const Vec2* points, int count);
/// The convex hull of 3…64 points, grown by `radius` > 0, which is solid.
[[nodiscard]] SCREE_API ConvexShape MakeRoundedPolygon(const Vec2* points, int count, float radius);
/// Semi-axes along x and y, > 0, m, then turned by `angle` rad around `center`; at most 1000 : 1.
[[nodiscard]] SCREE_API ConvexShape MakeEllipse(float semiAxisX, float semiAxisY, Vec2 center = {0.0f, 0.0f},
                                                float angle = 0.0f);
/// A slice of a disk around `apex`: `opening` rad in (0.01, π], symmetric about the direction `angle`.
[[nodiscard]] SCREE_API ConvexShape MakeCircleSector(float radius, float opening, Vec2 apex = {0.0f, 0.0f},
                                                     float angle = 0.0f);

/// A convex shape described by how far it reaches. Called only by MakeFromSupport, about 150 times.
struct SupportDef {
    /// A point of the shape farthest along `direction` (unit length), body coordinates.
    Vec2 (*support)(const void* data, Vec2 direction) = nullptr;
    const void* data = nullptr;   ///< handed to the functions
    float boundingRadius = 0.0f;  ///< no point is farther from the body's origin, m; guards against bad functions
    /// Mass data at 1 kg/m², or null: integrated over the arcs, to about 1e-4.
    MassData (*mass)(const void* data) = nullptr;
};

/// Samples the support function, most where the outline bends most, into at most 64 arcs.
[[nodiscard]] SCREE_API ConvexShape MakeFromSupport(const SupportDef& def);

/// Manifold of two shapes of any type but chains, at least one of them convex; an edge comes first. One point where
/// curves or corners touch, up to two where straight sides do.
SCREE_API void CollideConvex(Manifold* manifold, const Shape* shapeA, const Transform& xfA, const Shape* shapeB,
                             const Transform& xfB);

}  // namespace scree
