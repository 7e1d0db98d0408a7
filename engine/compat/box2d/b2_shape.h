// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is common to the shapes of Box2D 2.4. Shapes are values of the program; fixtures keep a copy.

#pragma once

#include "b2_api.h"
#include "b2_collision.h"
#include "b2_math.h"

class b2BlockAllocator;

/// Mass, centre, and inertia about the ORIGIN of the shape.
struct B2_API b2MassData {
    float mass;
    b2Vec2 center;
    float I;
};

/// A shape of one or more children: a chain has one child for each edge, the others have one.
class B2_API b2Shape {
public:
    enum Type { e_circle = 0, e_edge = 1, e_polygon = 2, e_chain = 3, e_typeCount = 4 };

    virtual ~b2Shape() {}

    /// A copy in memory of the allocator; null without one.
    virtual b2Shape* Clone(b2BlockAllocator* allocator) const = 0;
    Type GetType() const { return m_type; }
    virtual int32 GetChildCount() const = 0;
    /// Whether the world point p is inside; never for edges and chains.
    virtual bool TestPoint(const b2Transform& xf, const b2Vec2& p) const = 0;
    /// False if the ray misses the child or starts inside, and for a child that does not exist.
    virtual bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                         int32 childIndex) const = 0;
    /// The tight box, skin included.
    virtual void ComputeAABB(b2AABB* aabb, const b2Transform& xf, int32 childIndex) const = 0;
    virtual void ComputeMass(b2MassData* massData, float density) const = 0;

    Type m_type;
    /// A circle's radius; the skin of the others.
    float m_radius;
};
