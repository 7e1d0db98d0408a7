// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Events as arrays are what a listener hears, in its order; they come only from fixtures that report, and change
// nothing.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "scree/snapshot.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

FixtureDef Define(const Shape& shape, uint8_t reports) {
    FixtureDef def;
    def.shape = &shape;
    def.density = 1.0f;
    def.reports = reports;
    return def;
}

/// Boxes and disks that fall through a sensor into a bin. Every `stride`-th reports.
struct Bin {
    Bin(int stride, int workers) : world(With(workers)) {
        world.GetState().pool->ShareAlways();
        AddGround(world);
        for (const float x : {-4.5f, 4.5f}) AddBox(AddBody(world, staticBody, {x, 10.0f}), 0.5f, 10.0f);
        PolygonShape across;
        across.SetAsBox(4.0f, 0.5f, {0.0f, 4.0f}, 0.0f);
        FixtureDef sensor = Define(across, 0);
        sensor.isSensor = true;
        AddBody(world, staticBody, {0.0f, 0.0f})->CreateFixture(&sensor);
        std::mt19937 random(5);
        PolygonShape box;
        box.SetAsBox(0.4f, 0.3f);
        CircleShape disk;
        disk.m_radius = 0.4f;
        for (int i = 0; i < 60; ++i) {
            const float jitter = static_cast<float>(random() % 100) * 0.002f;
            const Vec2 place{static_cast<float>(i % 8) - 3.5f + jitter, 6.0f + 1.1f * static_cast<float>(i / 8)};
            Body* body = AddBody(world, dynamicBody, place);
            const uint8_t reports = stride > 0 && i % stride == 0 ? Report::all : uint8_t{0};
            const FixtureDef def = random() % 2 == 0 ? Define(box, reports) : Define(disk, reports);
            bodies.push_back(body);
            body->CreateFixture(&def);
        }
    }
    static WorldDef With(int workers) {
        WorldDef def;
        def.workerCount = workers;
        return def;
    }
    void Step(int substeps) { StepWith(world, substeps); }

    World world;
    std::vector<Body*> bodies;
};

/// What events should tell.
struct Hearer : ContactListener {
    void BeginContact(Contact* c) override { Note(c, begun, entered); }
    void EndContact(Contact* c) override { Note(c, ended, left); }
    static void Note(Contact* c, Pairs& contacts, Pairs& sensors) {
        const Fixture *a = c->GetFixtureA(), *b = c->GetFixtureB();
        if (((a->GetReports() | b->GetReports()) & Report::contacts) == 0) return;
        if (!a->IsSensor() && !b->IsSensor()) {
            contacts.push_back({a->GetIndex(), b->GetIndex()});
        } else {
            sensors.push_back(a->IsSensor() ? std::pair(a->GetIndex(), b->GetIndex())
                                            : std::pair(b->GetIndex(), a->GetIndex()));
        }
    }
    void Clear() { begun.clear(), ended.clear(), entered.clear(), left.clear(); }

    Pairs begun, ended, entered, left;
};

Pairs PairsOf(std::span<const ContactEvent> events) {
    Pairs pairs;
    for (const ContactEvent& event : events) pairs.push_back({event.fixtureA.index, event.fixtureB.index});
    return pairs;
}
Pairs PairsOf(std::span<const SensorEvent> events) {
    Pairs pairs;
    for (const SensorEvent& event : events) pairs.push_back({event.sensor.index, event.visitor.index});
    return pairs;
}

TEST(Events, AreWhatAListenerHears) {
    for (const int substeps : {0, 4}) {
        for (const int stride : {1, 5}) {
            Bin heard(stride, 1), alone(stride, 3), silent(0, 1);
            Hearer hearer;
            heard.world.SetContactListener(&hearer);
            size_t counts[4] = {};
            for (int step = 0; step < 200; ++step) {
                for (Bin* bin : {&heard, &alone, &silent}) {
                    // Ends outside of steps are told with the next one.
                    if (step % 40 == 39) bin->world.DestroyBody(bin->bodies[static_cast<size_t>(step / 40)]);
                    bin->Step(substeps);
                }
                ASSERT_EQ(inspect::GetStateHash(heard.world), inspect::GetStateHash(silent.world));
                ASSERT_EQ(inspect::GetStateHash(alone.world), inspect::GetStateHash(silent.world));
                for (const Bin* bin : {&heard, &alone}) {
                    const Events events = bin->world.GetEvents();
                    ASSERT_EQ(PairsOf(events.contactsBegun), hearer.begun) << "step " << step;
                    ASSERT_EQ(PairsOf(events.contactsEnded), hearer.ended) << "step " << step;
                    ASSERT_EQ(PairsOf(events.sensorsEntered), hearer.entered) << "step " << step;
                    ASSERT_EQ(PairsOf(events.sensorsLeft), hearer.left) << "step " << step;
                    ASSERT_TRUE(events.moved.empty());
                }
                const Events none = silent.world.GetEvents();
                ASSERT_TRUE(none.contactsBegun.empty() && none.contactsEnded.empty() && none.hits.empty());
                ASSERT_TRUE(none.sensorsEntered.empty() && none.sensorsLeft.empty());
                const size_t found[] = {hearer.begun.size(), hearer.ended.size(), hearer.entered.size(),
                                        hearer.left.size()};
                for (size_t i = 0; i < 4; ++i) counts[i] += found[i];
                hearer.Clear();
            }
            for (const size_t count : counts) EXPECT_GT(count, 0u);
        }
    }
}

