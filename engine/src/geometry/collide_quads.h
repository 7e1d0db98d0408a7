// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manifolds of polygons with three or four corners, eight pairs at a time: the same bits as CollidePolygons.

#pragma once

#include "geometry/quad_kernel.h"
#include "scree/collision.h"

namespace scree {

/// Up to eight pairs. Shapes must not change while the batch lives, placements not before Collide.
class QuadBatch {
public:
    explicit QuadBatch(QuadKernel kernel = GetQuadKernel()) : m_kernel(kernel) {}

    [[nodiscard]] static bool Takes(const Shape& shape) {
        return shape.GetType() == Shape::e_polygon && static_cast<const PolygonShape&>(shape).m_count <= 4;
    }

    [[nodiscard]] int Size() const { return m_size; }
    [[nodiscard]] bool IsFull() const { return m_size == quadLanes; }
    /// The number that the pair was added with.
    [[nodiscard]] int GetId(int pair) const { return m_id[pair]; }
    void Add(int id, const PolygonShape& a, const Transform& xfA, const PolygonShape& b, const Transform& xfB);
    void Collide();
    /// The manifold of a pair, after Collide. Impulses are left alone.
    void Write(int pair, Manifold& manifold) const;
    void Clear() { m_size = 0; }

private:
    QuadKernel m_kernel;
    QuadPairs m_pairs{};
    QuadContacts m_contacts{};
    // Neighbours often have the same shape, which then stays in its lane.
    const PolygonShape* m_shapeA[quadLanes]{};
    const PolygonShape* m_shapeB[quadLanes]{};
    int m_id[quadLanes]{};
    int m_size = 0;
};

}  // namespace scree
