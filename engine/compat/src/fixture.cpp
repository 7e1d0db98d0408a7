// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2Fixture: one fixture of the engine, or for a chain one for each edge.

#include "../box2d/b2_fixture.h"

#include <utility>

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

namespace {

scree::FixtureDef ConvertDef(const b2FixtureDef& def) {
    scree::FixtureDef out;
    out.friction = def.friction;
    out.restitution = def.restitution;
    out.restitutionThreshold = def.restitutionThreshold;
    out.density = def.density;
    out.isSensor = def.isSensor;
    out.filter = ToScree(def.filter);
    return out;
}

/// The engine's fixture(s) of a definition: the first one, or null if it was refused.
scree::Fixture* CreateInEngine(scree::Body& body, const b2FixtureDef& def) {
    scree::FixtureDef converted = ConvertDef(def);
    if (def.shape->GetType() == b2Shape::e_chain) {
        const scree::ChainShape chain = ToScree(static_cast<const b2ChainShape&>(*def.shape));
        converted.shape = &chain;
        return body.CreateFixture(&converted);
    }
    return WithChild(*def.shape, 0, [&](const auto& shape) {
        converted.shape = &shape;
        return body.CreateFixture(&converted);
    });
}

}  // namespace

b2Fixture* b2Bridge::MakeFixture(b2Body& body, const b2FixtureDef& def) {
    b2WorldData& data = Data(body);
    scree::Fixture* first = CreateInEngine(*body.m_handle, def);
    if (first == nullptr) return nullptr;
    auto* fixture = new b2Fixture;
    fixture->m_body = &body;
    fixture->m_next = body.m_fixtureList;
    body.m_fixtureList = fixture;
    fixture->m_shape = def.shape->Clone(&data.allocator);
    fixture->m_shapeExposed = false;
    fixture->m_density = def.density;
    fixture->m_filter = def.filter;
    fixture->m_userData = def.userData;
    const bool isChain = fixture->GetType() == b2Shape::e_chain;
    fixture->m_childCount = fixture->m_shape->GetChildCount();
    fixture->m_handles = new scree::Fixture*[static_cast<size_t>(fixture->m_childCount)]();
    fixture->m_proxies = new b2FixtureProxy[static_cast<size_t>(fixture->m_childCount)]();
    if (isChain) {
        ++data.chainCount;
        // Newest first, so the edges of this chain are the head of the body's list.
        const int chainId = first->GetChainId();
        for (scree::Fixture* f = body.m_handle->GetFixtureList(); f != nullptr && f->GetChainId() == chainId;
             f = f->GetNext()) {
            fixture->m_handles[f->GetChainIndex()] = f;
        }
    } else {
        fixture->m_handles[0] = first;
    }
    for (int32 child = 0; child < fixture->m_childCount; ++child) {
        b2FixtureProxy& proxy = fixture->m_proxies[child];
        proxy.aabb = ToBox2d(fixture->m_handles[child]->GetAABB());
        proxy.fixture = fixture;
        proxy.childIndex = child;
        proxy.proxyId = b2BroadPhase::e_nullProxy;
        fixture->m_handles[child]->SetUserData({reinterpret_cast<uintptr_t>(&proxy)});
    }
    Refresh(body);
    Touch(data);
    return fixture;
}

void b2Bridge::Unlink(const b2Fixture* fixture) {
    b2Fixture** link = &fixture->m_body->m_fixtureList;
    while (*link != nullptr && *link != fixture) link = &(*link)->m_next;
    if (*link != nullptr) *link = fixture->m_next;
}

void b2Bridge::FreeFixture(b2Fixture* fixture) {
    b2WorldData& data = Data(*fixture->m_body);
    FreeContactsOf(data, fixture);
    ForgetShape(data, fixture);
    ForgetReports(data, fixture);
    if (fixture->GetType() == b2Shape::e_chain) --data.chainCount;
    Unlink(fixture);
    DestroyClone(fixture->m_shape, data.allocator);
    delete[] fixture->m_handles;
    delete[] fixture->m_proxies;
    delete fixture;
}

namespace {

bool Equal(const scree::CircleShape& a, const scree::CircleShape& b) {
    return a.m_p == b.m_p && a.m_radius == b.m_radius;
}
bool Equal(const scree::EdgeShape& a, const scree::EdgeShape& b) {
    return a.m_vertex1 == b.m_vertex1 && a.m_vertex2 == b.m_vertex2 && a.m_vertex0 == b.m_vertex0 &&
           a.m_vertex3 == b.m_vertex3 && a.m_oneSided == b.m_oneSided && a.m_radius == b.m_radius;
}
bool Equal(const scree::PolygonShape& a, const scree::PolygonShape& b) {
    return a.m_count == b.m_count && a.m_centroid == b.m_centroid && a.m_radius == b.m_radius &&
           std::equal(a.m_vertices, a.m_vertices + a.m_count, b.m_vertices) &&
           std::equal(a.m_normals, a.m_normals + a.m_count, b.m_normals);
}

bool Equal(const scree::ConvexShape& a, const scree::ConvexShape& b) {
    return a.m_count == b.m_count && a.m_radius == b.m_radius &&
           std::equal(a.m_vertices, a.m_vertices + a.m_count, b.m_vertices);
}

}  // namespace

