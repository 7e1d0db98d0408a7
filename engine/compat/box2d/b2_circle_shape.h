// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A solid disk.

#pragma once

#include "b2_api.h"
#include "b2_shape.h"

class B2_API b2CircleShape : public b2Shape {
public:
    b2CircleShape() {
        m_type = e_circle;
        m_radius = 0.0f;
        m_p.SetZero();
    }

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; }
    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float density) const override;

    /// The centre.
    b2Vec2 m_p;
};
