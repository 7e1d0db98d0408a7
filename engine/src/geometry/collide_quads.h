// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manifolds of polygons with three or four corners, with each other and with disks, eight pairs at a time: the same
// bits as CollidePolygons and CollidePolygonAndCircle. And of capsules, with each other, with such polygons and with
// edges that have two sides: the bits of CollideConvex, which asks here.

#pragma once

#include "geometry/quad_kernel.h"
#include "scree/collision.h"
#include "scree/convex_shape.h"

namespace scree {

[[nodiscard]] inline bool IsQuad(const Shape& shape) {
    return shape.GetType() == Shape::e_polygon && static_cast<const PolygonShape&>(shape).m_count <= 4;
}
[[nodiscard]] inline bool IsCapsule(const Shape& shape) {
    return shape.GetType() == Shape::e_convex && static_cast<const ConvexShape&>(shape).m_count == 2;
}
/// A capsule, or an edge that has two sides.
[[nodiscard]] inline bool IsSegment(const Shape& shape) {
    return IsCapsule(shape) || (shape.GetType() == Shape::e_edge && !static_cast<const EdgeShape&>(shape).m_oneSided);
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

/// Up to eight pairs whose faces are clipped against each other. Shapes must not change while the batch lives,
/// placements not before Collide.
class FaceBatch : public QuadLanes {
public:
    void Collide();
    /// The manifold of a pair, after Collide. Impulses are left alone.
    void Write(int pair, Manifold& manifold) const;

protected:
    using Kernel = void (*)(const QuadPairs& pairs, QuadContacts& contacts);

    explicit FaceBatch(Kernel kernel) : m_kernel(kernel) {}

    template <typename A, typename B>
    int AddPair(int id, const A& a, const Transform& xfA, const B& b, const Transform& xfB);
    void Prefer(int lane, float preference) { m_pairs.preference[lane] = preference; }
    [[nodiscard]] float GetRadius(int lane) const { return m_pairs.radius[lane]; }

private:
    Kernel m_kernel;
    QuadPairs m_pairs{};
    QuadContacts m_contacts{};
    // Neighbours often have the same shape, which then stays in its lane.
    const Shape* m_shapeA[quadLanes]{};
    const Shape* m_shapeB[quadLanes]{};
};

class QuadBatch : public FaceBatch {
public:
    explicit QuadBatch(QuadKernels kernels = GetQuadKernels()) : FaceBatch(kernels.collideQuads) {}

    /// Both shapes are quads (IsQuad).
    void Add(int id, const PolygonShape& a, const Transform& xfA, const PolygonShape& b, const Transform& xfB);
};

/// Segments (IsSegment) and capsules.
class CapsuleBatch : public FaceBatch {
public:
    explicit CapsuleBatch(QuadKernels kernels = GetQuadKernels()) : FaceBatch(kernels.collideCapsules) {}

    void Add(int id, const Shape& a, const Transform& xfA, const ConvexShape& b, const Transform& xfB);
};

/// Quads (IsQuad) and capsules.
class QuadCapsuleBatch : public FaceBatch {
public:
    explicit QuadCapsuleBatch(QuadKernels kernels = GetQuadKernels()) : FaceBatch(kernels.collideQuadCapsules) {}

    void Add(int id, const PolygonShape& a, const Transform& xfA, const ConvexShape& b, const Transform& xfB);
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
