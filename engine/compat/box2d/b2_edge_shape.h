// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A line segment, one-sided with ghost vertices or two-sided.

#pragma once

#include "b2_api.h"
#include "b2_shape.h"

class B2_API b2EdgeShape : public b2Shape {
public:
    b2EdgeShape() {
        m_type = e_edge;
        m_radius = b2_polygonRadius;
        m_vertex0.SetZero();
        m_vertex1.SetZero();
        m_vertex2.SetZero();
        m_vertex3.SetZero();
        m_oneSided = false;
    }

    /// The edge v1→v2 collides on its right; v0 and v3 are the far ends of its neighbours.
    void SetOneSided(const b2Vec2& v0, const b2Vec2& v1, const b2Vec2& v2, const b2Vec2& v3);
    void SetTwoSided(const b2Vec2& v1, const b2Vec2& v2);

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; }
    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float density) const override;

    b2Vec2 m_vertex1, m_vertex2;
    b2Vec2 m_vertex0, m_vertex3;
    bool m_oneSided;
};
