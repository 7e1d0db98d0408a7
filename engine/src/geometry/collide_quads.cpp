// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is left to do pair by pair around the vector kernels: shapes go in, feature ids and manifolds come out.

#include "geometry/collide_quads.h"

#include "geometry/clip.h"
#include "geometry/polygon_preference.h"

namespace scree {

namespace {

void LoadShape(const PolygonShape& shape, int lane, QuadShapes& shapes) {
    for (int i = 0; i < 4; ++i) {
        const int corner = i < shape.m_count ? i : 0;
        shapes.vertexX[i][lane] = shape.m_vertices[corner].x, shapes.vertexY[i][lane] = shape.m_vertices[corner].y;
        shapes.normalX[i][lane] = shape.m_normals[corner].x, shapes.normalY[i][lane] = shape.m_normals[corner].y;
    }
    shapes.last[lane] = static_cast<float>(shape.m_count - 1);
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

void QuadBatch::Add(int id, const PolygonShape& a, const Transform& xfA, const PolygonShape& b, const Transform& xfB) {
    static_assert(sizeof(Transform) == 4 * sizeof(float));
    const int lane = Take(id);
    if (m_shapeA[lane] != &a) LoadShape(*(m_shapeA[lane] = &a), lane, m_pairs.a);
    if (m_shapeB[lane] != &b) LoadShape(*(m_shapeB[lane] = &b), lane, m_pairs.b);
    m_pairs.placedA[lane] = &xfA.p.x;
    m_pairs.placedB[lane] = &xfB.p.x;
    m_pairs.radius[lane] = a.m_radius + b.m_radius;
    m_pairs.preference[lane] = ReferencePreference(m_pairs.radius[lane]);
}

void QuadBatch::Collide() {
    FillSpareLanes(m_pairs, Size());
    m_kernel(m_pairs, m_contacts);
}

void QuadBatch::Write(int pair, Manifold& manifold) const {
    manifold.pointCount = 0;
    const QuadContacts& c = m_contacts;
    const auto isSet = [&](uint32_t mask) { return (mask >> pair & 1u) != 0; };
    if (!isSet(c.touching)) return;
    const auto corner = [&](const QuadContacts::Row& row) { return static_cast<int>(row[pair]); };
    const int face = corner(c.face);
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
