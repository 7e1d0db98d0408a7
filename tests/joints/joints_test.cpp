// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What all joints share: lists of world and bodies, waking, collideConnected, handles after destruction, origin shifts,
// extreme input, many joints at once.

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/joints/twins.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

Joint* Weld(World& world, Body* a, Body* b) {
    WeldJointDef def;
    def.Initialize(a, b, 0.5f * (a->GetPosition() + b->GetPosition()));
    return world.CreateJoint(&def);
}

std::vector<Joint*> ListOf(Body* body) {
    std::vector<Joint*> joints;
    for (Joint* j = body->GetJointList(); j != nullptr; j = j->GetNext(body)) joints.push_back(j);
    return joints;
}

TEST(JointLists, OfABodyAreNewestFirstThroughAnyEdits) {
    EXPECT_TRUE(rc::check("lists equal a plain model", [] {
        World world({0, 0});
        std::vector<Body*> bodies;
        for (int i = 0; i < 5; ++i) bodies.push_back(AddBody(world, dynamicBody, {static_cast<float>(i), 0}));
        std::vector<Joint*> model;  // oldest first
        for (const uint8_t edit : *rc::gen::container<std::vector<uint8_t>>(rc::gen::arbitrary<uint8_t>())) {
            const size_t a = edit % 5, b = (a + 1 + (edit / 5) % 4) % 5;
            if (edit < 170 || model.empty()) {
                model.push_back(Weld(world, bodies[a], bodies[b]));
            } else {
                const size_t victim = edit % model.size();
                world.DestroyJoint(model[victim]);
                model.erase(model.begin() + static_cast<std::ptrdiff_t>(victim));
            }
        }
        std::vector<Joint*> all;
        for (Joint* j = world.GetJointList(); j != nullptr; j = j->GetNext()) all.push_back(j);
        std::reverse(all.begin(), all.end());
        RC_ASSERT(all == model);
        for (Body* body : bodies) {
            std::vector<Joint*> expected;
            for (Joint* j : model) {
                if (j->GetBodyA() == body || j->GetBodyB() == body) expected.insert(expected.begin(), j);
            }
            RC_ASSERT(ListOf(body) == expected);
            RC_ASSERT(body->GetJointCount() == static_cast<int>(expected.size()));
            for (Joint* j : expected) RC_ASSERT(j->GetOther(body) != body);
        }
    }));
}

TEST(JointLists, DestroyingABodyTakesItsJointsOutOfTheOthersLists) {
    World world({0, 0});
    Body* hub = AddBody(world, dynamicBody, {0, 0});
    Body* rim[3];
    for (int i = 0; i < 3; ++i) {
        rim[i] = AddBody(world, dynamicBody, {1.0f + static_cast<float>(i), 0});
        Weld(world, hub, rim[i]);
    }
    Joint* kept = Weld(world, rim[0], rim[1]);
    world.DestroyBody(hub);
    EXPECT_EQ(world.GetJointCount(), 1);
    EXPECT_EQ(ListOf(rim[0]), std::vector<Joint*>{kept});
    EXPECT_TRUE(ListOf(rim[2]).empty());
}

TEST(JointHandles, OneJointAfterAnotherUsesItsSlotWithoutItsState) {
    World world({0, -10});
    Body* a = AddBody(world, staticBody, {0, 0});
    Body* b = AddBody(world, dynamicBody, {1, 0});
    AddBox(b, 0.2f, 0.2f);
    Joint* first = Weld(world, a, b);
    first->SetUserData({7});
    StepFor(world, 5);
    EXPECT_GT(first->GetReactionForce(60.0f).Length(), 0.1f);
    world.DestroyJoint(first);
    Joint* second = Weld(world, a, b);
    EXPECT_EQ(second->GetReactionForce(60.0f).Length(), 0.0f);
    EXPECT_EQ(second->GetUserData().pointer, 0u);
    EXPECT_EQ(second->GetType(), e_weldJoint);
}

TEST(JointCollision, ConnectedBodiesCollideOnlyIfToldTo) {
    for (const bool collide : {false, true}) {
        World world({0, 0});
        Body* a = AddBody(world, dynamicBody, {0, 0});
        Body* b = AddBody(world, dynamicBody, {0.5f, 0});
        AddBox(a, 0.5f, 0.5f);
        AddBox(b, 0.5f, 0.5f);
        WeldJointDef def;
        def.Initialize(a, b, {0.25f, 0});
        def.collideConnected = collide;
        Joint* joint = world.CreateJoint(&def);
        EXPECT_EQ(StepFor(world, 2).touchingCount > 0, collide);
        world.DestroyJoint(joint);
        EXPECT_GT(StepFor(world, 2).touchingCount, 0);
    }
}

