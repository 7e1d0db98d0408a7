// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Fixtures with equal shapes share one until somebody asks for his own: what one changes, no other sees.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scree/convex_shape.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

const Shape* Look(const Fixture* fixture) { return fixture->GetShape(); }

std::vector<Fixture*> AddBoxes(World& world, int count, float half) {
    std::vector<Fixture*> fixtures;
    for (int i = 0; i < count; ++i) {
        Body* body = AddBody(world, dynamicBody, {3.0f * static_cast<float>(i), 0.0f});
        AddBox(body, half, half);
        fixtures.push_back(body->GetFixtureList());
    }
    return fixtures;
}

TEST(SharedShapes, EqualOnesAreOneAndOthersAreNot) {
    World world({0.0f, 0.0f});
    const auto small = AddBoxes(world, 50, 0.5f);
    const auto large = AddBoxes(world, 50, 0.75f);
    std::set<const Shape*> shapes;
    for (const Fixture* f : small) shapes.insert(Look(f));
    EXPECT_EQ(shapes.size(), 1u);
    for (const Fixture* f : large) shapes.insert(Look(f));
    EXPECT_EQ(shapes.size(), 2u);
}

TEST(SharedShapes, ManyDifferentOnesKeepTheirForms) {
    World world({0.0f, 0.0f});
    std::vector<Fixture*> fixtures;
    for (int i = 0; i < 2000; ++i)
        fixtures.push_back(AddBoxes(world, 1, 0.1f + 0.001f * static_cast<float>(i % 700))[0]);
    for (size_t i = 0; i < fixtures.size(); ++i) {
        const auto& box = static_cast<const PolygonShape&>(*Look(fixtures[i]));
        ASSERT_EQ(box.m_vertices[2].x, 0.1f + 0.001f * static_cast<float>(i % 700)) << i;
    }
}

TEST(SharedShapes, AChangedOneIsItsFixturesOwn) {
    World world({0.0f, 0.0f});
    const auto fixtures = AddBoxes(world, 4, 0.5f);
    auto* own = static_cast<PolygonShape*>(fixtures[1]->GetShape());
    EXPECT_EQ(own, Look(fixtures[1])) << "from now on the same object";
    EXPECT_EQ(own, fixtures[1]->GetShape());
    EXPECT_NE(own, Look(fixtures[0]));
    own->SetAsBox(2.0f, 2.0f);
    for (const size_t i : {0u, 2u, 3u}) {
        EXPECT_EQ(static_cast<const PolygonShape&>(*Look(fixtures[i])).m_vertices[2].x, 0.5f);
    }
    // A fixture made later with the old or the new form never joins the one that may change.
    const auto later = AddBoxes(world, 1, 0.5f);
    EXPECT_EQ(Look(later[0]), Look(fixtures[0]));
    const auto alike = AddBoxes(world, 1, 2.0f);
    EXPECT_NE(Look(alike[0]), own);
    own->SetAsBox(0.5f, 0.5f);
    const auto last = AddBoxes(world, 1, 0.5f);
    EXPECT_NE(Look(last[0]), own);
}

