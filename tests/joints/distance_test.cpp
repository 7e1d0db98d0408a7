// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The distance joint beside Box2D 2.4.1 and against closed forms: rod, rope, spring.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetCurrentLength(), joint->GetLength(), joint->GetMinLength(),
                              joint->GetMaxLength()};
};

/// Two lopsided boxes, one joined to the ground and both joined by the joint under test; `change` edits its definition.
template <typename Change>
auto Pair(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(1.0f, 0.0f, 0.5f, 0.2f);
        auto* b = half.AddLopsided(2.5f, -0.5f, 0.3f, 0.3f, 0.4f);
        typename H::RevoluteJointDef pivot;
        pivot.Initialize(half.ground, a, P(0.5f, 0.0f));
        half.Join(pivot);
        typename H::DistanceJointDef def;
        def.Initialize(a, b, P(1.5f, 0.0f), P(2.3f, -0.5f));
        change(def);
        return static_cast<typename H::DistanceJoint*>(half.Join(def));
    };
}

constexpr auto rod = [](auto&) {};
constexpr auto rope = [](auto& def) { def.minLength = 0.0f, def.maxLength = 1.2f; };
constexpr auto spring = [](auto& def) {
    def.minLength = 0.2f, def.maxLength = 3.0f, def.stiffness = 20.0f, def.damping = 0.5f;
};
constexpr auto tightSpring = [](auto& def) {
    def.minLength = 0.8f, def.maxLength = 1.1f, def.stiffness = 5.0f, def.damping = 0.2f;
};

TEST(DistanceTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Pair(spring), untouched, values)); }
TEST(DistanceTwins, Rod) { ExpectSame(RunTwins({}, Pair(rod), untouched, values)); }
TEST(DistanceTwins, RodCold) { ExpectSame(RunTwins({.warmStarting = false}, Pair(rod), untouched, values)); }
TEST(DistanceTwins, Rope) { ExpectSame(RunTwins({}, Pair(rope), untouched, values)); }
TEST(DistanceTwins, Spring) { ExpectSame(RunTwins({}, Pair(spring), untouched, values)); }
TEST(DistanceTwins, SpringCold) { ExpectSame(RunTwins({.warmStarting = false}, Pair(spring), untouched, values)); }
TEST(DistanceTwins, SpringWithinLimits) { ExpectSame(RunTwins({}, Pair(tightSpring), untouched, values)); }
TEST(DistanceTwins, Setters) {
    const auto edit = [](auto&, auto* joint, int step) {
        if (step == 60) joint->SetLength(1.2f);
        if (step == 90) joint->SetStiffness(40.0f);
        if (step == 120) joint->SetDamping(2.0f);
        if (step == 150) joint->SetMaxLength(1.5f);
        if (step == 180) joint->SetMinLength(1.0f);
        if (step == 210) joint->SetMaxLength(0.1f);  // clamped to the minimum: a rod
    };
    ExpectSame(RunTwins({}, Pair(spring), edit, values));
}
TEST(DistanceTwins, RopeCold) {
    // Without warm starting 2.4.1 lets the impulses of a limit grow from step to step and reports their sum as
    // reaction; the motion is the same.
    Worst worst = RunTwins({.warmStarting = false}, Pair(rope), untouched, values);
    EXPECT_GT(worst.reaction, 0.5f);
    worst.reaction = 0.0f;
    ExpectSame(worst);
}

/// A unit mass on a spring from the ground, at rest at `start` below it.
struct Hanging {
    explicit Hanging(float stiffness, float damping, float start) {
        body = half.AddBox(0.0f, -start, 0.5f, 0.5f);
        DistanceJointDef def;
        def.Initialize(half.ground, body, {0.0f, 0.0f}, {0.0f, -start});
        def.length = 2.0f;
        def.minLength = 0.0f;
        def.maxLength = 10.0f;
        def.stiffness = stiffness;
        def.damping = damping;
        joint = static_cast<DistanceJoint*>(half.Join(def));
    }
    Half<Ours> half;
    Body* body;
    DistanceJoint* joint;
};

