// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Another shape of a fixture acts from the next step on, also where nothing moves.

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

PolygonShape Box(float halfWidth, float halfHeight) {
    PolygonShape box;
    box.SetAsBox(halfWidth, halfHeight);
    return box;
}

class SetShape : public testing::TestWithParam<BroadPhaseKind> {
protected:
    SetShape() : world(MakeDef()) {}
    static WorldDef MakeDef() {
        WorldDef def;
        def.gravity = {0.0f, -10.0f};
        def.broadPhase = GetParam();
        return def;
    }
    void StepFor(int steps, int substeps) {
        for (int i = 0; i < steps; ++i)
            substeps > 0 ? world.Step(1.0f / 60.0f, substeps) : world.Step(1.0f / 60.0f, 8, 3);
    }
    World world;
};

TEST_P(SetShape, OfTheGroundHoldsWhatFallsThere) {
    for (const BodyType type : {staticBody, kinematicBody}) {
        Body* ground = AddBody(world, type, {0.0f, 0.0f});
        Fixture* slab = AddBox(ground, 1.0f, 0.5f);
        Body* ball = AddBody(world, dynamicBody, {8.0f, 1.5f});
        AddCircle(ball, 0.5f);
        StepFor(1, 4);
        ASSERT_EQ(slab->SetShape(Box(10.0f, 0.5f)), ErrorCode::ok);
        EXPECT_NEAR(slab->GetAABB().upperBound.x, 10.0f, 0.2f);
        std::vector<Fixture*> found;
        world.QueryPoint({8.0f, 0.0f}, [&](Fixture* fixture) {
            found.push_back(fixture);
            return true;
        });
        EXPECT_EQ(found, std::vector{slab});
        StepFor(120, type == staticBody ? 4 : 0);
        EXPECT_NEAR(ball->GetPosition().y, 1.0f, 0.05f) << int{type};
        world.DestroyBody(ground), world.DestroyBody(ball);
    }
}

TEST_P(SetShape, OfTheGroundWakesWhoLosesIt) {
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    Fixture* slab = AddBox(ground, 10.0f, 0.5f);
    Body* crate = AddBody(world, dynamicBody, {8.0f, 1.0f});
    AddBox(crate, 0.5f, 0.5f);
    StepFor(120, 4);
    ASSERT_FALSE(crate->IsAwake());
    ASSERT_EQ(slab->SetShape(Box(1.0f, 0.5f)), ErrorCode::ok);
    StepFor(60, 4);
    EXPECT_LT(crate->GetPosition().y, -1.0f);
}

TEST_P(SetShape, OfASleeperMovesIt) {
    AddBox(AddBody(world, staticBody, {0.0f, 0.0f}), 10.0f, 0.5f);
    Body* crate = AddBody(world, dynamicBody, {0.0f, 1.0f});
    Fixture* box = AddBox(crate, 0.5f, 0.5f);
    StepFor(120, 4);
    ASSERT_FALSE(crate->IsAwake());
    ASSERT_EQ(box->SetShape(Box(0.25f, 0.25f)), ErrorCode::ok);
    EXPECT_TRUE(crate->IsAwake());
    StepFor(120, 4);
    EXPECT_NEAR(crate->GetPosition().y, 0.75f, 0.02f);
    ASSERT_EQ(box->SetShape(Box(0.5f, 0.5f)), ErrorCode::ok);
    StepFor(240, 4);
    EXPECT_NEAR(crate->GetPosition().y, 1.0f, 0.02f);
}

/// What continuous collision knows about the neighbourhood is another one, too.
TEST_P(SetShape, StopsFastBodies) {
    Fixture* wall = AddBox(AddBody(world, staticBody, {0.0f, 0.0f}), 0.05f, 0.5f);
    Body* ball = AddBody(world, dynamicBody, {-6.0f, 5.0f});
    AddCircle(ball, 0.1f);
    ball->SetGravityScale(0.0f);
    ball->SetLinearVelocity({1.0f, 0.0f});
    StepFor(30, 0);
    ASSERT_EQ(wall->SetShape(Box(0.05f, 8.0f)), ErrorCode::ok);
    ball->SetLinearVelocity({200.0f, 0.0f});
    StepFor(10, 0);
    EXPECT_LT(ball->GetPosition().x, 0.0f);
}

TEST_P(SetShape, OfADisabledBodyActsWhenItIsEnabled) {
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    Fixture* slab = AddBox(ground, 1.0f, 0.5f);
    ground->SetEnabled(false);
    ASSERT_EQ(slab->SetShape(Box(10.0f, 0.5f)), ErrorCode::ok);
    Body* ball = AddBody(world, dynamicBody, {8.0f, 1.5f});
    AddCircle(ball, 0.5f);
    ground->SetEnabled(true);
    StepFor(120, 4);
    EXPECT_NEAR(ball->GetPosition().y, 1.0f, 0.05f);
}

/// Against brute force, with ground that changes all the time.
TEST_P(SetShape, HasAContactWhereBoxesOverlap) {
    std::mt19937 random(1 + static_cast<uint32_t>(GetParam()));
    std::uniform_real_distribution<float> place(-6.0f, 6.0f), size(0.1f, 6.0f);
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    Fixture* slab = AddBox(ground, 1.0f, 0.5f);
    for (int i = 0; i < 30; ++i) AddBox(AddBody(world, dynamicBody, {place(random), 2.0f + 0.2f * i}), 0.3f, 0.3f);
    for (int round = 0; round < 40; ++round) {
        ASSERT_EQ(slab->SetShape(Box(size(random), 0.2f * size(random))), ErrorCode::ok);
        StepFor(1 + static_cast<int>(random() % 5), round % 2 == 0 ? 4 : 0);
        AABB box;
        std::as_const(*slab).GetShape()->ComputeAABB(&box, ground->GetTransform());
        EXPECT_TRUE(slab->GetAABB().Contains(box));
        int expected = 0, contacts = 0;
        for (Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            if (body != ground && TestOverlap(body->GetFixtureList()->GetAABB(), slab->GetAABB())) ++expected;
        }
        for (Contact* c = world.GetContactList(); c != nullptr; c = c->GetNext()) {
            const bool isOfSlab = c->GetFixtureA() == slab || c->GetFixtureB() == slab;
            if (isOfSlab && TestOverlap(c->GetFixtureA()->GetAABB(), c->GetFixtureB()->GetAABB())) ++contacts;
        }
        EXPECT_EQ(contacts, expected) << "round " << round;
    }
}

std::vector<BroadPhaseKind> AllKinds() {
    std::vector<BroadPhaseKind> kinds;
    for (size_t i = 0; i < broadPhaseNames.size(); ++i) kinds.push_back(static_cast<BroadPhaseKind>(i));
    return kinds;
}

INSTANTIATE_TEST_SUITE_P(Kinds, SetShape, testing::ValuesIn(AllKinds()), [](const auto& param) {
    std::string name(broadPhaseNames[static_cast<size_t>(param.param)]);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace scree::test
