// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The chain as a list of one-sided edges: vertices → edges with the neighbours' far vertices as ghosts (E. Catto,
// "Ghost Collisions", box2d.org, June 2020).

#include "scree/chain_shape.h"

#include <utility>

namespace scree {

namespace {

/// Vertices that make edges: there, finite, neighbours apart by more than the slop.
bool AreUsable(const Vec2* vertices, int count) {
    for (int i = 0; i < count; ++i) {
        if (!vertices[i].IsValid()) return false;
        if (i > 0 && !(DistanceSquared(vertices[i - 1], vertices[i]) > linearSlop * linearSlop)) return false;
    }
    return true;
}

}  // namespace

void ChainShape::Clear() {
    m_vertices.clear();
    m_prevVertex = m_nextVertex = vec2Zero;
}

bool ChainShape::CreateLoop(const Vec2* vertices, int count) {
    if (vertices == nullptr || count < 3 || !AreUsable(vertices, count)) return false;
    const Vec2 seam[2] = {vertices[count - 1], vertices[0]};
    if (!AreUsable(seam, 2)) return false;
    std::vector<Vec2> closed(vertices, vertices + count);
    closed.push_back(vertices[0]);
    m_vertices = std::move(closed);
    m_prevVertex = m_vertices[static_cast<size_t>(count) - 1];
    m_nextVertex = m_vertices[1];
    return true;
}

bool ChainShape::CreateChain(const Vec2* vertices, int count, Vec2 prevVertex, Vec2 nextVertex) {
    if (vertices == nullptr || count < 2 || !AreUsable(vertices, count)) return false;
    if (!prevVertex.IsValid() || !nextVertex.IsValid()) return false;
    m_vertices = std::vector<Vec2>(vertices, vertices + count);
    m_prevVertex = prevVertex;
    m_nextVertex = nextVertex;
    return true;
}

int ChainShape::GetChildCount() const { return m_vertices.empty() ? 0 : static_cast<int>(m_vertices.size()) - 1; }

void ChainShape::GetChildEdge(EdgeShape* edge, int index) const {
    const auto i = static_cast<size_t>(index);
    const Vec2 before = i > 0 ? m_vertices[i - 1] : m_prevVertex;
    const Vec2 after = i + 2 < m_vertices.size() ? m_vertices[i + 2] : m_nextVertex;
    edge->SetOneSided(before, m_vertices[i], m_vertices[i + 1], after);
    edge->m_radius = m_radius;
}

bool ChainShape::TestPoint(const Transform&, Vec2) const { return false; }

bool ChainShape::RayCast(RayCastOutput* output, const RayCastInput& input, const Transform& xf) const {
    RayCastInput rest = input;
    bool hit = false;
    for (int i = 0; i < GetChildCount(); ++i) {
        EdgeShape edge;
        GetChildEdge(&edge, i);
        RayCastOutput found;
        if (!edge.RayCast(&found, rest, xf)) continue;
        *output = found;
        rest.maxFraction = found.fraction;
        hit = true;
    }
    return hit;
}

void ChainShape::ComputeAABB(AABB* aabb, const Transform& xf) const {
    *aabb = {xf.p, xf.p};
    for (int i = 0; i < GetChildCount(); ++i) {
        EdgeShape edge;
        GetChildEdge(&edge, i);
        AABB box;
        edge.ComputeAABB(&box, xf);
        *aabb = i == 0 ? box : Union(*aabb, box);
    }
}

void ChainShape::ComputeMass(MassData* massData, float) const { *massData = {}; }

}  // namespace scree
