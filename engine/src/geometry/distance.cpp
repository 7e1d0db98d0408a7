// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Proxies of shapes, and the distance of two placed ones: GJK on the cores, then the radii. Box2D 2.4's rules for
// overlap.

#include "geometry/distance.h"

#include <limits>

#include "scree/chain_shape.h"
#include "scree/convex_shape.h"

namespace scree {

void DistanceProxy::Set(const Shape* shape, int index) {
    switch (shape->GetType()) {
        case Shape::e_circle:
            Set(&static_cast<const CircleShape*>(shape)->m_p, 1, shape->m_radius);
            break;
        case Shape::e_edge:
            Set(&static_cast<const EdgeShape*>(shape)->m_vertex1, 2, shape->m_radius);
            break;
        case Shape::e_chain: {
            const auto* chain = static_cast<const ChainShape*>(shape);
            const bool exists = 0 <= index && index < chain->GetChildCount();
            Set(exists ? &chain->m_vertices[static_cast<size_t>(index)] : nullptr, exists ? 2 : 0, shape->m_radius);
            break;
        }
        case Shape::e_convex: {
            const auto* convex = static_cast<const ConvexShape*>(shape);
            Set(convex->m_vertices, convex->m_count, shape->m_radius);
            break;
        }
        default: {
            const auto* polygon = static_cast<const PolygonShape*>(shape);
            Set(polygon->m_vertices, polygon->m_count, shape->m_radius);
            break;
        }
    }
}

void DistanceProxy::Set(const Vec2* vertices, int count, float radius) {
    m_vertices = vertices;
    m_count = count;
    m_radius = radius;
}

int DistanceProxy::GetSupport(Vec2 d) const {
    int best = 0;
    for (int i = 1; i < m_count; ++i) {
        if (Dot(m_vertices[i], d) > Dot(m_vertices[best], d)) best = i;
    }
    return best;
}

namespace {

/// Grows cores that are `output.distance` apart by their radii.
void AddRadii(DistanceOutput& output, float radiusA, float radiusB, Vec2 normal) {
    const float radii = radiusA + radiusB;
    if (output.distance > radii && output.distance > std::numeric_limits<float>::epsilon()) {
        output.distance -= radii;
        output.pointA += radiusA * normal;
        output.pointB -= radiusB * normal;
    } else if (!std::isnan(output.distance)) {
        output.pointA = 0.5f * (output.pointA + output.pointB);
        output.pointB = output.pointA;
        output.distance = 0.0f;
    }
}

}  // namespace

void Distance(DistanceOutput* output, SimplexCache* cache, const DistanceInput* input) {
    if (input->proxyA.m_count < 1 || input->proxyB.m_count < 1) {
        *output = {vec2Zero, vec2Zero, std::numeric_limits<float>::infinity(), 0};
        cache->count = 0;
        return;
    }
    const PlacedCores placed = PlaceCores(input->proxyA, input->transformA, input->proxyB, input->transformB);
    const Nearest nearest = FindNearest(placed.a, placed.b, placed.xfB, *cache);
    const NearestPoints points = FindNearestPoints(placed.a, placed.b, placed.xfB, nearest);
    output->pointA = Mul(input->transformA, points.onA + placed.a.origin);
    output->pointB = Mul(input->transformA, points.onB + placed.a.origin);
    output->distance = nearest.distance;
    output->iterations = nearest.iterations;
    if (input->useRadii) {
        const Vec2 normal = Mul(input->transformA.q, nearest.normal);
        AddRadii(*output, input->proxyA.m_radius, input->proxyB.m_radius, normal);
    }
}

}  // namespace scree
