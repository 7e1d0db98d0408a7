// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The gear joint beside Box2D 2.4.1, its ratio, and what happens when a joint under it goes.

#include <cmath>
#include <memory>
#include <random>
#include <tuple>
#include <utility>

#include "tests/joints/twins.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

/// A rotor on the ground (revolute) and, in turn, another rotor or a slider, joined by a gear.
template <bool Slider1, bool Slider2>
auto Geared(float ratio) {
    return [ratio](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        const auto mount = [&](auto* body, float x, bool slides) -> typename H::Joint* {
            if (slides) {
                typename H::PrismaticJointDef def;
                def.Initialize(half.ground, body, P(x, 0.2f), P(0.6f, 0.8f));
                return half.Join(def);
            }
            typename H::RevoluteJointDef def;
            def.Initialize(half.ground, body, P(x, 0.2f));
            return half.Join(def);
        };
        auto* a = half.AddLopsided(0.0f, 0.0f, 0.5f, 0.3f);
        auto* b = half.AddLopsided(3.0f, 0.0f, 0.4f, 0.4f, 0.2f);
        typename H::GearJointDef def;
        def.joint1 = mount(a, 0.0f, Slider1);
        def.joint2 = mount(b, 3.0f, Slider2);
        def.bodyA = a, def.bodyB = b;
        def.ratio = ratio;
        return static_cast<typename H::GearJoint*>(half.Join(def));
    };
}
constexpr auto values = [](auto* joint) { return std::vector<float>{joint->GetRatio()}; };

TEST(GearTwins, TwoRotors) { ExpectSame(RunTwins({}, Geared<false, false>(2.0f), untouched, values)); }
TEST(GearTwins, TwoRotorsCold) {
    ExpectSame(RunTwins({.warmStarting = false}, Geared<false, false>(-1.5f), untouched, values));
}
TEST(GearTwins, RackAndPinion) { ExpectSame(RunTwins({}, Geared<false, true>(1.5f), untouched, values)); }
TEST(GearTwins, PinionAndRack) { ExpectSame(RunTwins({}, Geared<true, false>(0.5f), untouched, values)); }
TEST(GearTwins, TwoSliders) { ExpectSame(RunTwins({.steps = 60}, Geared<true, true>(1.5f), untouched, values)); }
TEST(GearTwins, NewRatio) {
    const auto edit = [](auto&, auto* joint, int step) {
        if (step == 100) joint->SetRatio(2.2f);
    };
    ExpectSame(RunTwins({}, Geared<false, false>(2.0f), edit, values));
}

/// Coordinate of a revolute or prismatic joint.
float CoordinateOf(Joint* joint) {
    return joint->GetType() == e_revoluteJoint ? static_cast<RevoluteJoint*>(joint)->GetJointAngle()
                                               : static_cast<PrismaticJoint*>(joint)->GetJointTranslation();
}

template <bool Slider1, bool Slider2>
void ExpectConstantKept(float ratio) {
    Half<Ours> half;
    GearJoint* gear = Geared<Slider1, Slider2>(ratio)(half);
    const float constant = CoordinateOf(gear->GetJoint1()) + ratio * CoordinateOf(gear->GetJoint2());
    float most = 0.0f;
    for (int i = 0; i < 120; ++i) {
        half.world.Step(1.0f / 60.0f, 8, 3);
        const float now = CoordinateOf(gear->GetJoint1()) + ratio * CoordinateOf(gear->GetJoint2());
        ASSERT_NEAR(now, constant, linearSlop);
        most = Max(most, Abs(CoordinateOf(gear->GetJoint1()) - 0.0f));
    }
    EXPECT_GT(most, 0.01f);  // it did move
}

TEST(GearLaw, CoordinatesKeepTheirRatio) {
    ExpectConstantKept<false, false>(2.0f);
    ExpectConstantKept<false, true>(1.5f);
    ExpectConstantKept<true, false>(0.5f);
    ExpectConstantKept<true, true>(1.5f);
}

