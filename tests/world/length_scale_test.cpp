// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world in other units: with every length, gravity and WorldDef::lengthScale times a power of two, every pose and
// velocity is exactly that many times the original's, step by step. Binary scaling changes no digit of a float, so any
// tolerance that does not scale shows as a difference.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/world/fixtures.h"
#include "world/world_state.h"

namespace scree::test {
namespace {

WorldDef ScaledDef(float scale) {
    WorldDef def;
    def.gravity = {0, -10 * scale};
    def.lengthScale = scale;
    return def;
}

/// A pile of boxes and balls, and a fast ball shot at a thin wall.
class ScaledWorld {
public:
    explicit ScaledWorld(float scale) : m_scale(scale), m_world(ScaledDef(scale)) {
        Add(staticBody, {0, -1}, 0, 40, 1);
        Add(staticBody, {20, 5}, 0, 0.05f, 5);
        for (int row = 0; row < 12; ++row) {
            for (int i = 0; i < 12; ++i) {
                const Vec2 at{1.1f * static_cast<float>(i) - 8.0f, 0.6f + 1.1f * static_cast<float>(row)};
                if ((row + i) % 3 == 0) {
                    AddBall(at);
                } else {
                    Add(dynamicBody, at, 0.1f * static_cast<float>(i % 4), 0.5f, 0.4f);
                }
            }
        }
        AddBall({10, 4})->SetLinearVelocity(scale * Vec2(600, 10));
    }

    void Step(bool soft) { StepWith(m_world, soft ? 4 : 0); }
    [[nodiscard]] float GetScale() const { return m_scale; }
    [[nodiscard]] World& Get() { return m_world; }

private:
    Body* Make(BodyType type, Vec2 at, float angle) { return AddBody(m_world, type, m_scale * at, angle); }
    void Finish(Body* body) { body->GetFixtureList()->SetRestitutionThreshold(m_scale); }
    void Add(BodyType type, Vec2 at, float angle, float hx, float hy) {
        Body* body = Make(type, at, angle);
        AddBox(body, m_scale * hx, m_scale * hy);
        Finish(body);
    }
    Body* AddBall(Vec2 at) {
        Body* body = Make(dynamicBody, at, 0);
        AddCircle(body, m_scale * 0.5f);
        Finish(body);
        return body;
    }