/// A ball that falls onto the ground hits it once, with the speed of its fall.
TEST(Events, AHitTellsWhereAndHowFast) {
    for (const int substeps : {0, 4}) {
        for (const float height : {0.02f, 2.0f, 9.0f}) {
            World world({0.0f, -10.0f});
            AddGround(world);
            CircleShape ball;
            ball.m_radius = 0.5f;
            const FixtureDef def = Define(ball, Report::hits);
            Fixture* fixture = AddBody(world, dynamicBody, {3.0f, 0.5f + height})->CreateFixture(&def);
            std::vector<HitEvent> hits;
            for (int step = 0; step < 180; ++step) {
                StepWith(world, substeps);
                const Events events = world.GetEvents();
                hits.insert(hits.end(), events.hits.begin(), events.hits.end());
                EXPECT_TRUE(events.contactsBegun.empty()) << "only hits are reported";
            }
            const float speed = std::sqrt(20.0f * height);
            if (speed < world.GetHitSpeed()) {
                EXPECT_TRUE(hits.empty());
                continue;
            }
            ASSERT_EQ(hits.size(), 1u) << height;
            // Within what gravity adds in one step.
            EXPECT_NEAR(hits[0].speed, speed, 10.0f * frame);
            EXPECT_NEAR(hits[0].point.x, 3.0f, 1e-3f);
            EXPECT_NEAR(hits[0].point.y, 0.0f, speed * frame);
            EXPECT_NEAR(std::abs(hits[0].normal.y), 1.0f, 1e-5f);
            const bool isA = world.Find(hits[0].fixtureA) == fixture;
            EXPECT_TRUE(isA || world.Find(hits[0].fixtureB) == fixture);
            EXPECT_EQ(hits[0].normal.y < 0.0f, isA) << "from A to B";
        }
    }
}

TEST(Events, MovesTellWhoWasSimulatedAndFellAsleep) {
    for (const int substeps : {0, 4}) {
        World world({0.0f, -10.0f});
        AddGround(world);
        for (int i = 0; i < 5; ++i)
            AddBox(AddBody(world, dynamicBody, {2.0f * static_cast<float>(i), 0.52f}), 0.5f, 0.5f);
        world.SetReportMoves(true);
        int asleep = 0;
        for (int step = 0; step < 300; ++step) {
            const StepReport report = StepWith(world, substeps);
            const std::span<const MoveEvent> moved = world.GetEvents().moved;
            EXPECT_EQ(static_cast<int>(moved.size()), report.awakeBodyCount) << "step " << step;
            for (const MoveEvent& event : moved) {
                const Body* body = world.Find(event.body);
                ASSERT_NE(body, nullptr);
                EXPECT_EQ(body->IsAwake(), !event.fellAsleep);
                asleep += event.fellAsleep ? 1 : 0;
            }
        }
        EXPECT_EQ(asleep, 5);
        EXPECT_TRUE(world.GetEvents().moved.empty());
    }
}

/// The body is the only one whose fixtures report.
TEST(Events, EndsOfEditsAreTold) {
    struct Edit {
        const char* name;
        void (*edit)(World& world, Body* body);
    };
    const Edit edits[] = {
        {"SetType, static", [](World&, Body* body) { body->SetType(staticBody); }},
        {"SetType, kinematic", [](World&, Body* body) { body->SetType(kinematicBody); }},
        {"SetEnabled", [](World&, Body* body) { body->SetEnabled(false); }},
        {"SetTransform",
         [](World&, Body* body) {
             body->SetTransform({0.0f, 50.0f}, 0.0f);
         }},
        {"DestroyFixture", [](World&, Body* body) { body->DestroyFixture(body->GetFixtureList()); }},
        {"DestroyBody", [](World& world, Body* body) { world.DestroyBody(body); }},
        {"SetFilterData",
         [](World&, Body* body) {
             body->GetFixtureList()->SetFilterData({1, 0, 0});
         }},
    };
    for (const int substeps : {0, 4}) {
        for (const Edit& edit : edits) {
            World world({0.0f, -10.0f});
            AddGround(world);
            Body* body = AddBody(world, dynamicBody, {0.0f, 0.5f});
            PolygonShape box;
            box.SetAsBox(0.5f, 0.5f);
            const FixtureDef def = Define(box, Report::all);
            const FixtureId id = world.GetId(body->CreateFixture(&def));
            StepWith(world, substeps);
            ASSERT_EQ(world.GetEvents().contactsBegun.size(), 1u);
            edit.edit(world, body);
            StepWith(world, substeps);
            const std::span<const ContactEvent> ended = world.GetEvents().contactsEnded;
            ASSERT_EQ(ended.size(), 1u) << edit.name;
            EXPECT_TRUE(ended[0].fixtureA == id || ended[0].fixtureB == id) << edit.name;
        }
    }
}

