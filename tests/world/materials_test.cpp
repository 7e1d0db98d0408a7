// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Materials of fixtures: conveyors, rolling resistance, mixing, changes that act on contacts there are, filters of 64
// bits. Laws hold in both solvers; recordings, images and workers lead to the same states.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <random>

#include "scree/recording.h"
#include "scree/snapshot.h"
#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

Fixture* AddShape(Body* body, const Shape& shape, FixtureDef def) {
    def.shape = &shape;
    return body->CreateFixture(&def);
}

PolygonShape Box(float hx, float hy) {
    PolygonShape box;
    box.SetAsBox(hx, hy);
    return box;
}

TEST(Materials, AConveyorCarriesWhatLiesOnItWhicheverFixtureIsFirst) {
    for (const int substeps : solvers) {
        for (const bool beltIsEdge : {false, true}) {
            for (const float speed : {1.5f, -2.5f}) {
                World world({0.0f, -10.0f});
                FixtureDef material;
                material.friction = 0.6f;
                material.tangentSpeed = speed;
                EdgeShape edge;
                edge.SetTwoSided({-50.0f, 0.5f}, {50.0f, 0.5f});
                const PolygonShape box = Box(50.0f, 0.5f);
                Body* belt = AddBody(world, staticBody, {0.0f, 0.0f});
                AddShape(belt, beltIsEdge ? static_cast<const Shape&>(edge) : box, material);
                Body* crate = AddBody(world, dynamicBody, {0.0f, 1.0f});
                AddBox(crate, 0.5f, 0.5f);
                StepWith(world, substeps, 120);
                EXPECT_NEAR(crate->GetLinearVelocity().x, speed, 0.02f) << substeps << ' ' << beltIsEdge;
                // Two belts that face each other add up: the crate's own underside runs the other way round.
                crate->GetFixtureList()->SetTangentSpeed(-speed);
                StepWith(world, substeps, 120);
                EXPECT_NEAR(crate->GetLinearVelocity().x, 0.0f, 0.02f) << substeps << ' ' << beltIsEdge;
            }
        }
    }
}

/// A disk that rolls slows down by 2/3 of the coefficient times gravity (torque over inertia about the contact), and
/// stays on slopes below the coefficient.
TEST(Materials, ARollingDiskSlowsDownByTheLaw) {
    for (const int substeps : solvers) {
        for (const float resistance : {0.05f, 0.12f}) {
            World world({0.0f, -10.0f});
            AddGround(world)->GetFixtureList()->SetFriction(0.9f);
            Body* disk = AddBody(world, dynamicBody, {0.0f, 0.4f});
            CircleShape circle;
            circle.m_radius = 0.4f;
            FixtureDef material;
            material.density = 1.0f;
            material.friction = 0.9f;
            material.rollingResistance = resistance;
            AddShape(disk, circle, material);
            const float start = 4.0f, slowing = resistance * 10.0f / 1.5f;
            disk->SetLinearVelocity({start, 0.0f});
            disk->SetAngularVelocity(-start / 0.4f);
            StepWith(world, substeps, 60);
            EXPECT_NEAR(disk->GetLinearVelocity().x, start - slowing, 0.03f * start) << substeps;
            StepWith(world, substeps, static_cast<int>(60.0f * start / slowing));
            EXPECT_NEAR(disk->GetLinearVelocity().x, 0.0f, 0.01f) << substeps;
        }
    }
}

TEST(Materials, RollingResistanceHoldsADiskOnASlopeBelowIt) {
    for (const int substeps : solvers) {
        for (const float slope : {0.05f, 0.15f}) {
            World world({10.0f * std::sin(slope), -10.0f * std::cos(slope)});
            AddGround(world)->GetFixtureList()->SetRollingResistance(0.1f);
            Body* disk = AddBody(world, dynamicBody, {0.0f, 0.3f});
            AddCircle(disk, 0.3f);
            StepWith(world, substeps, 180);
            if (slope < 0.1f) {
                EXPECT_NEAR(disk->GetPosition().x, 0.0f, 0.02f) << substeps;
            } else {
                EXPECT_GT(disk->GetPosition().x, 0.5f) << substeps;
            }
        }
    }
}

