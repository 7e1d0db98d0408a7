// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// World queries find exactly what asking every fixture finds, whatever the broad phase, also with edits in between; ray
// casts report what Box2D 2.4.1 reports.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "scree/distance.h"
#include "tests/world/engines.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

constexpr int kinds = static_cast<int>(broadPhaseNames.size());

/// Fixtures of all kinds at random places.
struct Clutter {
    explicit Clutter(BroadPhaseKind kind, unsigned seed, int count) : world(MakeDef(kind)), random(seed) {
        for (int i = 0; i < count; ++i) Add();
    }
    static WorldDef MakeDef(BroadPhaseKind kind) {
        WorldDef def;
        def.broadPhase = kind;
        return def;
    }
    float Pick(float low, float high) { return low + (high - low) * static_cast<float>(random() % 10007u) / 10006.0f; }
    void Add() {
        BodyDef def;
        def.type = static_cast<BodyType>(random() % 3);
        def.position = {Pick(-10, 10), Pick(-10, 10)};
        def.angle = Pick(-3, 3);
        Body* body = world.CreateBody(&def);
        FixtureDef fixture;
        CircleShape circle;
        circle.m_radius = Pick(0.2f, 1.0f);
        PolygonShape box;
        box.SetAsBox(Pick(0.2f, 1.5f), Pick(0.2f, 1.0f), {0.3f, 0.1f}, 0.4f);
        EdgeShape edge;
        edge.SetTwoSided({-1, 0}, {1, 0.5f});
        const Shape* shapes[3] = {&circle, &box, &edge};
        fixture.shape = shapes[random() % 3];
        fixture.isSensor = random() % 5 == 0;
        fixture.filter.categoryBits = static_cast<uint16_t>(1u << (random() % 3));
        body->CreateFixture(&fixture);
        bodies.push_back(body);
    }
    void RemoveOne() {
        if (bodies.empty()) return;
        const size_t i = random() % bodies.size();
        world.DestroyBody(bodies[i]);
        bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(i));
    }
    void MoveOne() {
        if (!bodies.empty())
            bodies[random() % bodies.size()]->SetTransform({Pick(-10, 10), Pick(-10, 10)}, Pick(-3, 3));
    }
    bool Sees(const QueryFilter& filter, const Fixture* f) const {
        return (filter.includeSensors || !f->IsSensor()) && (filter.maskBits & f->GetFilterData().categoryBits) != 0;
    }
    template <class Visit>
    void ForEachFixture(const QueryFilter& filter, Visit visit) {
        for (Body* b : bodies) {
            for (Fixture* f = b->GetFixtureList(); f; f = f->GetNext()) {
                if (Sees(filter, f)) visit(f);
            }
        }
    }

    World world;
    std::minstd_rand random;
    std::vector<Body*> bodies;
};

void CheckRays(Clutter& c, const QueryFilter& filter) {
    const Vec2 p1{c.Pick(-12, 12), c.Pick(-12, 12)}, p2{c.Pick(-12, 12), c.Pick(-12, 12)};
    std::vector<RayHit> expected;
    c.ForEachFixture(filter, [&](Fixture* f) {
        RayCastOutput out;
        if (f->RayCast(&out, {p1, p2, 1.0f})) expected.push_back({f, p1, out.normal, out.fraction});
    });
    std::sort(expected.begin(), expected.end(),
              [](const RayHit& a, const RayHit& b) { return a.fraction < b.fraction; });
    std::vector<RayHit> hits;
    RC_ASSERT(c.world.RayCastAll(p1, p2, hits, filter) == ErrorCode::ok);
    RC_ASSERT(hits.size() == expected.size());
    for (size_t i = 0; i < hits.size(); ++i) {
        RC_ASSERT(hits[i].fraction == expected[i].fraction);
        RC_ASSERT(Distance(hits[i].point, p1 + hits[i].fraction * (p2 - p1)) < 1e-4f);
    }
    const auto closest = c.world.RayCastClosest(p1, p2, filter);
    RC_ASSERT(closest.has_value() == !hits.empty());
    // Clipped rays are cast anew against each shape: the fraction may differ by rounding only.
    if (closest) RC_ASSERT(std::abs(closest->fraction - hits[0].fraction) < 1e-6f);
    if (closest && (hits.size() == 1 || hits[1].fraction > hits[0].fraction + 1e-5f))
        RC_ASSERT(closest->fixture == hits[0].fixture);
}