/// Puts a body to sleep whenever one of its contacts was solved.
struct Sandman : ContactListener {
    void PostSolve(Contact*, const ContactImpulse*) override { body->SetAwake(false); }
    Body* body = nullptr;
};

TEST(Events, MovesTellWhoIsWokenAndFallsAsleepInOneStep) {
    for (const int substeps : {0, 4}) {
        World world({0.0f, -10.0f});
        world.SetReportMoves(true);
        Sandman sandman;
        sandman.body = AddBody(world, dynamicBody, {0.0f, 0.0f});
        AddBox(sandman.body, 0.5f, 0.5f);
        AddBox(AddBody(world, dynamicBody, {0.0f, 0.995f}), 0.5f, 0.5f);
        world.SetContactListener(&sandman);
        sandman.body->SetAwake(false);
        const BodyId id = world.GetId(sandman.body);
        for (int step = 0; step < 5; ++step) {
            const Vec2 before = sandman.body->GetPosition();
            StepWith(world, substeps);
            ASSERT_FALSE(before == sandman.body->GetPosition()) << "the other one wakes it";
            ASSERT_FALSE(sandman.body->IsAwake());
            const std::span<const MoveEvent> moved = world.GetEvents().moved;
            ASSERT_EQ(moved.size(), 2u) << "step " << step;
            EXPECT_EQ(moved.back().body, id);
            EXPECT_TRUE(moved.back().fellAsleep);
        }
    }
}

TEST(Events, BadInputIsRefused) {
    World world({0.0f, -10.0f});
    ErrorLog errors(world);
    CircleShape disk;
    disk.m_radius = 0.5f;
    FixtureDef def = Define(disk, 4);
    Body* body = AddBody(world, dynamicBody, {0.0f, 0.0f});
    EXPECT_EQ(body->CreateFixture(&def), nullptr);
    def.reports = Report::contacts;
    Fixture* fixture = body->CreateFixture(&def);
    ASSERT_NE(fixture, nullptr);
    EXPECT_EQ(fixture->SetReports(0x80), ErrorCode::outOfRange);
    EXPECT_EQ(fixture->GetReports(), Report::contacts);
    EXPECT_EQ(world.SetHitSpeed(-1.0f), ErrorCode::outOfRange);
    EXPECT_EQ(world.SetHitSpeed(nan), ErrorCode::nonFinite);
    EXPECT_EQ(world.GetHitSpeed(), 1.0f);
    body->DestroyFixture(fixture);
    EXPECT_EQ(fixture->SetReports(0), ErrorCode::foreignHandle);
    WorldDef fixed;
    fixed.featureMode = FeatureMode::fixed;
    fixed.features = Features::All().Without(Feature::events);
    World without(fixed);
    ErrorLog more(without);
    EXPECT_EQ(AddBody(without, dynamicBody, {0.0f, 0.0f})->CreateFixture(&def), nullptr);
    EXPECT_EQ(more.last.code, ErrorCode::missingFeature);
}

TEST(Events, WhatReportsIsSaved) {
    Bin bin(2, 1);
    for (int step = 0; step < 60; ++step) bin.Step(0);
    bin.bodies[1]->GetFixtureList()->SetReports(Report::contacts);
    const std::unique_ptr<World> restored = LoadWorld(SaveWorld(bin.world));
    ASSERT_NE(restored, nullptr);
    for (int step = 0; step < 60; ++step) {
        bin.Step(0);
        restored->Step(frame, 8, 3);
        ASSERT_EQ(PairsOf(restored->GetEvents().contactsBegun), PairsOf(bin.world.GetEvents().contactsBegun));
        ASSERT_EQ(restored->GetEvents().hits.size(), bin.world.GetEvents().hits.size());
    }
}

}  // namespace
}  // namespace scree::test