/// The same polygon in other bits, which no pool has: each is refused, however often good ones were taken before.
TEST(SharedShapes, BadOnesAreRefusedAmongEqualGoodOnes) {
    std::vector<std::string> errors;
    World world({0.0f, 0.0f});
    world.SetErrorHandler(
        [](const Error& error, void* context) {
            static_cast<std::vector<std::string>*>(context)->emplace_back(error.field);
        },
        &errors);
    Fixture* const fixture = AddBoxes(world, 2, 0.5f)[0];
    Body* const body = AddBody(world, dynamicBody, {0.0f, 5.0f});
    PolygonShape good;
    good.SetAsBox(0.5f, 0.5f);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::pair<std::string, void (*)(PolygonShape&, float)>> faults{
        {"PolygonShape::m_vertices", [](PolygonShape& s, float bad) { s.m_vertices[1].y = bad; }},
        {"PolygonShape::m_vertices", [](PolygonShape& s, float bad) { s.m_normals[3].x = bad; }},
        {"PolygonShape::m_normals", [](PolygonShape& s, float) { s.m_normals[3] *= 2.0f; }},
        {"PolygonShape::m_vertices", [](PolygonShape& s, float) { std::swap(s.m_vertices[0], s.m_vertices[1]); }},
        {"Shape::m_radius", [](PolygonShape& s, float bad) { s.m_radius = bad; }},
        {"PolygonShape::m_count", [](PolygonShape& s, float) { s.m_count = 2; }},
        {"PolygonShape::m_count", [](PolygonShape& s, float) { s.m_count = -1; }},
        {"PolygonShape::m_count", [](PolygonShape& s, float) { s.m_count = 1 << 30; }},
    };
    for (const auto& [field, spoil] : faults) {
        PolygonShape bad = good;
        spoil(bad, nan);
        errors.clear();
        EXPECT_EQ(body->CreateFixture(&bad, 1.0f), nullptr);
        EXPECT_EQ(errors, std::vector{field});
        EXPECT_NE(body->CreateFixture(&good, 1.0f), nullptr);
        // Nor does a form join in that its user has spoilt.
        Fixture* const spoilt = AddBoxes(world, 1, 0.5f)[0];
        static_cast<PolygonShape&>(*spoilt->GetShape()) = bad;
        EXPECT_EQ(body->CreateFixture(&bad, 1.0f), nullptr);
        static_cast<PolygonShape&>(*spoilt->GetShape()) = good;
    }
    errors.clear();
    EXPECT_EQ(body->CreateFixture(&good, nan), nullptr);
    EXPECT_EQ(body->CreateFixture(&good, 1e35f), nullptr);
    EXPECT_EQ(errors, (std::vector<std::string>{"FixtureDef::density", "FixtureDef::density"}));
    EXPECT_EQ(Look(fixture), Look(body->GetFixtureList())) << "the good ones are all one";
}

/// Capsules, rounded polygons and ellipses at random.
std::vector<ConvexShape> MakeConvexes(std::mt19937& random) {
    std::uniform_real_distribution<float> size(0.2f, 1.0f);
    std::vector<ConvexShape> shapes;
    for (int i = 0; i < 5; ++i) {
        const float width = size(random), height = size(random), radius = size(random);
        const Vec2 corners[] = {{-width, -height}, {width, -height}, {width, height}, {-width, 0.5f * height}};
        shapes.push_back(MakeCapsule({-width, 0.0f}, {width, height}, radius));
        shapes.push_back(MakeRoundedPolygon(corners, 4, radius));
        shapes.push_back(MakePolygon(corners, 3));
        shapes.push_back(MakeEllipse(width, height, {radius, 0.0f}, radius));
    }
    return shapes;
}

Fixture* AddConvex(World& world, const ConvexShape& shape) {
    return AddBody(world, dynamicBody, {0.0f, 0.0f})->CreateFixture(&shape, 1.0f);
}

TEST(SharedShapes, FurtherConvexOnesAreSharedToo) {
    std::mt19937 random(7);
    World world({0.0f, 0.0f});
    const std::vector<ConvexShape> shapes = MakeConvexes(random);
    for (const ConvexShape& shape : shapes) {
        const Shape* const first = Look(AddConvex(world, shape));
        for (int i = 0; i < 3; ++i) EXPECT_EQ(Look(AddConvex(world, ConvexShape(shape))), first);
        Fixture* const other = AddConvex(world, shape);
        EXPECT_NE(other->GetShape(), first) << "it may change";
        static_cast<ConvexShape*>(other->GetShape())->m_radius *= 1.5f;
        EXPECT_EQ(first->m_radius, shape.m_radius);
        EXPECT_EQ(Look(AddConvex(world, shape)), first);
    }
    std::set<const Shape*> all;
    for (const ConvexShape& shape : shapes) all.insert(Look(AddConvex(world, shape)));
    EXPECT_EQ(all.size(), shapes.size());
}

