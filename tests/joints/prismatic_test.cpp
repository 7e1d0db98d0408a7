// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The prismatic joint beside Box2D 2.4.1 and against closed forms: free, limited, driven, edited.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetJointTranslation(), joint->GetJointSpeed(),
                              joint->GetMotorForce(60.0f) / 30.0f};
};

/// A slider on a bar that swings on the ground's hinge, so that axis and arms turn.
template <typename Change>
auto Slider(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(1.0f, 0.0f, 1.5f, 0.2f, 0.1f);
        auto* b = half.AddLopsided(1.5f, 0.6f, 0.3f, 0.2f, 0.3f);
        typename H::RevoluteJointDef pivot;
        pivot.Initialize(half.ground, a, P(0.0f, 0.0f));
        half.Join(pivot);
        typename H::PrismaticJointDef def;
        def.Initialize(a, b, P(1.5f, 0.4f), P(0.8f, 0.6f));
        def.lowerTranslation = -0.5f, def.upperTranslation = 0.7f;
        change(def);
        return static_cast<typename H::PrismaticJoint*>(half.Join(def));
    };
}
constexpr auto free = [](auto&) {};
constexpr auto limited = [](auto& def) { def.enableLimit = true; };
constexpr auto locked = [](auto& def) { def.enableLimit = true, def.lowerTranslation = def.upperTranslation = 0.0f; };
constexpr auto driven = [](auto& def) {
    def.enableMotor = true, def.motorSpeed = 0.3f, def.maxMotorForce = 8.0f, def.enableLimit = true;
};

constexpr auto edits = [](auto&, auto* joint, int step) {
    if (step == 60) joint->EnableMotor(true);
    if (step == 60) joint->SetMotorSpeed(2.0f);
    if (step == 60) joint->SetMaxMotorForce(30.0f);
    if (step == 120) joint->SetMotorSpeed(-3.0f);
    if (step == 150) joint->EnableLimit(true);
    if (step == 200) joint->SetLimits(-0.2f, 0.1f);
    if (step == 240) joint->EnableMotor(false);
    if (step == 270) joint->EnableLimit(false);
};

TEST(PrismaticTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Slider(limited), untouched, values)); }
TEST(PrismaticTwins, Free) {
    ExpectSame(RunTwins({.steps = 60}, Slider(free), untouched, values));
}  // then it is far away
TEST(PrismaticTwins, Limited) { ExpectSame(RunTwins({}, Slider(limited), untouched, values)); }
TEST(PrismaticTwins, LimitedCold) { ExpectSame(RunTwins({.warmStarting = false}, Slider(limited), untouched, values)); }
TEST(PrismaticTwins, Locked) { ExpectSame(RunTwins({}, Slider(locked), untouched, values)); }
TEST(PrismaticTwins, Driven) { ExpectSame(RunTwins({}, Slider(driven), untouched, values)); }
TEST(PrismaticTwins, Setters) { ExpectSame(RunTwins({}, Slider(limited), edits, values)); }

/// A box of 1 kg on a slope of 30°.
struct Slope {
    Slope() {
        body = half.AddBox(0.0f, 0.0f, 0.5f, 0.5f);
        PrismaticJointDef def;
        def.Initialize(half.ground, body, {0.0f, 0.0f}, {std::sqrt(0.75f), 0.5f});
        joint = static_cast<PrismaticJoint*>(half.Join(def));
    }
    void Step(int steps) {
        for (int i = 0; i < steps; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    }
    Half<Ours> half;
    Body* body;
    PrismaticJoint* joint;
};

TEST(PrismaticLaw, SlidesDownTheAxisAtGSineAndStaysOnIt) {
    Slope s;
    s.Step(60);
    // Semi-implicit Euler: after n steps the way is g·sin·dt²·n(n+1)/2.
    EXPECT_NEAR(s.joint->GetJointTranslation(), -5.0f * 60.0f * 61.0f / 2.0f / 3600.0f, 1e-3f);
    EXPECT_NEAR(s.joint->GetJointSpeed(), -5.0f, 1e-3f);
    EXPECT_NEAR(Cross(Vec2{std::sqrt(0.75f), 0.5f}, s.body->GetPosition()), 0.0f, linearSlop);
    EXPECT_NEAR(s.body->GetAngle(), 0.0f, 1e-4f);
    EXPECT_NEAR(s.joint->GetReactionForce(60.0f).Length(), 10.0f * std::sqrt(0.75f), 1e-2f);  // weight across the slope
}

TEST(PrismaticLaw, AMotorHoldsUpToItsForceAndALimitTakesTheRest) {
    Slope s;
    s.joint->EnableMotor(true);
    s.joint->SetMaxMotorForce(3.0f);  // of the 5 N down the slope
    s.joint->EnableLimit(true);
    s.joint->SetLimits(-0.25f, 1.0f);
    s.Step(10);
    EXPECT_NEAR(s.joint->GetMotorForce(60.0f), 3.0f, 1e-4f);
    EXPECT_NEAR(s.joint->GetJointSpeed(), -2.0f * 10.0f / 60.0f, 1e-4f);  // 2 N are left for 1 kg
    s.Step(230);
    EXPECT_NEAR(s.joint->GetJointTranslation(), -0.25f, linearSlop);
    EXPECT_LE(Abs(s.joint->GetMotorForce(60.0f)), 3.001f);  // at rest, motor and limit share the load in any proportion
    EXPECT_NEAR(s.joint->GetReactionForce(60.0f).y, 10.0f, 1e-2f);
}

TEST(PrismaticLaw, ARangeOfASingleValueIsHeldThere) {
    // 2.4.1 pulls such a joint to 0 in the position iterations, whatever the value; ours keeps the value.
    Slope s;
    s.joint->SetLimits(-0.3f, -0.3f);
    s.joint->EnableLimit(true);
    s.Step(120);
    EXPECT_NEAR(s.joint->GetJointTranslation(), -0.3f, linearSlop);
}

TEST(PrismaticLaw, AnAxisOfAnyLengthIsNormalised) {
    Half<Ours> half;
    Body* body = half.AddBox(0, 0, 0.5f, 0.5f);
    PrismaticJointDef def;
    def.bodyA = half.ground, def.bodyB = body;
    def.localAxisA = {3.0f, 4.0f};
    auto* joint = static_cast<PrismaticJoint*>(half.Join(def));
    EXPECT_NEAR(joint->GetLocalAxisA().x, 0.6f, 1e-6f);
    EXPECT_NEAR(joint->GetLocalAxisA().y, 0.8f, 1e-6f);
}

}  // namespace
}  // namespace scree::test
