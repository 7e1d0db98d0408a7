// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box and ray queries of a world. The engine's hits are collected first and reported then: the program's callbacks run
// outside of the engine's query, so they may change the world as in Box2D.

#include <algorithm>
#include <vector>

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

namespace {

/// While it lives, fixtures that callbacks destroy turn into nulls in the list.
class Report {
public:
    Report(b2WorldData& data, std::vector<b2Fixture*>& fixtures) : m_data(data), m_fixtures(fixtures) {
        const std::lock_guard lock(m_data.reportsMutex);
        data.reports.push_back(&fixtures);
    }
    ~Report() {
        const std::lock_guard lock(m_data.reportsMutex);
        std::erase(m_data.reports, &m_fixtures);
    }
    Report(const Report&) = delete;
    Report& operator=(const Report&) = delete;

private:
    b2WorldData& m_data;
    std::vector<b2Fixture*>& m_fixtures;
};

}  // namespace

void b2World::QueryAABB(b2QueryCallback* callback, const b2AABB& aabb) const {
    if (callback == nullptr) return Complain("b2World::QueryAABB", "give a callback");
    b2Bridge::SyncShapes(*m_data);
    std::vector<b2Fixture*> found;
    m_data->engine.QueryAABB(ToScree(aabb), [&](scree::Fixture* fixture) {
        found.push_back(b2Bridge::ProxyOf(fixture).fixture);
        return true;
    });
    const Report report(*m_data, found);
    for (size_t i = 0; i < found.size(); ++i) {
        if (found[i] != nullptr && !callback->ReportFixture(found[i])) return;
    }
}

namespace {

struct Hit {
    b2Fixture* fixture;
    b2Vec2 point, normal;
    float fraction;
};

/// The engine's chain edges let a ray through from behind. Box2D's do not when they are a chain, so chains are asked
/// here.
void CastAtChains(b2WorldData& data, const b2RayCastInput& ray, std::vector<Hit>& hits) {
    b2AABB box;
    box.lowerBound = b2Min(ray.p1, ray.p2);
    box.upperBound = b2Max(ray.p1, ray.p2);
    data.engine.QueryAABB(ToScree(box), [&](scree::Fixture* candidate) {
        const b2FixtureProxy& proxy = b2Bridge::ProxyOf(candidate);
        b2RayCastOutput out;
        if (proxy.fixture->GetType() == b2Shape::e_chain && proxy.fixture->RayCast(&out, ray, proxy.childIndex)) {
            const b2Vec2 point = (1.0f - out.fraction) * ray.p1 + out.fraction * ray.p2;
            hits.push_back({proxy.fixture, point, out.normal, out.fraction});
        }
        return true;
    });
}

}  // namespace

void b2World::RayCast(b2RayCastCallback* callback, const b2Vec2& point1, const b2Vec2& point2) const {
    if (callback == nullptr) return Complain("b2World::RayCast", "give a callback");
    b2Bridge::SyncShapes(*m_data);
    std::vector<Hit> hits;
    const auto collect = [&](scree::Fixture* fixture, scree::Vec2 point, scree::Vec2 normal, float fraction) {
        const b2FixtureProxy& proxy = b2Bridge::ProxyOf(fixture);
        if (proxy.fixture->GetType() != b2Shape::e_chain) {
            hits.push_back({proxy.fixture, ToBox2d(point), ToBox2d(normal), fraction});
        }
        return 1.0f;
    };
    if (m_data->engine.RayCast(ToScree(point1), ToScree(point2), collect) != scree::ErrorCode::ok) return;
    if (m_data->chainCount > 0) {
        b2RayCastInput ray;
        ray.p1 = point1;
        ray.p2 = point2;
        ray.maxFraction = 1.0f;
        CastAtChains(*m_data, ray, hits);
    }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.fraction < b.fraction; });
    float maxFraction = 1.0f;
    std::vector<b2Fixture*> fixtures;
    for (const Hit& hit : hits) fixtures.push_back(hit.fixture);
    const Report report(*m_data, fixtures);
    for (size_t i = 0; i < hits.size(); ++i) {
        const Hit& hit = hits[i];
        if (hit.fraction > maxFraction) return;  // the nearest come first
        if (fixtures[i] == nullptr) continue;
        const float value = callback->ReportFixture(fixtures[i], hit.point, hit.normal, hit.fraction);
        if (value == 0.0f) return;
        if (value > 0.0f) maxFraction = value;
    }
}