TEST(SharedShapes, FurtherConvexOnesThatDifferInOneMemberAreNot) {
    std::mt19937 random(8);
    World world({0.0f, 0.0f});
    const auto more = [](float& value) { value += 1e-5f; };
    const std::vector<std::pair<const char*, std::function<void(ConvexShape&)>>> changes{
        {"vertex", [&](ConvexShape& s) { more(s.m_vertices[s.m_count - 1].y); }},
        {"normal", [&](ConvexShape& s) { more(s.m_normals[s.m_count - 1].x); }},
        {"control", [&](ConvexShape& s) { more(s.m_controls[0].x); }},
        {"radius", [&](ConvexShape& s) { more(s.m_radius); }},
        {"solid radius", [&](ConvexShape& s) { s.m_solidRadius *= 0.5f; }},
        {"error", [&](ConvexShape& s) { more(s.m_error); }},
        {"mass", [&](ConvexShape& s) { more(s.m_unitMass.mass); }},
        {"centre", [&](ConvexShape& s) { more(s.m_unitMass.center.y); }},
        {"inertia", [&](ConvexShape& s) { more(s.m_unitMass.I); }},
        {"curved sides", [&](ConvexShape& s) { s.m_curvedSides ^= 1u; }},
        {"count", [&](ConvexShape& s) { s.m_count -= 1; }},
        {"too many", [&](ConvexShape& s) { s.m_count = maxConvexVertices + 1; }},
        {"bad field", [&](ConvexShape& s) { s.m_badField = "radius"; }},
    };
    std::vector<int> taken(changes.size());
    for (const ConvexShape& shape : MakeConvexes(random)) {
        const Shape* const first = Look(AddConvex(world, shape));
        for (size_t i = 0; i < changes.size(); ++i) {
            ConvexShape other = shape;
            changes[i].second(other);
            if (std::memcmp(&other, &shape, sizeof other) == 0) continue;
            const Fixture* const fixture = AddConvex(world, other);
            if (fixture == nullptr) continue;  // refused: it is none
            ++taken[i];
            EXPECT_NE(Look(fixture), first) << changes[i].first;
        }
    }
    for (const size_t i : {1u, 4u, 5u, 6u, 7u, 8u}) EXPECT_GT(taken[i], 0) << changes[i].first << ": always refused";
    EXPECT_EQ(taken[11] + taken[12], 0);
}

TEST(SharedShapes, TheOnlyUserTakesItsOwnInPlace) {
    World world({0.0f, 0.0f});
    const auto first = AddBoxes(world, 1, 0.5f);
    const Shape* before = Look(first[0]);
    EXPECT_EQ(first[0]->GetShape(), before);
    const auto second = AddBoxes(world, 1, 0.5f);
    EXPECT_NE(Look(second[0]), before) << "it may change at any time";
}

TEST(SharedShapes, FreedOnesAreUsedAgainAndNotFound) {
    World world({0.0f, 0.0f});
    const auto boxes = AddBoxes(world, 3, 0.5f);
    const Shape* shared = Look(boxes[0]);
    for (Fixture* f : boxes) world.DestroyBody(f->GetBody());
    const auto other = AddBoxes(world, 1, 0.75f);
    EXPECT_EQ(Look(other[0]), shared) << "the freed place";
    EXPECT_EQ(static_cast<const PolygonShape&>(*shared).m_vertices[2].x, 0.75f);
    const auto again = AddBoxes(world, 1, 0.5f);
    EXPECT_EQ(static_cast<const PolygonShape&>(*Look(again[0])).m_vertices[2].x, 0.5f);
}

TEST(SharedShapes, ARestoredWorldGoesOnAlike) {
    World world({0.0f, -10.0f});
    AddGround(world);
    const auto fixtures = AddBoxes(world, 20, 0.5f);
    for (Fixture* f : fixtures) f->GetBody()->SetTransform({f->GetBody()->GetPosition().x, 1.0f}, 0.0f);
    static_cast<PolygonShape*>(fixtures[5]->GetShape())->SetAsBox(0.25f, 0.75f);
    StepFor(world, 10);
    const std::unique_ptr<World> restored = LoadWorld(SaveWorld(world));
    ASSERT_NE(restored, nullptr);
    StepFor(world, 90);
    StepFor(*restored, 90);
    EXPECT_EQ(inspect::GetStateHash(world), inspect::GetStateHash(*restored));
    EXPECT_NEAR(fixtures[5]->GetBody()->GetPosition().y, 0.75f, 0.05f) << "it rests on its new form";
}

}  // namespace
}  // namespace scree::test
