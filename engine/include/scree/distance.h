// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Distance, linear cast and overlap of two convex shapes, with Box2D 2.4's names and meaning. A shape is a core (point,
// segment or polygon) grown by a radius; two cores and their placements → closest points, time of first touch, or a
// yes or no.

#pragma once

#include <cstdint>

#include "scree/api.h"
#include "scree/math.h"
#include "scree/shape.h"

namespace scree {

/// A convex core and its radius. Points at vertices that live elsewhere: they must outlive the proxy.
struct SCREE_API DistanceProxy {
    /// Views a shape. `index` is the child of a shape made of several; other shapes ignore it.
    void Set(const Shape* shape, int index);
    /// Views the convex hull of `count` points (1…255) grown by `radius` >= 0, m.
    void Set(const Vec2* vertices, int count, float radius);

    /// The index of the vertex farthest along d; the lowest of several.
    [[nodiscard]] int GetSupport(Vec2 d) const;
    /// The vertex farthest along d.
    [[nodiscard]] const Vec2& GetSupportVertex(Vec2 d) const { return m_vertices[GetSupport(d)]; }
    [[nodiscard]] int GetVertexCount() const { return m_count; }
    /// A vertex by index, 0 <= index < GetVertexCount().
    [[nodiscard]] const Vec2& GetVertex(int index) const { return m_vertices[index]; }

    const Vec2* m_vertices = nullptr;  ///< in body coordinates
    int m_count = 0;
    float m_radius = 0.0f;  ///< m
};

/// Which vertices carried the last result: hand it to the next call for the same two shapes and it starts there. Set
/// count to 0 before the first call. Indices that do not fit the proxies are ignored.
struct SimplexCache {
    float metric = 0.0f;  ///< length (count 2) or signed area × 2 (count 3) of the simplex
    uint16_t count = 0;
    uint8_t indexA[3]{};  ///< vertices of A
    uint8_t indexB[3]{};  ///< vertices of B
};

struct DistanceInput {
    DistanceProxy proxyA;
    DistanceProxy proxyB;
    Transform transformA;
    Transform transformB;
    bool useRadii;  ///< false: the distance of the cores
};

struct DistanceOutput {
    Vec2 pointA;     ///< closest point on A, world
    Vec2 pointB;     ///< closest point on B, world
    float distance;  ///< m, 0 when they overlap; NaN when a placement is not finite
    int iterations;  ///< GJK rounds used
};

/// Closest points of two shapes. With radii, overlapping shapes give the point midway between their cores' closest
/// points. An empty proxy is infinitely far away.
SCREE_API void Distance(DistanceOutput* output, SimplexCache* cache, const DistanceInput* input);

struct ShapeCastInput {
    DistanceProxy proxyA;
    DistanceProxy proxyB;
    Transform transformA;
    Transform transformB;
    Vec2 translationB;  ///< the path of B, m; A stands still
};

struct ShapeCastOutput {
    Vec2 point;      ///< where B touches A, on A's surface, world; zero without a hit
    Vec2 normal;     ///< from A to B, unit length; zero without a hit
    float lambda;    ///< share of translationB travelled before the touch; 1 without a hit
    int iterations;  ///< rounds used
};

/// Moves B along translationB until it touches A. As in Box2D 2.4, every shape is at least polygonRadius thick. The
/// cores touch at a distance of max(polygonRadius, sum of radii − polygonRadius), or up to half of linearSlop more.
/// Returns false if they never touch, or overlap from the start: cores cross, or the vertices that lead the motion are
/// that near. Shapes that only start within touching distance hit at lambda 0.
SCREE_API bool ShapeCast(ShapeCastOutput* output, const ShapeCastInput* input);

/// True if the shapes, radii included, overlap or touch (within 10 float epsilons, m). The indices name children as in
/// DistanceProxy::Set.
SCREE_API bool TestOverlap(const Shape* shapeA, int indexA, const Shape* shapeB, int indexB, const Transform& xfA,
                           const Transform& xfB);

}  // namespace scree
