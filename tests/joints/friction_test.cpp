// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The friction joint beside Box2D 2.4.1 and against the closed form of braking.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) { return std::vector<float>{joint->GetMaxForce(), joint->GetMaxTorque()}; };

template <typename Change>
auto Sliding(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        half.world.SetGravity(P(0.0f, 0.0f));
        auto* a = half.AddLopsided(0.0f, 0.0f, 0.5f, 0.5f);
        auto* b = half.AddLopsided(1.0f, 0.5f, 0.5f, 0.3f, 0.5f);
        b->SetLinearVelocity(P(3.0f, 1.0f));
        b->SetAngularVelocity(4.0f);
        typename H::FrictionJointDef def;
        def.Initialize(a, b, P(0.8f, 0.4f));
        def.maxForce = 1.0f, def.maxTorque = 0.2f;
        change(def);
        return static_cast<typename H::FrictionJoint*>(half.Join(def));
    };
}
constexpr auto plain = [](auto&) {};
constexpr auto strong = [](auto& def) { def.maxForce = 100.0f, def.maxTorque = 100.0f; };

TEST(FrictionTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Sliding(plain), untouched, values)); }
TEST(FrictionTwins, Slides) { ExpectSame(RunTwins({}, Sliding(plain), untouched, values)); }
TEST(FrictionTwins, SlidesCold) { ExpectSame(RunTwins({.warmStarting = false}, Sliding(plain), untouched, values)); }
TEST(FrictionTwins, Sticks) { ExpectSame(RunTwins({}, Sliding(strong), untouched, values)); }
TEST(FrictionTwins, Setters) {
    const auto edit = [](auto&, auto* joint, int step) {
        if (step == 20) joint->SetMaxForce(0.1f);
        if (step == 30) joint->SetMaxTorque(0.0f);
        if (step == 60) joint->SetMaxTorque(1.0f);
        if (step == 100) joint->SetMaxForce(5.0f);
    };
    ExpectSame(RunTwins({}, Sliding(plain), edit, values));
}

TEST(FrictionLaw, BrakesAtForceOverMassAndTorqueOverInertiaAndStops) {
    Half<Ours> half;
    half.world.SetGravity({0, 0});
    Body* body = half.AddBox(0, 0, 0.5f, 0.5f);
    body->SetLinearVelocity({2.0f, 0.0f});
    body->SetAngularVelocity(3.0f);
    FrictionJointDef def;
    def.Initialize(half.ground, body, {0, 0});
    def.maxForce = 1.0f, def.maxTorque = 0.2f;
    auto* joint = static_cast<FrictionJoint*>(half.Join(def));
    for (int i = 0; i < 60; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    // The held point drifts off the ground's anchor and gets an arm, so force and torque mix a little.
    EXPECT_NEAR(body->GetLinearVelocity().x, 1.0f, 0.05f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).Length(), 1.0f, 1e-4f);
    for (int i = 0; i < 240; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(body->GetLinearVelocity().Length(), 0.0f, 1e-5f);
    EXPECT_NEAR(body->GetAngularVelocity(), 0.0f, 1e-5f);
}

TEST(FrictionLaw, AnchorsTooFastForAnyNumberDoNothingToWhatNothingMoves) {
    for (const int substeps : {0, 4}) {
        World world({0.0f, -10.0f});
        BodyDef spinning;
        spinning.type = kinematicBody;
        spinning.angularVelocity = 30.0f;
        Body *a = world.CreateBody(&spinning), *b = world.CreateBody(&spinning);
        FrictionJointDef def;
        def.bodyA = a, def.bodyB = b;
        def.localAnchorA = {1e38f, -1e38f}, def.localAnchorB = {0.0f, 0.0f};
        def.maxForce = def.maxTorque = 1.0f;
        const Joint* joint = world.CreateJoint(&def);
        ASSERT_NE(joint, nullptr);
        for (int i = 0; i < 3; ++i) substeps > 0 ? world.Step(0.1f, substeps) : world.Step(0.1f, 8, 3);
        EXPECT_TRUE(joint->GetReactionForce(1.0f).IsValid()) << substeps;
    }
}

}  // namespace
}  // namespace scree::test
