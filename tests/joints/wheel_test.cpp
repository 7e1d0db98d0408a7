// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The wheel joint beside Box2D 2.4.1 and against closed forms: spring, limits, motor.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetJointTranslation(), joint->GetJointLinearSpeed(), joint->GetJointAngle(),
                              joint->GetJointAngularSpeed(), joint->GetMotorTorque(60.0f) / 30.0f};
};

/// A wheel under a swinging bar.
template <typename Change>
auto Suspension(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(1.0f, 0.0f, 1.5f, 0.2f, 0.1f);
        auto* b = half.AddLopsided(1.5f, -0.6f, 0.3f, 0.3f);
        typename H::RevoluteJointDef pivot;
        pivot.Initialize(half.ground, a, P(0.0f, 0.0f));
        half.Join(pivot);
        typename H::WheelJointDef def;
        def.Initialize(a, b, P(1.5f, -0.6f), P(0.1f, 0.99498744f));
        def.stiffness = 30.0f, def.damping = 1.0f;
        def.lowerTranslation = -0.25f, def.upperTranslation = 0.25f;
        change(def);
        return static_cast<typename H::WheelJoint*>(half.Join(def));
    };
}
constexpr auto sprung = [](auto&) {};
constexpr auto limited = [](auto& def) { def.enableLimit = true, def.stiffness = 5.0f; };
constexpr auto unsprung = [](auto& def) { def.enableLimit = true, def.stiffness = 0.0f; };
constexpr auto driven = [](auto& def) { def.enableMotor = true, def.motorSpeed = 5.0f, def.maxMotorTorque = 0.5f; };

constexpr auto edits = [](auto&, auto* joint, int step) {
    if (step == 60) joint->EnableMotor(true);
    if (step == 60) joint->SetMotorSpeed(2.0f);
    if (step == 60) joint->SetMaxMotorTorque(30.0f);
    if (step == 120) joint->SetMotorSpeed(-3.0f);
    if (step == 150) joint->EnableLimit(true);
    if (step == 200) joint->SetLimits(-0.2f, 0.1f);
    if (step == 240) joint->EnableMotor(false);
    if (step == 270) joint->EnableLimit(false);
    if (step == 100) joint->SetStiffness(60.0f);
    if (step == 130) joint->SetDamping(4.0f);
};

TEST(WheelTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Suspension(limited), untouched, values)); }
TEST(WheelTwins, Sprung) { ExpectSame(RunTwins({}, Suspension(sprung), untouched, values)); }
TEST(WheelTwins, SprungCold) { ExpectSame(RunTwins({.warmStarting = false}, Suspension(sprung), untouched, values)); }
TEST(WheelTwins, Limited) { ExpectSame(RunTwins({}, Suspension(limited), untouched, values)); }
TEST(WheelTwins, Unsprung) { ExpectSame(RunTwins({}, Suspension(unsprung), untouched, values)); }
TEST(WheelTwins, Driven) { ExpectSame(RunTwins({}, Suspension(driven), untouched, values)); }
TEST(WheelTwins, Setters) { ExpectSame(RunTwins({}, Suspension(limited), edits, values)); }

TEST(WheelLaw, TheSpringSagsByWeightOverStiffness) {
    Half<Ours> half;
    Body* wheel = half.AddBox(0, 0, 0.5f, 0.5f);
    WheelJointDef def;
    def.Initialize(half.ground, wheel, {0, 0}, {0, 1});
    def.stiffness = 50.0f, def.damping = 10.0f;
    auto* joint = static_cast<WheelJoint*>(half.Join(def));
    for (int i = 0; i < 600; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(joint->GetJointTranslation(), -10.0f / 50.0f, 1e-3f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, 10.0f, 0.05f);
}

TEST(WheelLaw, ARangeOfASingleValueIsHeldThere) {
    // 2.4.1 pulls such a joint to 0 in the position iterations, whatever the value; ours keeps the value.
    Half<Ours> half;
    Body* wheel = half.AddBox(0, 0, 0.5f, 0.5f);
    WheelJointDef def;
    def.Initialize(half.ground, wheel, {0, 0}, {0, 1});
    def.enableLimit = true, def.lowerTranslation = def.upperTranslation = -0.3f;
    auto* joint = static_cast<WheelJoint*>(half.Join(def));
    for (int i = 0; i < 120; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(joint->GetJointTranslation(), -0.3f, linearSlop);
}

TEST(WheelLaw, TheMotorSpeedsUpByTorqueOverInertia) {
    Half<Ours> half;
    Body* wheel = half.AddBox(0, 0, 0.5f, 0.5f);
    WheelJointDef def;
    def.Initialize(half.ground, wheel, {0, 0}, {0, 1});
    def.stiffness = 50.0f, def.damping = 10.0f, def.enableMotor = true, def.motorSpeed = 100.0f,
    def.maxMotorTorque = 0.5f;
    auto* joint = static_cast<WheelJoint*>(half.Join(def));
    for (int i = 0; i < 60; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(joint->GetJointAngularSpeed(), 0.5f / wheel->GetInertia(), 1e-3f);
    EXPECT_NEAR(joint->GetMotorTorque(60.0f), 0.5f, 1e-5f);
}

}  // namespace
}  // namespace scree::test
