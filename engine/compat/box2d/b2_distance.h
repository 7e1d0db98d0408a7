// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Distance of two convex shapes, and the first touch of a shape that is moved along a line.

#pragma once

#include "b2_api.h"
#include "b2_math.h"

class b2Shape;

/// A convex point cloud with a radius: what distance functions see of a shape.
struct B2_API b2DistanceProxy {
    b2DistanceProxy() : m_vertices(nullptr), m_count(0), m_radius(0.0f) {}

    /// The shape (or vertices) must live as long as the proxy. A null shape or a child that does not exist empties it.
    void Set(const b2Shape* shape, int32 index);
    void Set(const b2Vec2* vertices, int32 count, float radius);

    /// The vertex that is farthest along d.
    int32 GetSupport(const b2Vec2& d) const {
        int32 best = 0;
        for (int32 i = 1; i < m_count; ++i) {
            if (b2Dot(m_vertices[i], d) > b2Dot(m_vertices[best], d)) best = i;
        }
        return best;
    }
    const b2Vec2& GetSupportVertex(const b2Vec2& d) const { return m_vertices[GetSupport(d)]; }
    int32 GetVertexCount() const { return m_count; }
    const b2Vec2& GetVertex(int32 index) const { return m_vertices[index]; }

    b2Vec2 m_buffer[2];
    const b2Vec2* m_vertices;
    int32 m_count;
    float m_radius;
};

/// What warm-starts the next b2Distance of the same shapes; set count to 0 for the first.
struct B2_API b2SimplexCache {
    float metric;
    uint16 count;
    uint8 indexA[3];
    uint8 indexB[3];
};

struct B2_API b2DistanceInput {
    b2DistanceProxy proxyA;
    b2DistanceProxy proxyB;
    b2Transform transformA;
    b2Transform transformB;
    bool useRadii;
};

/// The closest points and their distance, 0 when the shapes overlap.
struct B2_API b2DistanceOutput {
    b2Vec2 pointA;
    b2Vec2 pointB;
    float distance;
    int32 iterations;
};

B2_API void b2Distance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceInput* input);

struct B2_API b2ShapeCastInput {
    b2DistanceProxy proxyA;
    b2DistanceProxy proxyB;
    b2Transform transformA;
    b2Transform transformB;
    b2Vec2 translationB;
};

/// The first touch is at the share lambda of the translation.
struct B2_API b2ShapeCastOutput {
    b2Vec2 point;
    b2Vec2 normal;
    float lambda;
    int32 iterations;
};

/// False if B never touches A, or overlaps it from the start.
B2_API bool b2ShapeCast(b2ShapeCastOutput* output, const b2ShapeCastInput* input);