void CheckPointsAndShapes(Clutter& c, const QueryFilter& filter) {
    const Vec2 point{c.Pick(-11, 11), c.Pick(-11, 11)};
    std::set<Fixture*> expected, found;
    const auto collect = [&](Fixture* f) { return found.insert(f).second; };
    c.ForEachFixture(filter, [&](Fixture* f) {
        if (f->TestPoint(point)) expected.insert(f);
    });
    c.world.QueryPoint(point, collect, filter);
    RC_ASSERT(found == expected);

    PolygonShape probe;
    probe.SetAsBox(c.Pick(0.1f, 2.0f), c.Pick(0.1f, 2.0f));
    Transform xf;
    xf.Set(point, c.Pick(-3, 3));
    expected.clear();
    found.clear();
    c.ForEachFixture(filter, [&](Fixture* f) {
        if (scree::TestOverlap(f->GetShape(), 0, &probe, 0, f->GetBody()->GetTransform(), xf)) expected.insert(f);
    });
    c.world.OverlapShape(probe, xf, collect, filter);
    RC_ASSERT(found == expected);
}

void CheckShapeCasts(Clutter& c, const QueryFilter& filter) {
    CircleShape probe;
    probe.m_radius = c.Pick(0.05f, 1.0f);
    Transform xf;
    xf.Set({c.Pick(-11, 11), c.Pick(-11, 11)}, 0.0f);
    const Vec2 way{c.Pick(-8, 8), c.Pick(-8, 8)};
    std::vector<ShapeHit> hits;
    RC_ASSERT(c.world.ShapeCast(probe, xf, way, hits, filter) == ErrorCode::ok);
    std::set<Fixture*> met;
    for (const ShapeHit& hit : hits) met.insert(hit.fixture);
    RC_ASSERT(met.size() == hits.size());
    RC_ASSERT(std::is_sorted(hits.begin(), hits.end(),
                             [](const ShapeHit& a, const ShapeHit& b) { return a.fraction < b.fraction; }));
    const auto closest = c.world.ShapeCastClosest(probe, xf, way, filter);
    RC_ASSERT(closest.has_value() == !hits.empty());
    if (closest) {
        RC_ASSERT(closest->fixture == hits[0].fixture);
        RC_ASSERT(closest->fraction == hits[0].fraction);
        RC_ASSERT(closest->point == hits[0].point);
    }
    // Against many placements along the way: what is missed is never overlapped, and what is hit is not touched before.
    c.ForEachFixture(filter, [&](Fixture* f) {
        float fraction = 2.0f;
        for (const ShapeHit& hit : hits) {
            if (hit.fixture == f) fraction = hit.fraction;
        }
        for (int k = 0; k <= 40; ++k) {
            const float t = static_cast<float>(k) / 40.0f;
            if (t > fraction) break;
            // Shapes count as touching a few slops early or late; shrink the probe by that.
            CircleShape thin = probe;
            thin.m_radius = std::max(0.01f, probe.m_radius - 4.0f * linearSlop);
            Transform at = xf;
            at.p += t * way;
            if (fraction > 0.0f)
                RC_ASSERT(!scree::TestOverlap(f->GetShape(), 0, &thin, 0, f->GetBody()->GetTransform(), at));
        }
    });
}

TEST(Queries, FindWhatAskingEveryFixtureFindsInEveryBroadPhase) {
    EXPECT_TRUE(rc::check("queries equal brute force, with edits in between", [] {
        const auto kind = static_cast<BroadPhaseKind>(*rc::gen::inRange(0, kinds));
        Clutter c(kind, *rc::gen::inRange(1u, 1000000u), *rc::gen::inRange(0, 60));
        for (int round = 0; round < 4; ++round) {
            QueryFilter filter;
            filter.maskBits = static_cast<uint16_t>(*rc::gen::inRange(1, 8));
            filter.includeSensors = *rc::gen::arbitrary<bool>();
            CheckRays(c, filter);
            CheckPointsAndShapes(c, filter);
            CheckShapeCasts(c, filter);
            c.Add();
            c.RemoveOne();
            c.MoveOne();
            if (round == 2) StepFor(c.world, 2);
        }
    }));
}

