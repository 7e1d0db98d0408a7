// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The mouse joint beside Box2D 2.4.1 and against its purpose: the held point settles on the target.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetTarget().x, joint->GetTarget().y, joint->GetMaxForce(), joint->GetStiffness(),
                              joint->GetDamping()};
};

template <typename Change>
auto Held(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* body = half.AddLopsided(0.0f, 0.0f, 0.5f, 0.3f, 0.2f);
        typename H::MouseJointDef def;
        def.bodyA = half.ground, def.bodyB = body;
        def.target = P(0.3f, 0.2f), def.maxForce = 100.0f, def.stiffness = 30.0f, def.damping = 2.0f;
        change(def);
        return static_cast<typename H::MouseJoint*>(half.Join(def));
    };
}
constexpr auto plain = [](auto&) {};
constexpr auto weak = [](auto& def) { def.maxForce = 8.0f; };
constexpr auto drag = [](auto& half, auto* joint, int step) {
    using P = typename std::remove_reference_t<decltype(half)>::Point;
    const float t = static_cast<float>(step) / 60.0f;
    joint->SetTarget(P(std::sin(2.0f * t), 0.5f + t));
    if (step == 100) joint->SetMaxForce(30.0f);
    if (step == 150) joint->SetStiffness(80.0f);
    if (step == 200) joint->SetDamping(6.0f);
};

TEST(MouseTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Held(plain), untouched, values)); }
TEST(MouseTwins, Held) { ExpectSame(RunTwins({}, Held(plain), untouched, values)); }
TEST(MouseTwins, HeldCold) { ExpectSame(RunTwins({.warmStarting = false}, Held(plain), untouched, values)); }
TEST(MouseTwins, TooWeak) { ExpectSame(RunTwins({.steps = 120}, Held(weak), untouched, values)); }
TEST(MouseTwins, DraggedAndEdited) { ExpectSame(RunTwins({}, Held(plain), drag, values)); }
TEST(MouseTwins, AtThirtyHertz) { ExpectSame(RunTwins({.dt = 1.0f / 30.0f}, Held(plain), drag, values)); }

TEST(MouseLaw, TheHeldPointSettlesOnTheTargetButForTheSag) {
    Half<Ours> half;
    Body* body = half.AddBox(0, 0, 0.5f, 0.5f);
    float stiffness = 0, damping = 0;
    ASSERT_EQ(LinearStiffness(stiffness, damping, 5.0f, 0.7f, half.ground, body), ErrorCode::ok);
    MouseJointDef def;
    def.bodyA = half.ground, def.bodyB = body, def.target = {0.4f, 0.4f};
    def.maxForce = 1000.0f, def.stiffness = stiffness, def.damping = damping;
    auto* joint = static_cast<MouseJoint*>(half.Join(def));
    joint->SetTarget({3.0f, 2.0f});
    // The body swings about the held point; 2 % of its spin per step damp that at some 0.2 per second.
    for (int i = 0; i < 3000; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    const Vec2 sag{0.0f, -10.0f / stiffness};  // 1 kg at 10 m/s²
    EXPECT_NEAR(Distance(joint->GetAnchorB(), Vec2{3.0f, 2.0f} + sag), 0.0f, 2e-3f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, 10.0f, 0.1f);
    EXPECT_EQ(joint->GetReactionTorque(60.0f), 0.0f);
}

TEST(MouseLaw, ASleepingBodyWakesOnlyForANewTarget) {
    Half<Ours> half;
    half.world.SetGravity({0, 0});
    Body* body = half.AddBox(0, 0, 0.5f, 0.5f);
    MouseJointDef def;
    def.bodyA = half.ground, def.bodyB = body, def.maxForce = 10.0f, def.stiffness = 10.0f;
    auto* joint = static_cast<MouseJoint*>(half.Join(def));
    body->SetAwake(false);
    joint->SetTarget({0.0f, 0.0f});
    joint->SetMaxForce(20.0f);
    EXPECT_FALSE(body->IsAwake());
    joint->SetTarget({1.0f, 0.0f});
    EXPECT_TRUE(body->IsAwake());
}

}  // namespace
}  // namespace scree::test