void b2Bridge::SyncShapes(b2WorldData& data) {
    for (b2Fixture* fixture : data.exposedShapes) {
        const int32 count = std::min(fixture->m_childCount, fixture->m_shape->GetChildCount());
        for (int32 child = 0; child < count; ++child) {
            WithChild(*fixture->m_shape, child, [&]<typename S>(const S& shape) {
                scree::Fixture& handle = *fixture->m_handles[child];
                const scree::Shape& present = *std::as_const(handle).GetShape();
                if (present.GetType() != shape.GetType()) {
                    return Complain("b2Fixture::GetShape",
                                    "a polygon in use cannot go from 8 to more vertices or back: make a new fixture");
                }
                if (!Equal(shape, static_cast<const S&>(present))) handle.SetShape(shape);
            });
        }
    }
}

void b2Bridge::ApplyFilter(b2Fixture& fixture) {
    for (int32 i = 0; i < fixture.m_childCount; ++i) fixture.m_handles[i]->SetFilterData(ToScree(fixture.m_filter));
}

void b2Bridge::ForgetShape(b2WorldData& data, b2Fixture* fixture) {
    if (fixture->m_shapeExposed) std::erase(data.exposedShapes, fixture);
}

b2Shape::Type b2Fixture::GetType() const { return m_shape->GetType(); }

b2Shape* b2Fixture::GetShape() {
    if (!m_shapeExposed) {
        m_shapeExposed = true;
        b2Bridge::Data(*m_body).exposedShapes.push_back(this);
    }
    return m_shape;
}
const b2Shape* b2Fixture::GetShape() const { return m_shape; }

void b2Fixture::SetSensor(bool sensor) {
    for (int32 i = 0; i < m_childCount; ++i) m_handles[i]->SetSensor(sensor);
}
bool b2Fixture::IsSensor() const { return m_handles[0]->IsSensor(); }

void b2Fixture::SetFilterData(const b2Filter& filter) {
    b2WorldData& data = b2Bridge::Data(*m_body);
    m_filter = filter;
    if (data.stepping) return data.refilters.push_back(this);  // the engine hears of it after the step
    b2Bridge::ApplyFilter(*this);
    b2Bridge::Touch(b2Bridge::Data(*m_body));
}
const b2Filter& b2Fixture::GetFilterData() const { return m_filter; }
void b2Fixture::Refilter() {
    if (b2Bridge::Data(*m_body).stepping) return b2Bridge::Data(*m_body).refilters.push_back(this);
    for (int32 i = 0; i < m_childCount; ++i) m_handles[i]->Refilter();
    b2Bridge::Touch(b2Bridge::Data(*m_body));
}

b2Body* b2Fixture::GetBody() { return m_body; }
const b2Body* b2Fixture::GetBody() const { return m_body; }
b2Fixture* b2Fixture::GetNext() { return m_next; }
const b2Fixture* b2Fixture::GetNext() const { return m_next; }
b2FixtureUserData& b2Fixture::GetUserData() { return m_userData; }

bool b2Fixture::TestPoint(const b2Vec2& p) const { return m_shape->TestPoint(m_body->GetTransform(), p); }
bool b2Fixture::RayCast(b2RayCastOutput* output, const b2RayCastInput& input, int32 childIndex) const {
    return m_shape->RayCast(output, input, m_body->GetTransform(), childIndex);
}
void b2Fixture::GetMassData(b2MassData* massData) const { m_shape->ComputeMass(massData, m_density); }

void b2Fixture::SetDensity(float density) {
    for (int32 i = 0; i < m_childCount; ++i) {
        if (m_handles[i]->SetDensity(density) != scree::ErrorCode::ok) return;
    }
    m_density = density;
}
float b2Fixture::GetDensity() const { return m_density; }
float b2Fixture::GetFriction() const { return m_handles[0]->GetFriction(); }
void b2Fixture::SetFriction(float friction) {
    for (int32 i = 0; i < m_childCount; ++i) m_handles[i]->SetFriction(friction, true);
}
float b2Fixture::GetRestitution() const { return m_handles[0]->GetRestitution(); }
void b2Fixture::SetRestitution(float restitution) {
    for (int32 i = 0; i < m_childCount; ++i) m_handles[i]->SetRestitution(restitution, true);
}
float b2Fixture::GetRestitutionThreshold() const { return m_handles[0]->GetRestitutionThreshold(); }
void b2Fixture::SetRestitutionThreshold(float threshold) {
    for (int32 i = 0; i < m_childCount; ++i) m_handles[i]->SetRestitutionThreshold(threshold, true);
}

const b2AABB& b2Fixture::GetAABB(int32 childIndex) const {
    b2FixtureProxy& proxy = m_proxies[std::clamp(childIndex, 0, m_childCount - 1)];
    proxy.aabb = ToBox2d(m_handles[proxy.childIndex]->GetAABB());
    return proxy.aabb;
}

void b2Fixture::Dump(int32) { b2Dump("// scree writes no dump of fixtures\n"); }