/// A ray whose first point lies on a fixture hits that one at fraction 0, whatever lies beyond it and in whichever
/// order the fixtures were made.
TEST(Queries, ARayThatStartsOnASurfaceHitsItFirst) {
    EXPECT_TRUE(rc::check("the surface under the start is the closest hit", [] {
        World world(Vec2{0.0f, 0.0f});
        const float width = static_cast<float>(*rc::gen::inRange(1, 9));
        const float depth = static_cast<float>(*rc::gen::inRange(2, 9));
        const int others = *rc::gen::inRange(1, 6);
        const int before = *rc::gen::inRange(0, others + 1);
        Fixture* surface = nullptr;
        for (int i = 0; i <= others; ++i) {
            BodyDef def;
            if (i == before) {
                EdgeShape edge;
                edge.SetTwoSided({-width, 0.0f}, {width, 0.0f});
                surface = world.CreateBody(&def)->CreateFixture(&edge, 0.0f);
            } else {
                def.position = {0.0f, -depth - static_cast<float>(3 * i)};
                PolygonShape box;
                box.SetAsBox(0.5f * width, 1.0f);
                world.CreateBody(&def)->CreateFixture(&box, 0.0f);
            }
        }
        if (*rc::gen::arbitrary<bool>()) StepFor(world, 1);
        const Vec2 from{0.25f * width, 0.0f}, to{0.25f * width, -60.0f};
        const auto hit = world.RayCastClosest(from, to);
        RC_ASSERT(hit.has_value());
        RC_ASSERT(hit->fixture == surface);
        RC_ASSERT(hit->fraction == 0.0f);
        std::vector<RayHit> hits;
        world.RayCastAll(from, to, hits);
        RC_ASSERT(hits.front().fixture == surface);
        for (const RayHit& each : hits) RC_ASSERT(!std::signbit(each.fraction));
    }));
}

TEST(Queries, EveryBroadPhaseVisitsTheSameFixtures) {
    for (int kind = 0; kind < kinds; ++kind) {
        Clutter c(static_cast<BroadPhaseKind>(kind), 7, 80);
        std::set<int> found;
        c.world.QueryAABB({{-3, -3}, {4, 4}}, [&](Fixture* f) { return found.insert(f->GetIndex()).second; });
        std::set<int> expected;
        c.ForEachFixture({}, [&](Fixture* f) {
            if (TestOverlap(f->GetAABB(), {{-3, -3}, {4, 4}})) expected.insert(f->GetIndex());
        });
        EXPECT_EQ(found, expected) << broadPhaseNames[static_cast<size_t>(kind)];
        int visits = 0;
        c.world.QueryAABB({{-10, -10}, {10, 10}}, [&](Fixture*) { return ++visits < 5; });
        EXPECT_EQ(visits, 5);
    }
}

/// One line per fixture on a ray: name, fraction and normal to four digits, in the order of distance.
template <class E>
class RayLog : public E::RayCastCallback {
public:
    explicit RayLog(float answer) : m_answer(answer) {}
    float ReportFixture(typename E::Fixture* fixture, const typename E::Vec& point, const typename E::Vec& normal,
                        float fraction) override {
        char line[96];
        std::snprintf(line, sizeof line, "%.4f %d (%.3f %.3f) (%.3f %.3f)", static_cast<double>(fraction),
                      static_cast<int>(fixture->GetUserData().pointer), static_cast<double>(point.x + 0.0f),
                      static_cast<double>(point.y + 0.0f), static_cast<double>(normal.x + 0.0f),
                      static_cast<double>(normal.y + 0.0f));
        log.push_back(line);
        return m_answer < 0.0f ? fraction : m_answer;
    }
    Log log;

private:
    float m_answer;
};

template <class E>
Log CastRays(bool closest) {
    typename E::World world({0, 0});
    std::minstd_rand random(3);
    const auto pick = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() % 1009u) / 1008.0f;
    };
    for (uintptr_t i = 0; i < 60; ++i) {
        const float x = pick(-10, 10), y = pick(-10, 10), angle = pick(-3, 3);
        typename E::Body* body = MakeBody<E>(world, i % 2 ? E::isStatic : E::isDynamic, x, y, i);
        body->SetTransform({x, y}, angle);
        if (i % 3 == 0) Attach<E>(body, CircleOf<E>(0.6f));
        if (i % 3 == 1) Attach<E>(body, BoxShape<E>(0.8f, 0.3f));
        if (i % 3 == 2) Attach<E>(body, EdgeOf<E>({-1, 0}, {1, 0.2f}), 0);
    }
    Log all;
    for (int k = 0; k < 200; ++k) {
        const float x1 = pick(-12, 12), y1 = pick(-12, 12), x2 = pick(-12, 12), y2 = pick(-12, 12);
        RayLog<E> callback(closest ? -1.0f : 1.0f);
        world.RayCast(&callback, {x1, y1}, {x2, y2});
        all.push_back("ray " + std::to_string(k));
        if (closest) {
            if (!callback.log.empty()) all.push_back(callback.log.back());
        } else {
            std::sort(callback.log.begin(), callback.log.end());
            all.insert(all.end(), callback.log.begin(), callback.log.end());
        }
    }
    return all;
}

