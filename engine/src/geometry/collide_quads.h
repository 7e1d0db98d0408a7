// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manifolds of polygons with three or four corners, with each other and with disks, eight pairs at a time: the same
// bits as CollidePolygons and CollidePolygonAndCircle.

#pragma once

#include "geometry/quad_kernel.h"
#include "scree/collision.h"

namespace scree {

[[nodiscard]] inline bool IsQuad(const Shape& shape) {
    return shape.GetType() == Shape::e_polygon && static_cast<const PolygonShape&>(shape).m_count <= 4;
}

/// The lanes in use of a batch, and the number that each pair was added with.
class QuadLanes {
public:
    [[nodiscard]] int Size() const { return m_size; }
    [[nodiscard]] bool IsFull() const { return m_size == quadLanes; }
    [[nodiscard]] int GetId(int pair) const { return m_id[pair]; }
    void Clear() { m_size = 0; }

protected:
    int Take(int id) {
        m_id[m_size] = id;
        return m_size++;
    }

private:
    int m_id[quadLanes]{};
    int m_size = 0;
};

/// Up to eight pairs. Shapes must not change while the batch lives, placements not before Collide.
class QuadBatch : public QuadLanes {
public:
    explicit QuadBatch(QuadKernels kernels = GetQuadKernels()) : m_kernel(kernels.collideQuads) {}

    /// Both shapes are quads (IsQuad).
    void Add(int id, const PolygonShape& a, const Transform& xfA, const PolygonShape& b, const Transform& xfB);
    void Collide();
    /// The manifold of a pair, after Collide. Impulses are left alone.
    void Write(int pair, Manifold& manifold) const;

private:
    decltype(QuadKernels::collideQuads) m_kernel;
    QuadPairs m_pairs{};
    QuadContacts m_contacts{};
    // Neighbours often have the same shape, which then stays in its lane.
    const PolygonShape* m_shapeA[quadLanes]{};
    const PolygonShape* m_shapeB[quadLanes]{};
};

/// The same for quads A and disks B.
class QuadDiskBatch : public QuadLanes {
public:
    explicit QuadDiskBatch(QuadKernels kernels = GetQuadKernels()) : m_kernel(kernels.collideQuadDisks) {}

    void Add(int id, const PolygonShape& a, const Transform& xfA, const CircleShape& b, const Transform& xfB);
    void Collide();
    void Write(int pair, Manifold& manifold) const;

private:
    decltype(QuadKernels::collideQuadDisks) m_kernel;
    QuadDiskPairs m_pairs{};
    QuadDiskContacts m_contacts{};
    const PolygonShape* m_shapeA[quadLanes]{};
};

}  // namespace scree
