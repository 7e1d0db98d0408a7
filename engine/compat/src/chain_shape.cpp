// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chains: the vertices are the program's view, the edges the engine's.

#include <new>

#include "../box2d/b2_block_allocator.h"
#include "convert.h"

namespace scree::box2d {

ChainShape ToScree(const b2ChainShape& chain) {
    ChainShape out;
    for (int i = 0; i < chain.m_count; ++i) out.m_vertices.push_back(ToScree(chain.m_vertices[i]));
    out.m_prevVertex = ToScree(chain.m_prevVertex);
    out.m_nextVertex = ToScree(chain.m_nextVertex);
    out.m_radius = chain.m_radius;
    return out;
}

namespace {

/// In metres.
std::vector<Vec2> CopyVertices(const b2Vec2* vertices, int count) {
    std::vector<Vec2> copy;
    if (vertices == nullptr) return copy;
    for (int i = 0; i < count; ++i) copy.push_back(metres * ToScree(vertices[i]));
    return copy;
}

/// `unit`: what a length of `chain` is in the program's units.
void Assign(b2ChainShape& out, const ChainShape& chain, float unit) {
    out.Clear();
    out.m_count = static_cast<int32>(chain.m_vertices.size());
    out.m_vertices = static_cast<b2Vec2*>(b2Alloc(out.m_count * static_cast<int32>(sizeof(b2Vec2))));
    for (int i = 0; i < out.m_count; ++i)
        new (&out.m_vertices[i]) b2Vec2(ToBox2d(unit * chain.m_vertices[static_cast<size_t>(i)]));
    out.m_prevVertex = ToBox2d(unit * chain.m_prevVertex);
    out.m_nextVertex = ToBox2d(unit * chain.m_nextVertex);
}

}  // namespace

}  // namespace scree::box2d

using namespace scree::box2d;

b2ChainShape::~b2ChainShape() { Clear(); }

b2ChainShape::b2ChainShape(const b2ChainShape& other) : b2ChainShape() { *this = other; }

b2ChainShape& b2ChainShape::operator=(const b2ChainShape& other) {
    if (this == &other) return *this;
    m_radius = other.m_radius;
    Assign(*this, ToScree(other), 1.0f);
    return *this;
}

void b2ChainShape::Clear() {
    if (m_vertices != nullptr) b2Free(m_vertices);
    m_vertices = nullptr;
    m_count = 0;
}

void b2ChainShape::CreateLoop(const b2Vec2* vertices, int32 count) {
    const std::vector<scree::Vec2> copy = CopyVertices(vertices, count);
    scree::ChainShape chain;
    if (copy.empty() || !chain.CreateLoop(copy.data(), count)) {
        return Complain("b2ChainShape::CreateLoop", "give at least 3 finite vertices farther apart than b2_linearSlop");
    }
    Assign(*this, chain, b2_lengthUnitsPerMeter);
}

void b2ChainShape::CreateChain(const b2Vec2* vertices, int32 count, const b2Vec2& prevVertex,
                               const b2Vec2& nextVertex) {
    const std::vector<scree::Vec2> copy = CopyVertices(vertices, count);
    scree::ChainShape chain;
    if (copy.empty() ||
        !chain.CreateChain(copy.data(), count, metres * ToScree(prevVertex), metres * ToScree(nextVertex))) {
        return Complain("b2ChainShape::CreateChain",
                        "give at least 2 finite vertices farther apart than b2_linearSlop");
    }
    Assign(*this, chain, b2_lengthUnitsPerMeter);
}

b2Shape* b2ChainShape::Clone(b2BlockAllocator* allocator) const {
    void* memory = allocator != nullptr ? allocator->Allocate(static_cast<int32>(sizeof(b2ChainShape))) : nullptr;
    return memory != nullptr ? new (memory) b2ChainShape(*this) : nullptr;
}

int32 b2ChainShape::GetChildCount() const { return m_count - 1; }

void b2ChainShape::GetChildEdge(b2EdgeShape* edge, int32 index) const {
    if (index < 0 || index >= GetChildCount()) return;
    edge->m_type = e_edge;
    edge->m_radius = m_radius;
    edge->SetOneSided(index > 0 ? m_vertices[index - 1] : m_prevVertex, m_vertices[index], m_vertices[index + 1],
                      index + 2 < m_count ? m_vertices[index + 2] : m_nextVertex);
}

bool b2ChainShape::TestPoint(const b2Transform&, const b2Vec2&) const { return false; }

/// Box2D 2.4's rule: rays hit the edges of a chain from both sides, ghosts or not.
bool b2ChainShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input, const b2Transform& transform,
                           int32 childIndex) const {
    if (childIndex < 0 || childIndex >= GetChildCount()) return false;
    b2EdgeShape edge;
    edge.SetTwoSided(m_vertices[childIndex], m_vertices[childIndex + 1]);
    return edge.RayCast(output, input, transform, 0);
}

void b2ChainShape::ComputeAABB(b2AABB* aabb, const b2Transform& transform, int32 childIndex) const {
    if (childIndex < 0 || childIndex >= GetChildCount()) return;
    b2EdgeShape edge;
    GetChildEdge(&edge, childIndex);
    edge.ComputeAABB(aabb, transform, 0);
}

void b2ChainShape::ComputeMass(b2MassData* massData, float) const {
    massData->mass = 0.0f;
    massData->center.SetZero();
    massData->I = 0.0f;
}