TEST(Queries, RayCastsReportWhatBox2DReports) {
    const Log all = CastRays<Ours>(false);
    EXPECT_GT(all.size(), 400u);
    EXPECT_EQ(all, CastRays<Theirs>(false));
    EXPECT_EQ(CastRays<Ours>(true), CastRays<Theirs>(true));
}

TEST(Queries, CallbackClassesCanStopAndIgnore) {
    World world({0, 0});
    for (int i = 0; i < 5; ++i) AddCircle(AddBody(world, staticBody, {2.0f * static_cast<float>(i), 0}), 0.5f);
    struct Stop : QueryCallback {
        int count = 0;
        bool ReportFixture(Fixture*) override { return ++count < 2; }
    } stop;
    EXPECT_EQ(world.QueryAABB(&stop, {{-10, -10}, {20, 10}}), ErrorCode::ok);
    EXPECT_EQ(stop.count, 2);
    struct Ignore : RayCastCallback {
        int count = 0;
        float ReportFixture(Fixture*, const Vec2&, const Vec2&, float) override { return ++count, -1.0f; }
    } ignore;
    EXPECT_EQ(world.RayCast(&ignore, {-5, 0}, {20, 0}), ErrorCode::ok);
    EXPECT_EQ(ignore.count, 5);
}

/// A disk that passes a box within what counts as a touch: the world says what ShapeCast says of the two alone.
TEST(Queries, AShapeCastThatGrazesHitsAsOfTwoShapes) {
    int hits = 0, misses = 0;
    for (int i = 0; i < 400; ++i) {
        World world(Vec2{0.0f, 0.0f});
        AddBox(AddBody(world, staticBody, {0.0f, -1.0f}), 1.0f, 1.0f);
        const Fixture& fixture = *world.GetBodyList()->GetFixtureList();
        CircleShape disk;
        disk.m_radius = i % 2 == 0 ? 1e-6f : 0.3f;
        // From overlap to clear of it.
        const float gap = 2e-4f * static_cast<float>(i / 2) - 0.01f;
        const Transform from({-3.0f, disk.m_radius + gap}, Rot(0.0f));
        const Vec2 way{6.0f, 0.0f};
        ShapeCastInput input;
        input.proxyA.Set(fixture.GetShape(), 0), input.proxyB.Set(&disk, 0);
        input.transformA = fixture.GetBody()->GetTransform(), input.transformB = from;
        input.translationB = way;
        ShapeCastOutput alone;
        const bool isHit = ShapeCast(&alone, &input);
        const auto closest = world.ShapeCastClosest(disk, from, way);
        ASSERT_EQ(closest.has_value(), isHit) << "radius " << disk.m_radius << ", gap " << gap;
        if (isHit) {
            EXPECT_EQ(closest->fraction, alone.lambda);
        }
        isHit ? ++hits : ++misses;
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(misses, 50);
}

TEST(Queries, AShapeCastThatStartsInsideHitsAtZero) {
    World world({0, 0});
    Fixture* wall = AddBox(AddBody(world, staticBody, {0, 0}), 1, 1);
    CircleShape probe;
    probe.m_radius = 0.5f;
    Transform xf;
    xf.Set({0.5f, 0}, 0);
    const auto hit = world.ShapeCastClosest(probe, xf, {5, 0});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->fixture, wall);
    EXPECT_EQ(hit->fraction, 0.0f);
    EXPECT_EQ(hit->normal, vec2Zero);
    xf.Set({-4, 0}, 0);
    const auto far = world.ShapeCastClosest(probe, xf, {10, 0});
    ASSERT_TRUE(far.has_value());
    EXPECT_NEAR(far->fraction, 0.25f, 0.003f);  // 2.5 m of 10; touch is within 2 slops and skins of 1 cm
    EXPECT_NEAR(far->normal.x, -1.0f, 1e-3f);
}

}  // namespace
}  // namespace scree::test
