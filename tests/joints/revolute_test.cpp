// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The revolute joint beside Box2D 2.4.1: free, limited, driven, edited, without warm starting.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetJointAngle(), joint->GetJointSpeed(), joint->GetMotorTorque(60.0f) / 30.0f};
};

/// A lopsided bar on the ground's hinge with another on its end; the second hinge is under test.
template <typename Change>
auto Chain(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(1.0f, 0.0f, 0.5f, 0.1f);
        auto* b = half.AddLopsided(2.0f, 0.0f, 0.5f, 0.1f, 0.2f);
        typename H::RevoluteJointDef pivot;
        pivot.Initialize(half.ground, a, P(0.5f, 0.0f));
        half.Join(pivot);
        typename H::RevoluteJointDef def;
        def.Initialize(a, b, P(1.5f, 0.0f));
        def.lowerAngle = -0.5f, def.upperAngle = 0.5f;
        change(def);
        return static_cast<typename H::RevoluteJoint*>(half.Join(def));
    };
}
constexpr auto free = [](auto&) {};
constexpr auto limited = [](auto& def) { def.enableLimit = true; };
constexpr auto locked = [](auto& def) { def.enableLimit = true, def.lowerAngle = def.upperAngle = 0.1f; };
constexpr auto driven = [](auto& def) { def.enableMotor = true, def.motorSpeed = 1.0f, def.maxMotorTorque = 20.0f; };

constexpr auto edits = [](auto&, auto* joint, int step) {
    if (step == 60) joint->EnableMotor(true);
    if (step == 60) joint->SetMotorSpeed(2.0f);
    if (step == 60) joint->SetMaxMotorTorque(30.0f);
    if (step == 120) joint->SetMotorSpeed(-3.0f);
    if (step == 150) joint->EnableLimit(true);
    if (step == 200) joint->SetLimits(-0.2f, 0.1f);
    if (step == 240) joint->EnableMotor(false);
    if (step == 270) joint->EnableLimit(false);
};

TEST(RevoluteTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Chain(limited), untouched, values)); }
TEST(RevoluteTwins, Free) { ExpectSame(RunTwins({}, Chain(free), untouched, values)); }
TEST(RevoluteTwins, Limited) { ExpectSame(RunTwins({}, Chain(limited), untouched, values)); }
TEST(RevoluteTwins, LimitedCold) { ExpectSame(RunTwins({.warmStarting = false}, Chain(limited), untouched, values)); }
TEST(RevoluteTwins, Locked) { ExpectSame(RunTwins({}, Chain(locked), untouched, values)); }
TEST(RevoluteTwins, Driven) { ExpectSame(RunTwins({}, Chain(driven), untouched, values)); }
TEST(RevoluteTwins, Setters) { ExpectSame(RunTwins({}, Chain(limited), edits, values)); }

}  // namespace
}  // namespace scree::test