TEST(Materials, WithoutResistanceNothingOfItRuns) {
    World world({0.0f, -10.0f});
    AddGround(world);
    Body* disk = AddBody(world, dynamicBody, {0.0f, 0.3f});
    Fixture* fixture = AddCircle(disk, 0.3f);
    StepFor(world, 3);
    EXPECT_FALSE(inspect::GetKernels(world).rolling);
    EXPECT_TRUE(world.GetState().contacts.rolling.empty());
    fixture->SetRollingResistance(0.1f);
    StepFor(world, 1);
    EXPECT_TRUE(inspect::GetKernels(world).rolling);
    EXPECT_TRUE(world.GetRequiredFeatures().Has(Feature::rollingResistance));
    fixture->SetRollingResistance(0.0f);
    StepFor(world, 1);
    EXPECT_FALSE(inspect::GetKernels(world).rolling);
}

/// Doubles what both have, and tells of materials by their ids.
class Doubler final : public MaterialMixer {
public:
    float MixFriction(const Fixture* a, const Fixture* b) override {
        return 0.01f * static_cast<float>(a->GetMaterialId() + b->GetMaterialId());
    }
    float MixRestitution(const Fixture* a, const Fixture* b) override {
        return a->GetMaterialId() == 99 || b->GetMaterialId() == 99 ? nan : 0.25f;
    }
};

TEST(Materials, AreMixedByTheLaterRuleOfTheTwo) {
    EXPECT_TRUE(rc::check("mixing", [] {
        const auto number = [] { return 0.01f * static_cast<float>(*rc::gen::inRange(0, 150)); };
        const auto rule = [] { return static_cast<MixRule>(*rc::gen::inRange(0, 6)); };
        World world({0.0f, 0.0f});
        Doubler mixer;
        if (*rc::gen::arbitrary<bool>()) world.SetMaterialMixer(&mixer);
        std::array<FixtureDef, 2> defs;
        const PolygonShape box = Box(0.5f, 0.5f);
        for (size_t i = 0; i < 2; ++i) {
            defs[i].friction = number();
            defs[i].restitution = number();
            defs[i].frictionRule = rule();
            defs[i].restitutionRule = rule();
            defs[i].materialId = i == 0 ? 30 : static_cast<uint64_t>(*rc::gen::element(7, 99));
            AddShape(AddBody(world, dynamicBody, {0.8f * static_cast<float>(i), 0.0f}), box, defs[i]);
        }
        StepFor(world, 1);
        const Contact* contact = world.GetContactList();
        RC_ASSERT(contact != nullptr);
        const bool asks = world.GetState().mixer != nullptr;
        const auto expect = [&](MixRule a, MixRule b, float x, float y, float standard, float custom) {
            switch (std::max(a, b)) {
                case MixRule::average:
                    return (x + y) / 2.0f;
                case MixRule::minimum:
                    return std::min(x, y);
                case MixRule::multiply:
                    return x * y;
                case MixRule::maximum:
                    return std::max(x, y);
                case MixRule::custom:
                    return asks ? custom : standard;
                default:
                    return standard;
            }
        };
        const float standardFriction = std::sqrt(defs[0].friction * defs[1].friction);
        const float standardRestitution = std::max(defs[0].restitution, defs[1].restitution);
        const float friction = expect(defs[0].frictionRule, defs[1].frictionRule, defs[0].friction, defs[1].friction,
                                      standardFriction, 0.01f * static_cast<float>(30 + defs[1].materialId));
        const float restitution =
            expect(defs[0].restitutionRule, defs[1].restitutionRule, defs[0].restitution, defs[1].restitution,
                   standardRestitution, defs[1].materialId == 99 ? standardRestitution : 0.25f);
        RC_ASSERT(std::abs(contact->GetFriction() - friction) <= 1e-6f);
        RC_ASSERT(std::abs(contact->GetRestitution() - restitution) <= 1e-6f);
    }));
}

struct Resting {
    explicit Resting(int substeps) {
        AddGround(world);
        crate = AddBody(world, dynamicBody, {0.0f, 0.5f});
        fixture = AddBox(crate, 0.5f, 0.5f);
        StepWith(world, substeps, 90);
        contact = world.GetContactList();
    }
    World world{Vec2{0.0f, -10.0f}};
    Body* crate;
    Fixture* fixture;
    Contact* contact;
};

