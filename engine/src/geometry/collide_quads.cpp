// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is left to do pair by pair around the vector kernels: shapes go in, feature ids and manifolds come out.

#include "geometry/collide_quads.h"

#include "geometry/clip.h"
#include "geometry/convex_curve.h"
#include "geometry/polygon_preference.h"

namespace scree {

namespace {

void LoadCorners(const Vec2* vertices, const Vec2* normals, int count, int lane, QuadShapes& shapes) {
    for (int i = 0; i < 4; ++i) {
        const int corner = i < count ? i : 0;
        shapes.vertexX[i][lane] = vertices[corner].x, shapes.vertexY[i][lane] = vertices[corner].y;
        shapes.normalX[i][lane] = normals[corner].x, shapes.normalY[i][lane] = normals[corner].y;
    }
    shapes.last[lane] = static_cast<float>(count - 1);
}

void LoadShape(const Shape& shape, int lane, QuadShapes& shapes) {
    switch (shape.GetType()) {
        case Shape::e_convex: {
            const auto& convex = static_cast<const ConvexShape&>(shape);
            return LoadCorners(convex.m_vertices, convex.m_normals, convex.m_count, lane, shapes);
        }
        case Shape::e_edge: {
            const auto& edge = static_cast<const EdgeShape&>(shape);
            Vec2 right = Cross(edge.m_vertex2 - edge.m_vertex1, 1.0f);
            right.Normalize();
            const Vec2 normals[2] = {right, -right};
            return LoadCorners(&edge.m_vertex1, normals, 2, lane, shapes);
        }
        default: {
            const auto& polygon = static_cast<const PolygonShape&>(shape);
            return LoadCorners(polygon.m_vertices, polygon.m_normals, polygon.m_count, lane, shapes);
        }
    }
}

/// Lanes to spare repeat the first.
template <typename Pairs>
void FillSpareLanes(Pairs& pairs, int size) {
    for (int lane = size; lane < quadLanes; ++lane) {
        pairs.placedA[lane] = pairs.placedA[0];
        pairs.placedB[lane] = pairs.placedB[0];
    }
}

/// The feature ids of both ends of the clipped segment.
struct Keys {
    uint32_t first, second;

    void Cut(bool moved, int corner) {
        const uint32_t cut = MakeCutKey(first, corner);
        if (moved) first = second;
        second = cut;
    }
};

}  // namespace

void FaceBatch::AddPair(int id, const Shape& a, const Transform& xfA, const Shape& b, const Transform& xfB,
                        float preference) {
    static_assert(sizeof(Transform) == 4 * sizeof(float));
    const int lane = Take(id);
    if (m_shapeA[lane] != &a) LoadShape(*(m_shapeA[lane] = &a), lane, m_pairs.a);
    if (m_shapeB[lane] != &b) LoadShape(*(m_shapeB[lane] = &b), lane, m_pairs.b);
    m_pairs.placedA[lane] = &xfA.p.x;
    m_pairs.placedB[lane] = &xfB.p.x;
    m_pairs.radius[lane] = a.m_radius + b.m_radius;
    m_pairs.preference[lane] = preference;
}

void FaceBatch::Collide() {
    FillSpareLanes(m_pairs, Size());
    m_kernel(m_pairs, m_contacts);
}

void QuadBatch::Add(int id, const PolygonShape& a, const Transform& xfA, const PolygonShape& b, const Transform& xfB) {
    AddPair(id, a, xfA, b, xfB, ReferencePreference(a.m_radius + b.m_radius));
}

void CoreBatch::Add(int id, const Shape& a, const Transform& xfA, const Shape& b, const Transform& xfB) {
    AddPair(id, a, xfA, b, xfB, convexPreference);
}

void FaceBatch::Write(int pair, Manifold& manifold) const {
    manifold.pointCount = 0;
    const QuadContacts& c = m_contacts;
    const auto isSet = [&](uint32_t mask) { return (mask >> pair & 1u) != 0; };
    if (!isSet(c.touching)) return;
    const auto corner = [&](const QuadContacts::Row& row) { return static_cast<int>(row[pair]); };
    const int face = corner(c.face);
    if (isSet(c.isCorners | c.isPoint)) {
        const bool isPoint = isSet(c.isPoint);
        manifold.type = isPoint ? Manifold::e_faceA : Manifold::e_circles;
        manifold.localNormal = isPoint ? Vec2{c.localNormalX[pair], c.localNormalY[pair]} : vec2Zero;
        manifold.localPoint = {c.localPointX[pair], c.localPointY[pair]};
        manifold.pointCount = 1;
        manifold.points[0].localPoint = {c.pointX[0][pair], c.pointY[0][pair]};
        manifold.points[0].id.key =
            MakeContactKey(isPoint ? curveFeature : face, ContactFeature::e_vertex,
                           isPoint ? curveFeature : corner(c.incident), ContactFeature::e_vertex);
        return;
    }
    const auto keyOf = [&](int incident) {
        return MakeContactKey(face, ContactFeature::e_face, incident, ContactFeature::e_vertex);
    };
    Keys keys{keyOf(corner(c.incident)), keyOf(corner(c.incidentNext))};
    if (isSet(c.isCut[0])) keys.Cut(isSet(c.hasMoved[0]), face);
    if (isSet(c.isCut[1])) keys.Cut(isSet(c.hasMoved[1]), corner(c.faceNext));

    const bool flipped = isSet(c.flipped);
    manifold.type = flipped ? Manifold::e_faceB : Manifold::e_faceA;
    manifold.localNormal = {c.localNormalX[pair], c.localNormalY[pair]};
    manifold.localPoint = {c.localPointX[pair], c.localPointY[pair]};
    for (int i = 0; i < maxManifoldPoints; ++i) {
        if (!isSet(c.keeps[i])) continue;
        const uint32_t key = i == 0 ? keys.first : keys.second;
        ManifoldPoint& point = manifold.points[manifold.pointCount++];
        point.localPoint = {c.pointX[i][pair], c.pointY[i][pair]};
        point.id.key = flipped ? SwapContactKey(key) : key;
    }
}

void QuadDiskBatch::Add(int id, const PolygonShape& a, const Transform& xfA, const CircleShape& b,
                        const Transform& xfB) {
    const int lane = Take(id);
    if (m_shapeA[lane] != &a) LoadShape(*(m_shapeA[lane] = &a), lane, m_pairs.a);
    m_pairs.placedA[lane] = &xfA.p.x;
    m_pairs.placedB[lane] = &xfB.p.x;
    m_pairs.centreX[lane] = b.m_p.x, m_pairs.centreY[lane] = b.m_p.y;
    m_pairs.radius[lane] = a.m_radius + b.m_radius;
}

void QuadDiskBatch::Collide() {
    FillSpareLanes(m_pairs, Size());
    m_kernel(m_pairs, m_contacts);
}

void QuadDiskBatch::Write(int pair, Manifold& manifold) const {
    manifold.pointCount = 0;
    if ((m_contacts.touching >> pair & 1u) == 0) return;
    manifold.type = Manifold::e_faceA;
    manifold.localNormal = {m_contacts.localNormalX[pair], m_contacts.localNormalY[pair]};
    manifold.localPoint = {m_contacts.localPointX[pair], m_contacts.localPointY[pair]};
    manifold.pointCount = 1;
    manifold.points[0].localPoint = {m_pairs.centreX[pair], m_pairs.centreY[pair]};
    manifold.points[0].id.key = 0;
}

}  // namespace scree
