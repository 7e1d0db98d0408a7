// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The motor joint beside Box2D 2.4.1 and against its purpose: the offset is reached if the force suffices.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetLinearOffset().x, joint->GetAngularOffset(), joint->GetMaxForce(),
                              joint->GetMaxTorque(), joint->GetCorrectionFactor()};
};

template <typename Change>
auto Driven(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(0.0f, 0.0f, 0.5f, 0.5f);
        auto* b = half.AddLopsided(2.0f, 0.5f, 0.5f, 0.3f, 0.5f);
        typename H::RevoluteJointDef pivot;
        pivot.Initialize(half.ground, a, P(0.1f, 0.9f));
        half.Join(pivot);
        typename H::MotorJointDef def;
        def.Initialize(a, b);
        def.linearOffset = P(1.0f, 1.0f), def.angularOffset = 1.0f, def.maxForce = 40.0f, def.maxTorque = 10.0f;
        change(def);
        return static_cast<typename H::MotorJoint*>(half.Join(def));
    };
}
constexpr auto plain = [](auto&) {};
constexpr auto weak = [](auto& def) { def.maxForce = 5.0f, def.maxTorque = 0.5f, def.correctionFactor = 0.8f; };

TEST(MotorTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Driven(plain), untouched, values)); }
TEST(MotorTwins, Strong) { ExpectSame(RunTwins({}, Driven(plain), untouched, values)); }
TEST(MotorTwins, StrongCold) { ExpectSame(RunTwins({.warmStarting = false}, Driven(plain), untouched, values)); }
TEST(MotorTwins, Weak) { ExpectSame(RunTwins({.steps = 120}, Driven(weak), untouched, values)); }  // falls away
TEST(MotorTwins, Setters) {
    const auto edit = [](auto& half, auto* joint, int step) {
        using P = typename std::remove_reference_t<decltype(half)>::Point;
        if (step == 60) joint->SetLinearOffset(P(-0.5f, 1.2f));
        if (step == 100) joint->SetAngularOffset(-0.5f);
        if (step == 140) joint->SetMaxForce(25.0f);
        if (step == 160) joint->SetMaxTorque(30.0f);
        if (step == 200) joint->SetCorrectionFactor(0.05f);
    };
    ExpectSame(RunTwins({}, Driven(plain), edit, values));
}

TEST(MotorLaw, ReachesOffsetAndAngleAndCarriesTheWeight) {
    Half<Ours> half;
    Body* body = half.AddBox(0, 0, 0.5f, 0.5f);
    MotorJointDef def;
    def.Initialize(half.ground, body);
    def.linearOffset = {1.0f, 2.0f}, def.angularOffset = 0.5f, def.maxForce = 100.0f, def.maxTorque = 100.0f;
    auto* joint = static_cast<MotorJoint*>(half.Join(def));
    for (int i = 0; i < 300; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(Distance(body->GetPosition(), {1.0f, 2.0f}), 0.0f, 1e-3f);
    EXPECT_NEAR(body->GetAngle(), 0.5f, 1e-3f);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, 10.0f, 1e-2f);
}

}  // namespace
}  // namespace scree::test
