// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Manifolds of polygons with three or four corners, with each other and with disks, eight pairs at a time: the same
// bits as CollidePolygons and CollidePolygonAndCircle. And of capsules and rounded polygons with such corners, with
// each other, with such polygons and with edges that have two sides: the bits of CollideConvex, which asks here.

#pragma once

#include "geometry/quad_kernel.h"
#include "scree/collision.h"
#include "scree/convex_shape.h"

namespace scree {

[[nodiscard]] inline bool IsQuad(const Shape& shape) {
    return shape.GetType() == Shape::e_polygon && static_cast<const PolygonShape&>(shape).m_count <= 4;
}
/// What the core of a shape is, if it is one of those that go eight at a time with any radius.
enum class CoreKind : int8_t { none = -1, segment, quad };
/// Capsules and edges that have two sides are segments.
[[nodiscard]] inline CoreKind CoreKindOf(const Shape& shape) {
    switch (shape.GetType()) {
        case Shape::e_edge:
            return static_cast<const EdgeShape&>(shape).m_oneSided ? CoreKind::none : CoreKind::segment;
        case Shape::e_polygon:
            return IsQuad(shape) ? CoreKind::quad : CoreKind::none;
        case Shape::e_convex: {
            const auto& convex = static_cast<const ConvexShape&>(shape);
            if (convex.m_curvedSides != 0 || convex.m_count < 2 || convex.m_count > 4) return CoreKind::none;
            return convex.m_count == 2 ? CoreKind::segment : CoreKind::quad;
        }
        default:
            return CoreKind::none;
    }
}

/// Two shapes as cores, at least one of them convex (e_convex); the other pairs have functions of their own.
struct CorePair {
    CoreKind a, b;
    CorePair(const Shape& shapeA, const Shape& shapeB) : a(CoreKind::none), b(CoreKind::none) {
        if (shapeA.GetType() != Shape::e_convex && shapeB.GetType() != Shape::e_convex) return;
        a = CoreKindOf(shapeA), b = CoreKindOf(shapeB);
    }
    [[nodiscard]] bool GoTogether() const { return a != CoreKind::none && b != CoreKind::none; }
};

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

    void AddPair(int id, const Shape& a, const Transform& xfA, const Shape& b, const Transform& xfB, float preference);

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

/// Pairs of one sort that go together.
class CoreBatch : public FaceBatch {
public:
    explicit CoreBatch(const CorePair& kinds, QuadKernels kernels = GetQuadKernels())
        : FaceBatch(kernels.collideCores[static_cast<int>(kinds.a)][static_cast<int>(kinds.b)]) {}

    void Add(int id, const Shape& a, const Transform& xfA, const Shape& b, const Transform& xfB);
};

/// Quads A and disks B.
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
