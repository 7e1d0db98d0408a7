// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The pulley joint beside Box2D 2.4.1 and against closed forms: Atwood's machine, constant length.

#include "tests/joints/twins.h"

namespace scree::test {
namespace {

constexpr auto values = [](auto* joint) {
    return std::vector<float>{joint->GetCurrentLengthA(), joint->GetCurrentLengthB(), joint->GetLengthA(),
                              joint->GetRatio()};
};

template <typename Change>
auto Rope(Change change) {
    return [change](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* a = half.AddLopsided(-3.0f, 0.0f, 0.5f, 0.5f, 0.3f);
        auto* b = half.AddLopsided(3.0f, -1.0f, 0.4f, 0.5f);
        typename H::PulleyJointDef def;
        def.Initialize(a, b, P(-3.2f, 8.0f), P(3.1f, 9.0f), P(-3.0f, 0.4f), P(2.9f, -0.6f), 1.3f);
        change(def);
        return static_cast<typename H::PulleyJoint*>(half.Join(def));
    };
}
constexpr auto plain = [](auto&) {};
constexpr auto block = [](auto& def) { def.ratio = 2.0f; };

TEST(PulleyTwins, UnevenSteps) { ExpectSame(RunTwins({.uneven = true}, Rope(plain), untouched, values)); }
TEST(PulleyTwins, Plain) { ExpectSame(RunTwins({}, Rope(plain), untouched, values)); }
TEST(PulleyTwins, Cold) { ExpectSame(RunTwins({.warmStarting = false}, Rope(plain), untouched, values)); }
TEST(PulleyTwins, BlockAndTackle) {
    ExpectSame(RunTwins({.steps = 60}, Rope(block), untouched, values));
}  // then A is up

/// Two boxes under their pulleys; densities as given, 1 m² each.
struct Atwood {
    Atwood(float ratio, float densityA, float densityB) {
        a = half.AddBox(-3, 0, 0.5f, 0.5f);
        b = half.AddBox(3, 0, 0.5f, 0.5f);
        a->GetFixtureList()->SetDensity(densityA);
        b->GetFixtureList()->SetDensity(densityB);
        a->ResetMassData();
        b->ResetMassData();
        PulleyJointDef def;
        def.Initialize(a, b, {-3, 20}, {3, 20}, {-3, 0}, {3, 0}, ratio);
        joint = static_cast<PulleyJoint*>(half.Join(def));
    }
    Half<Ours> half;
    Body *a, *b;
    PulleyJoint* joint;
};

TEST(PulleyLaw, AtwoodsMachine) {
    Atwood s(1.0f, 2.0f, 1.0f);
    for (int i = 0; i < 60; ++i) s.half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(s.a->GetLinearVelocity().y, -10.0f / 3.0f, 1e-3f);  // (m1 − m2)·g / (m1 + m2)
    EXPECT_NEAR(s.b->GetLinearVelocity().y, 10.0f / 3.0f, 1e-3f);
    EXPECT_NEAR(s.joint->GetReactionForce(60.0f).Length(), 2.0f * 2.0f * 10.0f / 3.0f, 1e-2f);  // 2·m1·m2·g / (m1 + m2)
}

TEST(PulleyLaw, LengthAPlusRatioTimesLengthBStays) {
    Atwood s(2.0f, 1.2f, 2.0f);
    for (int i = 0; i < 200; ++i) {
        s.half.world.Step(1.0f / 60.0f, 8, 3);
        ASSERT_NEAR(s.joint->GetCurrentLengthA() + 2.0f * s.joint->GetCurrentLengthB(), 60.0f, linearSlop);
    }
    EXPECT_GT(Abs(s.joint->GetCurrentLengthA() - 20.0f), 1.0f);  // it did move
}

TEST(PulleyLaw, ShiftingTheOriginMovesTheGroundAnchors) {
    Atwood s(1.0f, 1.0f, 1.0f);
    s.half.world.ShiftOrigin({10.0f, -5.0f});
    EXPECT_TRUE((s.joint->GetGroundAnchorA() == Vec2{-13.0f, 25.0f}));
    EXPECT_NEAR(s.joint->GetCurrentLengthA(), 20.0f, 1e-5f);
}

}  // namespace
}  // namespace scree::test