TEST(JointWaking, DestroyingWakesBothAndCreatingWakesNone) {
    World world({0, 0});
    Body* a = AddBody(world, dynamicBody, {0, 0});
    Body* b = AddBody(world, dynamicBody, {1, 0});
    a->SetAwake(false);
    b->SetAwake(false);
    Joint* joint = Weld(world, a, b);
    EXPECT_FALSE(a->IsAwake() || b->IsAwake());
    world.DestroyJoint(joint);
    EXPECT_TRUE(a->IsAwake() && b->IsAwake());
}

/// True if the edit wakes both bodies of a sleeping pair joined by `def`.
template <typename J, typename Def, typename Edit>
bool Wakes(Def def, Edit edit) {
    World world({0, 0});
    Body* a = AddBody(world, dynamicBody, {0, 0});
    Body* b = AddBody(world, dynamicBody, {1, 0});
    def.bodyA = a, def.bodyB = b;
    auto* joint = static_cast<J*>(world.CreateJoint(&def));
    a->SetAwake(false);
    b->SetAwake(false);
    edit(joint);
    EXPECT_EQ(a->IsAwake(), b->IsAwake());
    return b->IsAwake();
}

template <typename J, typename Def>
void ExpectLimitAndMotorSettersWakeOnAChange() {
    EXPECT_TRUE((Wakes<J>(Def(), [](J* j) { j->EnableLimit(true); })));
    EXPECT_FALSE((Wakes<J>(Def(), [](J* j) { j->EnableLimit(false); })));
    EXPECT_TRUE((Wakes<J>(Def(), [](J* j) { j->SetLimits(-1, 1); })));
    EXPECT_FALSE((Wakes<J>(Def(), [](J* j) { j->SetLimits(0, 0); })));
    EXPECT_TRUE((Wakes<J>(Def(), [](J* j) { j->EnableMotor(true); })));
    EXPECT_FALSE((Wakes<J>(Def(), [](J* j) { j->EnableMotor(false); })));
    EXPECT_TRUE((Wakes<J>(Def(), [](J* j) { j->SetMotorSpeed(1); })));
    EXPECT_FALSE((Wakes<J>(Def(), [](J* j) { j->SetMotorSpeed(0); })));
}

TEST(JointWaking, SettersWakeAsInBox2d) {
    ExpectLimitAndMotorSettersWakeOnAChange<RevoluteJoint, RevoluteJointDef>();
    ExpectLimitAndMotorSettersWakeOnAChange<PrismaticJoint, PrismaticJointDef>();
    ExpectLimitAndMotorSettersWakeOnAChange<WheelJoint, WheelJointDef>();
    EXPECT_TRUE((Wakes<RevoluteJoint>(RevoluteJointDef(), [](auto* j) { j->SetMaxMotorTorque(1); })));
    EXPECT_TRUE((Wakes<PrismaticJoint>(PrismaticJointDef(), [](auto* j) { j->SetMaxMotorForce(1); })));
    EXPECT_TRUE((Wakes<WheelJoint>(WheelJointDef(), [](auto* j) { j->SetMaxMotorTorque(1); })));
    EXPECT_FALSE((Wakes<WheelJoint>(WheelJointDef(), [](auto* j) { j->SetStiffness(1), j->SetDamping(1); })));
    EXPECT_TRUE((Wakes<MotorJoint>(MotorJointDef(), [](auto* j) { j->SetLinearOffset({1, 0}); })));
    EXPECT_TRUE((Wakes<MotorJoint>(MotorJointDef(), [](auto* j) { j->SetAngularOffset(1); })));
    EXPECT_FALSE((Wakes<MotorJoint>(MotorJointDef(), [](auto* j) { j->SetMaxForce(9), j->SetMaxTorque(9); })));
    EXPECT_FALSE((Wakes<FrictionJoint>(FrictionJointDef(), [](auto* j) { j->SetMaxForce(9), j->SetMaxTorque(9); })));
    EXPECT_FALSE((Wakes<DistanceJoint>(DistanceJointDef(), [](auto* j) { j->SetLength(9), j->SetMaxLength(9); })));
    EXPECT_FALSE((Wakes<WeldJoint>(WeldJointDef(), [](auto* j) { j->SetStiffness(9), j->SetDamping(9); })));
}

