// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A solid convex polygon, counter-clockwise.

#pragma once

#include "b2_api.h"
#include "b2_shape.h"

class B2_API b2PolygonShape : public b2Shape {
public:
    b2PolygonShape() {
        m_type = e_polygon;
        m_radius = b2_polygonRadius;
        m_count = 0;
        m_centroid.SetZero();
    }

    b2Shape* Clone(b2BlockAllocator* allocator) const override;
    int32 GetChildCount() const override { return 1; }
    /// The convex hull of 3 to b2_maxPolygonVertices points. Refused with a message (the polygon stays as it is): a
    /// wrong count, points that are not finite or lie on a line.
    void Set(const b2Vec2* points, int32 count);
    /// A box by half widths, around the origin or around `center` and turned by `angle`.
    void SetAsBox(float hx, float hy);
    void SetAsBox(float hx, float hy, const b2Vec2& center, float angle);
    bool TestPoint(const b2Transform& transform, const b2Vec2& p) const override;
    bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                 int32 childIndex) const override;
    void ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const override;
    void ComputeMass(b2MassData* massData, float density) const override;
    /// Whether it is convex and counter-clockwise.
    bool Validate() const;

    b2Vec2 m_centroid;
    b2Vec2 m_vertices[b2_maxPolygonVertices];
    b2Vec2 m_normals[b2_maxPolygonVertices];
    int32 m_count;
};