/// A rotor and a slider on moving carriers (one or two), free in space, joined by a gear.
template <bool OneCarrier>
auto Floating() {
    return [](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        half.world.SetGravity(P(0.0f, 0.0f));
        auto* first = half.AddLopsided(0.0f, 0.0f, 2.0f, 0.3f);
        auto* second = OneCarrier ? first : half.AddLopsided(6.0f, 0.0f, 2.0f, 0.3f);
        const float x = OneCarrier ? 1.0f : 6.0f;
        auto* rotor = half.AddDisk(-1.0f, 0.0f, 0.4f);
        auto* slider = half.AddLopsided(x, 0.0f, 0.4f, 0.4f);
        rotor->SetAngularVelocity(5.0f);
        slider->SetLinearVelocity(P(0.4f, 0.0f));
        typename H::RevoluteJointDef pivot;
        pivot.Initialize(first, rotor, P(-1.0f, 0.0f));
        typename H::PrismaticJointDef rail;
        rail.Initialize(second, slider, P(x, 0.0f), P(1.0f, 0.0f));
        typename H::GearJointDef def;
        def.joint1 = half.Join(pivot);
        def.joint2 = half.Join(rail);
        def.bodyA = rotor, def.bodyB = slider;
        def.ratio = 1.5f;
        return static_cast<typename H::GearJoint*>(half.Join(def));
    };
}

float AngularMomentum(const Half<Ours>& half) {
    float sum = 0.0f;
    for (const Body* body : half.bodies) {
        const float inertia = body->GetInertia() - body->GetMass() * body->GetLocalCenter().LengthSquared();
        sum += body->GetMass() * Cross(body->GetWorldCenter(), body->GetLinearVelocity()) +
               inertia * body->GetAngularVelocity();
    }
    return sum;
}

TEST(GearTwins, OnTwoMovingCarriers) { ExpectSame(RunTwins({}, Floating<false>(), untouched, values)); }

