// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A free-form sequence of one-sided edges, open or a loop. As a fixture it stays one fixture; its children are the
// edges.

#pragma once

#include "b2_api.h"
#include "b2_shape.h"

class b2EdgeShape;

class B2_API b2ChainShape : public b2Shape {
public:
    b2ChainShape() {
        m_type = e_chain;
        m_radius = b2_polygonRadius;
        m_vertices = nullptr;
        m_count = 0;
        m_prevVertex.SetZero();
        m_nextVertex.SetZero();
    }
    ~b2ChainShape();
    b2ChainShape(const b2ChainShape& other);
    b2ChainShape& operator=(const b2ChainShape& other);

    /// Takes all vertices away.
    void Clear();
    /// A closed chain of at least 3 vertices, counter-clockwise for a solid island. The vertices are copied. Refused
    /// with a message (the chain stays as it is): too few, not finite, neighbours nearer than b2_linearSlop.
    void CreateLoop(const b2Vec2* vertices, int32 count);
    /// An open chain of at least 2 vertices between two ghost vertices.
    void CreateChain(const b2Vec2* vertices, int32 count, const b2Vec2& prevVertex, const b2Vec2& nextVertex);

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override;
    /// The edge `index` with its ghost vertices; an index out of range leaves `edge` as it is.
    void GetChildEdge(b2EdgeShape* edge, int32 index) const;
    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float density) const override;

    /// Owned; a loop repeats its first vertex at the end.
    b2Vec2* m_vertices;
    int32 m_count;
    b2Vec2 m_prevVertex, m_nextVertex;
};