TEST(JointOrigin, AShiftedWorldGoesOnTheSame) {
    const auto run = [](bool shift) {
        World world({0, -10});
        Body* ground = AddBody(world, staticBody, {0, 0});
        Body* a = AddBody(world, dynamicBody, {-2, 0});
        Body* b = AddBody(world, dynamicBody, {2, 0});
        AddBox(a, 0.5f, 0.5f);
        AddBox(b, 0.5f, 0.4f);
        PulleyJointDef pulley;
        pulley.Initialize(a, b, {-2, 8}, {2, 8}, {-2, 0.5f}, {2, 0.5f}, 1.0f);
        world.CreateJoint(&pulley);
        MouseJointDef mouse;
        mouse.bodyA = ground, mouse.bodyB = a, mouse.target = {-2, 0.2f}, mouse.maxForce = 50, mouse.stiffness = 20;
        auto* held = static_cast<MouseJoint*>(world.CreateJoint(&mouse));
        held->SetTarget({-1.5f, 0.5f});
        StepFor(world, 30);
        if (shift) world.ShiftOrigin({16.0f, -8.0f});
        StepFor(world, 60);
        return a->GetPosition() + (shift ? Vec2{16.0f, -8.0f} : vec2Zero);
    };
    EXPECT_LT(Distance(run(false), run(true)), 1e-4f);  // coordinates near 16 have 16 times coarser floats
}

TEST(JointExtremes, JointsNeverLeaveABodyNonFinite) {
    World world({0, -10});
    Body* ground = AddBody(world, staticBody, {0, 0});
    std::vector<Body*> bodies;
    for (int i = 0; i < 6; ++i) {
        bodies.push_back(AddBody(world, dynamicBody, {static_cast<float>(i), 0}));
        AddBox(bodies.back(), 0.2f, 0.2f, i % 2 == 0 ? 1e-8f : 1e8f);
    }
    DistanceJointDef spring;
    spring.Initialize(ground, bodies[0], {0, 0}, {0.1f, 0});
    spring.minLength = 0, spring.maxLength = 1e30f, spring.stiffness = 1e30f, spring.damping = 1e30f;
    world.CreateJoint(&spring);
    for (size_t i = 1; i < bodies.size(); ++i) {
        RevoluteJointDef def;
        def.Initialize(bodies[i - 1], bodies[i], {1e18f, 1e18f});
        def.enableMotor = true, def.motorSpeed = 1e30f, def.maxMotorTorque = 1e38f;
        world.CreateJoint(&def);
    }
    for (int i = 0; i < 60; ++i) {
        StepFor(world, 1);
        for (const Body* body : bodies) {
            ASSERT_TRUE(body->GetPosition().IsValid() && std::isfinite(body->GetAngle()));
            ASSERT_TRUE(body->GetLinearVelocity().IsValid());
        }
        ASSERT_TRUE((ground->GetPosition() == vec2Zero) && (ground->GetLinearVelocity() == vec2Zero));
    }
}

TEST(JointOrder, ChainsOfMixedJointsAgreeWithBox2d) {
    // Runs of several types in one island: the order of solving decides the last digits and more, so it must be
    // Box2D's.
    const auto build = [](auto& half) {
        using H = std::remove_reference_t<decltype(half)>;
        using P = typename H::Point;
        auto* previous = half.ground;
        typename H::Joint* last = nullptr;
        for (int i = 0; i < 8; ++i) {
            const float x = static_cast<float>(i);
            auto* body = half.AddBox(x + 0.5f, 0.0f, 0.4f, 0.1f);
            if (i % 3 == 1) {
                typename H::WeldJointDef def;
                def.Initialize(previous, body, P(x, 0.0f));
                def.stiffness = 30.0f, def.damping = 1.0f;
                last = half.Join(def);
            } else if (i % 3 == 2) {
                typename H::DistanceJointDef def;
                def.Initialize(previous, body, P(x - 0.1f, 0.0f), P(x + 0.1f, 0.0f));
                last = half.Join(def);
            } else {
                typename H::RevoluteJointDef def;
                def.Initialize(previous, body, P(x, 0.0f));
                last = half.Join(def);
            }
            previous = body;
        }
        return last;
    };
    const auto values = [](auto*) { return std::vector<float>{}; };
    ExpectSame(RunTwins({}, build, untouched, values));
}