TEST(GearLaw, KeepsMomentumAlsoWhenBothJointsHangOnOneMovingBody) {
    // 2.4.1 loses a share of the impulse on such a carrier (it writes its velocity back twice), ours may not.
    Half<Ours> half;
    Floating<true>()(half);
    const float before = AngularMomentum(half);
    for (int i = 0; i < 120; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_NEAR(AngularMomentum(half), before, 1e-4f * Abs(before));  // float rounding over 120 steps
}

/// A gear train in one world, with the listener's record.
struct Train : DestructionListener {
    Train() {
        gear = Geared<false, true>(1.5f)(half);
        joint1 = gear->GetJoint1();
        joint2 = gear->GetJoint2();
        half.world.SetDestructionListener(this);
    }
    void SayGoodbye(Joint* joint) override { farewells.push_back(joint); }
    void SayGoodbye(Fixture*) override {}
    Half<Ours> half;
    GearJoint* gear;
    Joint *joint1, *joint2;
    std::vector<Joint*> farewells;
};

TEST(GearLifetime, DestroyingAJointUnderItDestroysTheGearFirst) {
    for (const bool first : {true, false}) {
        Train t;
        Joint* victim = first ? t.joint1 : t.joint2;
        Joint* survivor = first ? t.joint2 : t.joint1;
        EXPECT_EQ(t.half.world.DestroyJoint(victim), ErrorCode::ok);
        ASSERT_EQ(t.farewells.size(), 1u);
        EXPECT_EQ(t.farewells[0], t.gear);
        EXPECT_EQ(t.half.world.GetJointCount(), 1);
        EXPECT_EQ(t.half.world.GetJointList(), survivor);
        for (int i = 0; i < 60; ++i) t.half.world.Step(1.0f / 60.0f, 8, 3);
        EXPECT_EQ(t.half.world.DestroyJoint(survivor), ErrorCode::ok);
    }
}

TEST(GearLifetime, DestroyingABodyUnderItDestroysGearAndJoint) {
    for (const size_t which : {size_t{0}, size_t{1}}) {
        Train t;
        EXPECT_EQ(t.half.world.DestroyBody(t.half.bodies[which]), ErrorCode::ok);
        EXPECT_EQ(t.half.world.GetJointCount(), 1);
        EXPECT_EQ(t.farewells.size(), 2u);
        t.half.world.Step(1.0f / 60.0f, 8, 3);
    }
    Train t;
    EXPECT_EQ(t.half.world.DestroyBody(t.half.ground), ErrorCode::ok);  // under both joints, though not of the gear
    EXPECT_EQ(t.half.world.GetJointCount(), 0);
    EXPECT_EQ(t.farewells.size(), 3u);
    t.half.world.Step(1.0f / 60.0f, 8, 3);
}

TEST(GearLifetime, TheGearAloneLeavesItsJointsAlone) {
    Train t;
    EXPECT_EQ(t.half.world.DestroyJoint(t.gear), ErrorCode::ok);
    EXPECT_TRUE(t.farewells.empty());
    EXPECT_EQ(t.half.world.GetJointCount(), 2);
    EXPECT_EQ(t.half.world.DestroyJoint(t.joint1), ErrorCode::ok);
    EXPECT_TRUE(t.farewells.empty());
}

TEST(GearLifetime, TwoGearsOnOneJointBothGo) {
    Train t;
    GearJointDef def;
    def.joint1 = t.joint1, def.joint2 = t.joint2, def.ratio = 1.5f;
    ASSERT_NE(t.half.world.CreateJoint(&def), nullptr);
    EXPECT_EQ(t.half.world.DestroyJoint(t.joint2), ErrorCode::ok);
    EXPECT_EQ(t.farewells.size(), 2u);
    EXPECT_EQ(t.half.world.GetJointCount(), 1);
}

TEST(GearLifetime, ADisabledCarrierSuspendsTheGear) {
    Half<Ours> half;
    GearJoint* gear = Geared<false, false>(2.0f)(half);
    half.ground->SetEnabled(false);
    for (int i = 0; i < 30; ++i) half.world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_EQ(gear->GetReactionTorque(60.0f), 0.0f);
}

/// Gears of different islands may share a disabled carrier, so none of them may write to it. A write of zero turns −0
/// into 0.
TEST(GearLifetime, ADisabledCarrierIsNotWrittenTo) {
    for (const float direction : {-1.0f, 1.0f}) {
        for (const int substeps : {0, 4}) {
            World world(vec2Zero);
            Body* carrier = AddBody(world, dynamicBody, {0.0f, -2.0f});
            AddCircle(carrier, 0.5f);
            GearJointDef def;
            for (int i = 0; i < 2; ++i) {
                Body* slider = AddBody(world, dynamicBody, {4.0f * static_cast<float>(i), 0.0f});
                AddCircle(slider, 0.5f);
                PrismaticJointDef rail;
                rail.Initialize(carrier, slider, slider->GetPosition(), {0.6f * direction, -0.8f * direction});
                (i == 0 ? def.joint1 : def.joint2) = world.CreateJoint(&rail);
                (i == 0 ? def.bodyA : def.bodyB) = slider;
            }
            ASSERT_NE(world.CreateJoint(&def), nullptr);
            StepWith(world, substeps);
            carrier->SetLinearVelocity({-0.0f, -0.0f});
            carrier->SetAngularVelocity(-0.0f);
            carrier->SetEnabled(false);
            ASSERT_TRUE(std::signbit(carrier->GetLinearVelocity().x));
            StepWith(world, substeps);
            EXPECT_TRUE(std::signbit(carrier->GetLinearVelocity().x));
            EXPECT_TRUE(std::signbit(carrier->GetLinearVelocity().y));
            EXPECT_TRUE(std::signbit(carrier->GetAngularVelocity()));
        }
    }
}

/// Two wheels on a static or kinematic ground each. Any of them may be the first body of its joint, so that what the
/// gear is told of first is a ground.
struct Wheels {
    Wheels(bool isFirstA, bool isSecondA, BodyType groundType, float gearRatio) : ratio(gearRatio) {
        GearJointDef def;
        for (int i = 0; i < 2; ++i) {
            const Vec2 place{4.0f * static_cast<float>(i), 0.0f};
            ground[i] = AddBody(world, groundType, place);
            AddCircle(ground[i], 0.5f)->SetSensor(true);
            wheel[i] = AddBody(world, dynamicBody, place);
            AddCircle(wheel[i], 0.5f);
            RevoluteJointDef pivot;
            const bool isA = i == 0 ? isFirstA : isSecondA;
            pivot.Initialize(isA ? wheel[i] : ground[i], isA ? ground[i] : wheel[i], place);
            (i == 0 ? def.joint1 : def.joint2) = world.CreateJoint(&pivot);
            def.bodyA = def.bodyB, def.bodyB = wheel[i];
        }
        def.ratio = ratio;
        gear = static_cast<GearJoint*>(world.CreateJoint(&def));
    }
    [[nodiscard]] float Error() const {
        return CoordinateOf(gear->GetJoint1()) + ratio * CoordinateOf(gear->GetJoint2());
    }

    World world{vec2Zero};
    Body *ground[2], *wheel[2];
    float ratio;
    GearJoint* gear;
};

class GearOfWheels : public testing::TestWithParam<std::tuple<bool, bool, BodyType, int>> {};

TEST_P(GearOfWheels, TurnsBothWhicheverIsTheFirstOfItsJoint) {
    const auto [isFirstA, isSecondA, groundType, substeps] = GetParam();
    std::mt19937 random(std::random_device{}());
    const float ratio = std::uniform_real_distribution<float>(0.5f, 2.0f)(random);
    SCOPED_TRACE(ratio);
    Wheels wheels(isFirstA, isSecondA, groundType, ratio);
    ASSERT_NE(wheels.gear, nullptr);
    EXPECT_EQ(wheels.gear->GetBodyA(), wheels.wheel[0]);
    EXPECT_EQ(wheels.gear->GetBodyB(), wheels.wheel[1]);
    wheels.wheel[0]->SetAngularVelocity(3.0f);
    for (int i = 0; i < 60; ++i) {
        StepWith(wheels.world, substeps);
        ASSERT_NEAR(wheels.Error(), 0.0f, 0.01f) << "step " << i;
    }
    EXPECT_GT(Abs(wheels.wheel[1]->GetAngle()), 0.5f);
    EXPECT_GT(Abs(wheels.wheel[0]->GetAngle()), 0.5f);
}

TEST_P(GearOfWheels, FallsAsleepAndWakesAsOne) {
    const auto [isFirstA, isSecondA, groundType, substeps] = GetParam();
    Wheels wheels(isFirstA, isSecondA, groundType, 1.0f);
    for (int i = 0; i < 60; ++i) StepWith(wheels.world, substeps);
    ASSERT_FALSE(wheels.wheel[0]->IsAwake());
    ASSERT_FALSE(wheels.wheel[1]->IsAwake());
    wheels.wheel[1]->SetAngularVelocity(3.0f);
    StepWith(wheels.world, substeps);
    EXPECT_TRUE(wheels.wheel[0]->IsAwake());
    for (int i = 0; i < 60; ++i) StepWith(wheels.world, substeps);
    EXPECT_NEAR(wheels.Error(), 0.0f, 0.01f);
    EXPECT_GT(Abs(wheels.wheel[0]->GetAngle()), 0.5f);
}

TEST_P(GearOfWheels, TurnsWhateverMovesOnceGroundsAndWheelsHaveSwapped) {
    const auto [isFirstA, isSecondA, groundType, substeps] = GetParam();
    Wheels wheels(isFirstA, isSecondA, groundType, 1.0f);
    const auto swap = [&wheels, type = groundType](int i) {
        wheels.wheel[i]->SetType(type);
        wheels.ground[i]->SetType(dynamicBody);
        std::swap(wheels.wheel[i], wheels.ground[i]);
    };
    swap(0);
    EXPECT_EQ(wheels.gear->GetBodyA(), wheels.wheel[0]);
    swap(1);
    EXPECT_EQ(wheels.gear->GetBodyB(), wheels.wheel[1]);
    for (Body* body : {wheels.wheel[0], wheels.wheel[1], wheels.ground[0], wheels.ground[1]}) {
        int count = 0;
        for (Joint* joint = body->GetJointList(); joint != nullptr; joint = joint->GetNext(body)) ++count;
        EXPECT_EQ(count, body->GetJointCount());
    }
    const std::unique_ptr<World> loaded = LoadWorld(SaveWorld(wheels.world));
    ASSERT_NE(loaded, nullptr);
    EXPECT_EQ(inspect::GetStateHash(*loaded), inspect::GetStateHash(wheels.world));
    wheels.wheel[0]->SetAngularVelocity(3.0f);
    for (int i = 0; i < 60; ++i) StepWith(wheels.world, substeps);
    EXPECT_NEAR(wheels.Error(), 0.0f, 0.01f);
    EXPECT_GT(Abs(wheels.wheel[1]->GetAngle()), 0.5f);
    wheels.world.DestroyJoint(wheels.gear->GetJoint2());  // and the gear with it
    EXPECT_EQ(wheels.world.GetJointCount(), 1);
}

INSTANTIATE_TEST_SUITE_P(All, GearOfWheels,
                         testing::Combine(testing::Bool(), testing::Bool(), testing::Values(staticBody, kinematicBody),
                                          testing::ValuesIn(solvers)));

}  // namespace
}  // namespace scree::test