TEST(Materials, ChangesActOnContactsThereAreAndWakeThem) {
    for (const int substeps : solvers) {
        Resting rest(substeps);
        Fixture* ground =
            rest.contact->GetFixtureA() == rest.fixture ? rest.contact->GetFixtureB() : rest.contact->GetFixtureA();
        ASSERT_FALSE(rest.crate->IsAwake());
        ground->SetTangentSpeed(2.0f);
        EXPECT_TRUE(rest.crate->IsAwake());
        EXPECT_EQ(rest.contact->GetTangentSpeed(), 2.0f);
        StepWith(rest.world, substeps, 120);
        EXPECT_NEAR(rest.crate->GetLinearVelocity().x, 2.0f, 0.02f);
        ground->SetFriction(0.0f);
        rest.fixture->SetRestitution(0.5f);
        rest.fixture->SetRestitutionThreshold(0.25f);
        EXPECT_EQ(rest.contact->GetFriction(), 0.0f);
        EXPECT_EQ(rest.contact->GetRestitution(), 0.5f);
        EXPECT_EQ(rest.contact->GetRestitutionThreshold(), 0.25f);
        ground->SetMixRules(MixRule::maximum, MixRule::average);
        EXPECT_EQ(rest.contact->GetFriction(), 0.2f);
        EXPECT_EQ(rest.contact->GetRestitution(), 0.25f);
        ground->SetFriction(0.7f, true);
        EXPECT_EQ(rest.contact->GetFriction(), 0.2f) << "for new contacts only";
    }
}

TEST(Materials, WhatAContactWasGivenStays) {
    Resting rest(4);
    rest.contact->SetFriction(0.55f);
    rest.fixture->SetFriction(0.9f);
    rest.fixture->SetRestitution(0.4f);
    EXPECT_EQ(rest.contact->GetFriction(), 0.55f);
    EXPECT_EQ(rest.contact->GetRestitution(), 0.4f);
    rest.contact->ResetFriction();
    EXPECT_EQ(rest.contact->GetFriction(), std::sqrt(0.9f * 0.2f));
}

TEST(Materials, CategoriesHave64Bits) {
    World world({0.0f, 0.0f});
    Fixture* fixtures[2];
    for (int i = 0; i < 2; ++i) {
        fixtures[i] = AddBox(AddBody(world, dynamicBody, {0.5f * static_cast<float>(i), 0.0f}), 0.5f, 0.5f);
        fixtures[i]->SetFilterData({.categoryBits = uint64_t{1} << (40 + i), .maskBits = ~(uint64_t{1} << 40)});
    }
    StepFor(world, 1);
    EXPECT_EQ(world.GetContactCount(), 0);
    QueryFilter filter;
    filter.maskBits = uint64_t{1} << 41;
    const auto hit = world.RayCastClosest({-5.0f, 0.0f}, {5.0f, 0.0f}, filter);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->fixture, fixtures[1]);
    fixtures[1]->SetFilterData({.categoryBits = uint64_t{1} << 41});
    fixtures[0]->SetFilterData({.categoryBits = uint64_t{1} << 40});
    StepFor(world, 1);
    EXPECT_EQ(world.GetContactCount(), 1);
}

TEST(Materials, BadValuesAreRefused) {
    Resting rest(4);
    ErrorLog errors(rest.world);
    const uint64_t before = inspect::GetStateHash(rest.world);
    EXPECT_EQ(rest.fixture->SetTangentSpeed(nan), ErrorCode::nonFinite);
    EXPECT_EQ(rest.fixture->SetRollingResistance(-0.1f), ErrorCode::outOfRange);
    EXPECT_EQ(rest.fixture->SetRollingResistance(infinity), ErrorCode::nonFinite);
    EXPECT_EQ(rest.fixture->SetMixRules(static_cast<MixRule>(6), MixRule::standard), ErrorCode::outOfRange);
    EXPECT_EQ(rest.fixture->SetMixRules(MixRule::standard, static_cast<MixRule>(77)), ErrorCode::outOfRange);
    const PolygonShape box = Box(0.5f, 0.5f);
    FixtureDef def;
    def.rollingResistance = -1.0f;
    EXPECT_EQ(AddShape(rest.crate, box, def), nullptr);
    def = {};
    def.frictionRule = static_cast<MixRule>(9);
    EXPECT_EQ(AddShape(rest.crate, box, def), nullptr);
    def = {};
    def.tangentSpeed = infinity;
    EXPECT_EQ(AddShape(rest.crate, box, def), nullptr);
    EXPECT_EQ(errors.count, 8);
    EXPECT_EQ(inspect::GetStateHash(rest.world), before);
}