/// Joints of a type between bodies that no impulse moves, with anchors and speeds of any size.
class Unmovable {
public:
    explicit Unmovable(unsigned seed) : m_random(seed), m_world({0.0f, -10.0f}) {
        for (Body*& body : m_bodies) {
            BodyDef def;
            def.type = m_random() % 2 == 0 ? kinematicBody : dynamicBody;
            def.position = {Any(3.0f), Any(3.0f)};
            def.linearVelocity = {Any(4.0f), Any(4.0f)};
            def.angularVelocity = Any(2.0f);
            def.locks = {true, true, true};
            body = m_world.CreateBody(&def);
        }
    }

    template <typename Def, typename... Anchors>
    void Add(Def def, Anchors Def::*... anchors) {
        def.bodyA = m_bodies[0], def.bodyB = m_bodies[1];
        ((def.*anchors = {Any(38.0f), Any(38.0f)}), ...);
        m_world.CreateJoint(&def);  // it may be refused
    }
    void AddAll() {
        const bool flips = m_random() % 2 == 0;
        Add(RevoluteJointDef{}, &RevoluteJointDef::localAnchorA, &RevoluteJointDef::localAnchorB);
        PrismaticJointDef slide;
        slide.enableLimit = slide.enableMotor = flips;
        slide.maxMotorForce = 10.0f;
        Add(slide, &PrismaticJointDef::localAnchorA, &PrismaticJointDef::localAnchorB);
        WheelJointDef wheel;
        wheel.stiffness = flips ? 10.0f : 0.0f;
        wheel.enableLimit = wheel.enableMotor = flips;
        wheel.maxMotorTorque = 10.0f;
        Add(wheel, &WheelJointDef::localAnchorA, &WheelJointDef::localAnchorB);
        DistanceJointDef distance;
        distance.stiffness = flips ? 10.0f : 0.0f;
        Add(distance, &DistanceJointDef::localAnchorA, &DistanceJointDef::localAnchorB);
        WeldJointDef weld;
        weld.stiffness = flips ? 10.0f : 0.0f;
        Add(weld, &WeldJointDef::localAnchorA, &WeldJointDef::localAnchorB);
        PulleyJointDef pulley;
        pulley.ratio = std::abs(Any(30.0f)) + 0.1f;
        Add(pulley, &PulleyJointDef::localAnchorA, &PulleyJointDef::localAnchorB);
        FrictionJointDef friction;
        friction.maxForce = friction.maxTorque = 10.0f;
        Add(friction, &FrictionJointDef::localAnchorA, &FrictionJointDef::localAnchorB);
        MotorJointDef motor;
        motor.maxForce = motor.maxTorque = 10.0f;
        Add(motor, &MotorJointDef::linearOffset);
    }
    World& GetWorld() { return m_world; }

private:
    /// Of either sign, and any size up to ten to that power.
    float Any(float power) {
        const float exponent = std::uniform_real_distribution<float>(-2.0f, power)(m_random);
        return (m_random() % 2 == 0 ? 1.0f : -1.0f) * std::pow(10.0f, exponent);
    }

    std::mt19937 m_random;
    World m_world;
    Body* m_bodies[2] = {};
};

TEST(JointReactions, AreNumbersWhereNoImpulseMovesAnything) {
    std::mt19937 seeds(std::random_device{}());
    int joints = 0;
    for (int round = 0; round < 400; ++round) {
        const unsigned seed = seeds();
        SCOPED_TRACE("seed " + std::to_string(seed));
        Unmovable pair(seed);
        pair.AddAll();
        World& world = pair.GetWorld();
        joints += world.GetJointCount();
        for (int i = 0; i < 4; ++i) round % 2 == 0 ? world.Step(frame, 8, 3) : world.Step(frame, 4);
        for (const Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext()) {
            const bool isNumber =
                joint->GetReactionForce(1.0f).IsValid() && std::isfinite(joint->GetReactionTorque(1.0f));
            EXPECT_TRUE(isNumber) << "type " << int{joint->GetType()};
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(joints, 2000);
}

}  // namespace
}  // namespace scree::test