    float m_scale;
    World m_world;
};

void ExpectSame(World& one, World& scaled, float scale, int step) {
    Body* b = scaled.GetBodyList();
    for (Body* a = one.GetBodyList(); a; a = a->GetNext(), b = b->GetNext()) {
        ASSERT_EQ(scale * a->GetPosition(), b->GetPosition()) << "step " << step;
        ASSERT_EQ(scale * a->GetLinearVelocity(), b->GetLinearVelocity()) << "step " << step;
        ASSERT_EQ(a->GetAngle(), b->GetAngle()) << "step " << step;
        ASSERT_EQ(a->GetAngularVelocity(), b->GetAngularVelocity()) << "step " << step;
        ASSERT_EQ(a->IsAwake(), b->IsAwake()) << "step " << step;
    }
}

TEST(LengthScale, ScalesEveryTolerance) {
    for (const bool soft : {false, true}) {
        for (const float scale : {1.0f / 1024.0f, 1.0f / 8.0f}) {
            ScaledWorld one(1.0f), other(scale);
            for (int step = 0; step < 400; ++step) {
                one.Step(soft);
                other.Step(soft);
                ExpectSame(one.Get(), other.Get(), scale, step);
                if (::testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

/// Two balls on each kind of joint that has a length, with limits that they reach; one more joint of no length.
class ScaledJoints {
public:
    explicit ScaledJoints(float scale) : m_scale(scale), m_world(ScaledDef(scale)) {
        const auto makeBall = [&](Vec2 at) {
            Body* body = AddBody(m_world, dynamicBody, m_scale * at, 0);
            AddCircle(body, m_scale * 0.3f);
            return body;
        };
        Body* ground = AddBody(m_world, staticBody, {0, 0}, 0);
        DistanceJointDef rod;
        rod.Initialize(ground, makeBall({1, 5}), scale * Vec2(0, 5), scale * Vec2(1, 5));
        m_world.CreateJoint(&rod);
        rod.Initialize(ground, makeBall({11, 5}), scale * Vec2(11, 5.5f), scale * Vec2(11, 5.5f));
        shortest = static_cast<DistanceJoint*>(m_world.CreateJoint(&rod));
        PrismaticJointDef slide;
        slide.Initialize(ground, makeBall({20, 5}), scale * Vec2(20, 5), {0.6f, 0.8f});
        slide.enableLimit = true;
        slide.lowerTranslation = -0.75f * scale;
        slide.upperTranslation = scale;
        m_world.CreateJoint(&slide);
        WheelJointDef wheel;
        wheel.Initialize(ground, makeBall({30, 5}), scale * Vec2(30, 5), {0, 1});
        wheel.enableLimit = true;
        wheel.lowerTranslation = -0.25f * scale;
        wheel.upperTranslation = 0.25f * scale;
        m_world.CreateJoint(&wheel);
        Body* light = makeBall({40, 5});
        Body* heavy = makeBall({43, 5});
        AddCircle(heavy, m_scale * 0.5f);
        PulleyJointDef rope;
        rope.Initialize(light, heavy, scale * Vec2(40, 5.25f), scale * Vec2(43, 9), scale * Vec2(40, 5),
                        scale * Vec2(43, 5), 1);
        m_world.CreateJoint(&rope);
        Body* last = ground;
        for (int i = 0; i < 6; ++i) {
            Body* link = makeBall({51.0f + static_cast<float>(i), 5});
            RevoluteJointDef hinge;
            hinge.Initialize(last, link, scale * Vec2(50.5f + static_cast<float>(i), 5));
            m_world.CreateJoint(&hinge);
            last = link;
        }
        WeldJointDef weld;
        weld.Initialize(last, makeBall({57, 5}), scale * Vec2(56.5f, 5));
        m_world.CreateJoint(&weld);
    }

    void Step(bool soft) { StepWith(m_world, soft ? 4 : 0); }
    [[nodiscard]] World& Get() { return m_world; }

    DistanceJoint* shortest;

private:
    float m_scale;
    World m_world;
};

TEST(LengthScale, ScalesEveryToleranceOfJoints) {
    for (const bool soft : {false, true}) {
        for (const float scale : {1.0f / 1024.0f, 1.0f / 8.0f, 64.0f}) {
            ScaledJoints one(1.0f), other(scale);
            EXPECT_EQ(other.shortest->GetLength(), scale * linearSlop);
            other.shortest->SetMinLength(0);
            EXPECT_EQ(other.shortest->GetMinLength(), scale * linearSlop);
            for (int step = 0; step < 300; ++step) {
                one.Step(soft);
                other.Step(soft);
                ExpectSame(one.Get(), other.Get(), scale, step);
                if (::testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

TEST(LengthScale, ScalesTheMarginOfTheFatTree) {
    for (const float scale : {1.0f / 1024.0f, 64.0f}) {
        WorldDef def;
        def.broadPhase = BroadPhaseKind::fatTree;
        def.lengthScale = scale;
        World world(def);
        Body* body = AddBody(world, dynamicBody, {0, 0}, 0);
        AddCircle(body, scale);
        world.Step(0.0f, 8, 3);
        EXPECT_FLOAT_EQ(world.GetState().broadPhase->GetBox(0).upperBound.x, scale * (1.0f + aabbExtension));
    }
}

TEST(LengthScale, SkinsScaleUnlessTheyWereChosen) {
    WorldDef def;
    def.lengthScale = 0.001f;
    World world(def);
    Body* body = AddBody(world, dynamicBody, {0, 0});
    EXPECT_FLOAT_EQ(AddBox(body, 0.001f, 0.001f)->GetShape()->m_radius, 0.001f * polygonRadius);
    EXPECT_EQ(AddCircle(body, polygonRadius)->GetShape()->m_radius, polygonRadius);
    PolygonShape chosen;
    chosen.SetAsBox(0.001f, 0.001f);
    chosen.m_radius = 0.0f;
    EXPECT_EQ(body->CreateFixture(&chosen, 1)->GetShape()->m_radius, 0.0f);
}

TEST(LengthScale, IsChecked) {
    for (const float bad : {0.0f, -1.0f, 1e-7f, 1e7f, std::nanf("")}) {
        WorldDef def;
        def.lengthScale = bad;
        EXPECT_EQ(CreateWorld(def, [](const Error&, void*) {}), nullptr) << bad;
    }
}

TEST(LengthScale, ASolidRadiusIsNoSkin) {
    for (const float scale : {0.01f, 0.5f, 100.0f}) {
        WorldDef def;
        def.lengthScale = scale;
        World world(def);
        Body* body = AddBody(world, dynamicBody, {0, 0});
        const ConvexShape capsule = MakeCapsule({-0.02f, 0.0f}, {0.02f, 0.0f}, polygonRadius);
        Fixture* fixture = body->CreateFixture(&capsule, 1.0f);
        EXPECT_EQ(std::as_const(*fixture).GetShape()->m_radius, polygonRadius);
        EXPECT_EQ(fixture->SetShape(ConvexShape(capsule)), ErrorCode::ok);
        SnapshotError error = SnapshotError::badContent;
        EXPECT_NE(LoadWorld(SaveWorld(world), &error), nullptr) << GetName(error);
    }
}

TEST(LengthScale, SkinsOfShapesThatAreSetScaleAlike) {
    WorldDef def;
    def.lengthScale = 1.0f / 64.0f;
    World world(def);
    Body* body = AddBody(world, dynamicBody, {0, 0});
    Fixture* made = AddBox(body, 0.01f, 0.01f);
    Fixture* set = AddBox(body, 0.02f, 0.02f);
    PolygonShape box;
    box.SetAsBox(0.01f, 0.01f);
    ASSERT_EQ(set->SetShape(box), ErrorCode::ok);
    EXPECT_EQ(std::as_const(*set).GetShape()->m_radius, std::as_const(*made).GetShape()->m_radius);
    ASSERT_EQ(set->SetShape(*std::as_const(*made).GetShape()), ErrorCode::ok);
    EXPECT_EQ(std::as_const(*set).GetShape()->m_radius, std::as_const(*made).GetShape()->m_radius);
}

}  // namespace
}  // namespace scree::test