/// Disks, capsules and boxes of random materials on a belt and a slope, which are edited on the way.
class Spinner {
public:
    explicit Spinner(uint32_t seed) : m_random(seed) {
        FixtureDef belt = Random();
        belt.tangentSpeed = 1.0f;
        EdgeShape edge;
        edge.SetTwoSided({-6.0f, 0.0f}, {6.0f, 0.0f});
        AddShape(AddBody(world, staticBody, {0.0f, 0.0f}), edge, belt);
        edge.SetTwoSided({5.0f, 0.0f}, {9.0f, 3.0f});
        AddShape(AddBody(world, staticBody, {0.0f, 0.0f}), edge, Random());
        for (int i = 0; i < 60; ++i) {
            Body* body = AddBody(world, dynamicBody,
                                 {static_cast<float>(i % 8) - 4.0f, 0.6f + 0.9f * static_cast<float>(i / 8)});
            CircleShape disk;
            disk.m_radius = Number(0.2f, 0.4f);
            const ConvexShape capsule = MakeCapsule({-0.2f, 0.0f}, {0.2f, 0.1f}, 0.15f);
            const PolygonShape box = Box(0.3f, 0.2f);
            const Shape* shapes[] = {&disk, &capsule, &box};
            m_fixtures.push_back(AddShape(body, *shapes[i % 3], Random()));
        }
    }
    void Step(int substeps) {
        Fixture* fixture = m_fixtures[m_random() % m_fixtures.size()];
        switch (m_random() % 6) {
            case 0:
                fixture->SetRollingResistance(Number(0.0f, 0.3f));
                break;
            case 1:
                fixture->SetTangentSpeed(Number(-1.0f, 1.0f));
                break;
            case 2:
                fixture->SetMixRules(Rule(), Rule());
                break;
            case 3:
                fixture->SetFriction(Number(0.0f, 1.0f), m_random() % 2 == 0);
                break;
            case 4:
                fixture->SetMaterialId(m_random() % 50);
                break;
            default:
                fixture->SetFilterData({.categoryBits = uint64_t{1} << (m_random() % 64)});
        }
        StepWith(world, substeps, 1);
    }

    World world{Vec2{0.0f, -10.0f}};

private:
    float Number(float low, float high) { return low + (high - low) * static_cast<float>(m_random() % 1024) / 1024.0f; }
    MixRule Rule() { return static_cast<MixRule>(m_random() % 6); }
    FixtureDef Random() {
        FixtureDef def;
        def.density = 1.0f;
        def.friction = Number(0.0f, 1.0f);
        def.restitution = Number(0.0f, 0.5f);
        def.rollingResistance = Number(0.0f, 0.2f);
        def.frictionRule = Rule();
        def.restitutionRule = Rule();
        def.materialId = m_random() % 50;
        return def;
    }

    std::mt19937 m_random;
    std::vector<Fixture*> m_fixtures;
};

TEST(Materials, RecordingsImagesAndWorkersLeadToTheSameState) {
    for (const int substeps : solvers) {
        Spinner mill(7), threaded(7);
        threaded.world.SetWorkers(3);
        threaded.world.GetState().pool->ShareAlways();
        Recorder recorder;
        ASSERT_EQ(StartRecording(mill.world, recorder), ErrorCode::ok);
        for (int i = 0; i < 150; ++i) {
            mill.Step(substeps), threaded.Step(substeps);
            ASSERT_EQ(inspect::GetStateHash(mill.world), inspect::GetStateHash(threaded.world)) << i;
        }
        StopRecording(mill.world);
        const ReplayReport report = Replay(recorder.GetBytes());
        EXPECT_TRUE(report.valid);
        EXPECT_EQ(report.firstDifference, 0);
        EXPECT_EQ(inspect::GetStateHash(*report.world), inspect::GetStateHash(mill.world));

        const auto loaded = LoadWorld(SaveWorld(mill.world));
        ASSERT_NE(loaded, nullptr);
        StepWith(mill.world, substeps, 60), StepWith(*loaded, substeps, 60);
        EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(mill.world));
    }
}

}  // namespace
}  // namespace scree::test
