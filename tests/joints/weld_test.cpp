// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The weld joint beside Box2D 2.4.1 and against closed forms: rigid and with an angular spring.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetBodyB()->GetAngle() - joint->GetBodyA()->GetAngle(),
                              joint->GetReferenceAngle()};
};

/// A cantilever of three bars; the outer weld is under test.
template <typename Change>
auto Cantilever(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(0.5f, 0.0f, 0.5f, 0.1f);
        auto* b = half.AddLopsided(1.5f, 0.0f, 0.5f, 0.1f, 0.2f);
        typename H::WeldJointDef root;
        root.Initialize(half.ground, a, P(0.0f, 0.0f));
        root.stiffness = 100.0f, root.damping = 2.0f;
        half.Join(root);
        typename H::WeldJointDef def;
        def.Initialize(a, b, P(1.0f, 0.0f));
        change(def);
        return static_cast<typename H::WeldJoint*>(half.Join(def));
    };
}
constexpr auto rigid = [](auto&) {};
constexpr auto soft = [](auto& def) { def.stiffness = 20.0f, def.damping = 0.3f; };

TEST(WeldTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Cantilever(soft), untouched, values)); }
TEST(WeldTwins, Rigid) { ExpectSame(RunTwins({}, Cantilever(rigid), untouched, values)); }
TEST(WeldTwins, RigidCold) { ExpectSame(RunTwins({.warmStarting = false}, Cantilever(rigid), untouched, values)); }
TEST(WeldTwins, Soft) { ExpectSame(RunTwins({}, Cantilever(soft), untouched, values)); }
TEST(WeldTwins, SoftCold) { ExpectSame(RunTwins({.warmStarting = false}, Cantilever(soft), untouched, values)); }
TEST(WeldTwins, Setters) {
    const auto edit = [](auto&, auto* joint, int step) {
        if (step == 80) joint->SetStiffness(60.0f);
        if (step == 120) joint->SetDamping(3.0f);
        if (step == 160) joint->SetStiffness(0.0f);
        if (step == 220) joint->SetStiffness(10.0f);
    };
    ExpectSame(RunTwins({}, Cantilever(soft), edit, values));
}
TEST(WeldTwins, FixedRotation) {
    const auto build = [](auto& half) {
        auto* joint = Cantilever(rigid)(half);
        for (auto* body : half.bodies) body->SetFixedRotation(true);
        return joint;
    };
    ExpectSame(RunTwins({}, build, untouched, values));
}

TEST(WeldLaw, ACantileverCarriesWeightAndMomentOfItsLoad) {
    Half<Ours> half;
    Body* body = half.AddBox(1.0f, 0.0f, 0.5f, 0.5f);
    WeldJointDef def;
    def.Initialize(half.ground, body, {0, 0});
    auto* joint = static_cast<WeldJoint*>(half.Join(def));
    for (int i = 0; i < 20; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(joint->GetReactionForce(60.0f).y, 10.0f, 1e-3f);
    EXPECT_NEAR(joint->GetReactionTorque(60.0f), 10.0f, 1e-3f);  // 10 N at 1 m
}

TEST(WeldLaw, ASoftWeldTurnsByMomentOverStiffness) {
    Half<Ours> half;
    Body* body = half.AddBox(1.0f, 0.0f, 0.5f, 0.5f);
    WeldJointDef def;
    def.Initialize(half.ground, body, {0, 0});
    def.stiffness = 200.0f, def.damping = 40.0f;
    half.Join(def);
    for (int i = 0; i < 600; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(body->GetAngle(), -0.05f, 1e-3f);  // 10 N·m / 200; cos 0.05 costs 0.1 %
}

}  // namespace
}  // namespace scree::test
