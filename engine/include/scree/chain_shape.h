// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A chain of line segments, as a definition. Body::CreateFixture makes a one-sided edge fixture of each segment.
// Its ghosts are the neighbours' far vertices, so nothing catches at the seams (E. Catto, "Ghost Collisions",
// box2d.org, June 2020; chains as plain edges: the dissertation, §7.1).

#pragma once

#include <vector>

#include "scree/api.h"
#include "scree/shape.h"

namespace scree {

/// An open chain or a loop. Segments collide on the right of v[i] → v[i+1]: a loop wound counter-clockwise collides
/// outside, one wound clockwise inside. Massless.
class SCREE_API ChainShape final : public Shape {
public:
    ChainShape() : Shape(e_chain, polygonRadius) {}

    /// Makes the chain empty.
    void Clear();
    /// A closed chain through `count` ≥ 3 vertices; the last joins the first. False, and the chain stays as it was, if
    /// the vertices are null, too few, not finite, or neighbours are closer than linearSlop.
    [[nodiscard]] bool CreateLoop(const Vec2* vertices, int count);
    /// An open chain through `count` ≥ 2 vertices; the ghosts say how the surface goes on before and after it. False,
    /// and the chain stays as it was, for bad vertices as in CreateLoop or a ghost that is not finite.
    [[nodiscard]] bool CreateChain(const Vec2* vertices, int count, Vec2 prevVertex, Vec2 nextVertex);

    /// Number of segments.
    [[nodiscard]] int GetChildCount() const;
    /// Segment `index` with its ghosts. Precondition: 0 ≤ index < GetChildCount().
    void GetChildEdge(EdgeShape* edge, int index) const;

    /// Always false: a chain has no inside.
    [[nodiscard]] bool TestPoint(const Transform& xf, Vec2 p) const override;
    /// The nearest hit on any segment. O(segments).
    bool RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const override;
    /// Around all segments. O(segments).
    void ComputeAABB(AABB* aabb, const Transform& xf) const override;
    void ComputeMass(MassData* massData, float density) const override;

    std::vector<Vec2> m_vertices;  ///< a loop repeats its first vertex at the end
    Vec2 m_prevVertex{0.0f, 0.0f}, m_nextVertex{0.0f, 0.0f};
};

}  // namespace scree