TEST(DistanceLaw, ASpringSwingsAtTheRootOfStiffnessOverMass) {
    Hanging s(40.0f, 0.0f, 2.35f);  // hangs at 2 + m·g/k = 2.25 m
    const float dt = 1.0f / 600.0f;
    std::vector<float> passes;
    float before = s.joint->GetCurrentLength();
    for (int i = 0; i < 6000; ++i) {
        s.half.world.Step(dt, 8, 3);
        const float now = s.joint->GetCurrentLength();
        if (before < 2.25f && now >= 2.25f)
            passes.push_back((static_cast<float>(i) + (2.25f - before) / (now - before)) * dt);
        before = now;
    }
    ASSERT_GE(passes.size(), 3u);
    const float period = (passes.back() - passes.front()) / static_cast<float>(passes.size() - 1);
    // Implicit Euler lowers the frequency by (ω·dt)²/3 relative, 4e-5 here; interpolation and float steps add as much.
    EXPECT_NEAR(1.0f / period, std::sqrt(40.0f) / (2.0f * pi), 1e-3f);
}

TEST(DistanceLaw, ADampedSpringSagsByWeightOverStiffnessAndCarriesTheWeight) {
    Hanging s(40.0f, 8.0f, 2.0f);
    for (int i = 0; i < 600; ++i) s.half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(s.joint->GetCurrentLength(), 2.25f, 1e-3f);  // the sleep rule stops it a little early
    EXPECT_NEAR(s.joint->GetReactionForce(60.0f).y, 10.0f, 0.05f);
    EXPECT_EQ(s.joint->GetReactionTorque(60.0f), 0.0f);
}

TEST(DistanceLaw, ASpringTurnedOffPullsNoMore) {
    // 2.4.1 goes on with the force of the last step; ours lets the body fall.
    Hanging s(40.0f, 8.0f, 2.25f);
    for (int i = 0; i < 60; ++i) s.half.world.Step(1.0f / 60.0f, 8, 3);
    s.body->SetAwake(true);
    const float before = s.body->GetLinearVelocity().y;
    s.joint->SetStiffness(0.0f);
    for (int i = 0; i < 6; ++i) s.half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(s.body->GetLinearVelocity().y - before, -1.0f, 1e-4f);  // g for 0.1 s
    EXPECT_EQ(s.joint->GetReactionForce(60.0f).y, 0.0f);
}

TEST(DistanceLaw, StiffnessHelpersGiveTheAskedFrequency) {
    Half<Ours> half;
    Body* a = half.AddBox(0, 0, 0.5f, 0.5f);   // 1 kg
    Body* b = half.AddBox(3, 0, 1.0f, 0.75f);  // 3 kg
    float k = 0, c = 0;
    EXPECT_EQ(LinearStiffness(k, c, 2.0f, 0.5f, a, b), ErrorCode::ok);
    EXPECT_NEAR(k, 0.75f * 16.0f * pi * pi, 1e-3f);  // reduced mass 1·3/4
    EXPECT_NEAR(c, 2.0f * 0.75f * 0.5f * 4.0f * pi, 1e-4f);
    EXPECT_EQ(LinearStiffness(k, c, 2.0f, 0.0f, half.ground, b), ErrorCode::ok);
    EXPECT_NEAR(k, 3.0f * 16.0f * pi * pi, 1e-2f);
    EXPECT_EQ(AngularStiffness(k, c, 1.0f, 1.0f, half.ground, a), ErrorCode::ok);
    EXPECT_NEAR(k, a->GetInertia() * 4.0f * pi * pi, 1e-3f);
    EXPECT_NEAR(c, 2.0f * a->GetInertia() * 2.0f * pi, 1e-4f);
}

TEST(DistanceLaw, TwoAnchorsThatCoincideArePulledApart) {
    Half<Ours> half;
    Body* a = half.AddBox(0, 0, 0.2f, 0.2f);
    Body* b = half.AddBox(1e-6f, 0, 0.2f, 0.2f);
    DistanceJointDef def;
    def.bodyA = a, def.bodyB = b;
    def.length = def.minLength = def.maxLength = 1.0f;
    auto* joint = static_cast<DistanceJoint*>(half.Join(def));
    for (int i = 0; i < 60; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(joint->GetCurrentLength(), 1.0f, linearSlop);
}

}  // namespace
}  // namespace scree::test
