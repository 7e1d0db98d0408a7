// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every field of every joint definition and every argument of every setter: bad values are refused with the field's
// name and change nothing.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

class JointBadInput : public ::testing::Test {
protected:
    JointBadInput() : world({0.0f, -10.0f}), errors(world) {
        a = AddBody(world, dynamicBody, {0, 5});
        AddBox(a, 0.5f, 0.5f);
        b = AddBody(world, dynamicBody, {2, 5});
        AddBox(b, 0.5f, 0.5f);
        ground = AddBody(world, staticBody, {0, 0});
    }

    /// The action must be refused once, naming `field`, and leave every bit as it was.
    void ExpectRefused(ErrorCode code, const char* field, const std::function<void()>& action) {
        const uint64_t before = inspect::GetStateHash(world);
        const int joints = world.GetJointCount(), count = errors.count;
        action();
        EXPECT_EQ(errors.count, count + 1) << field;
        EXPECT_EQ(errors.last.code, code) << field << ": " << GetName(errors.last.code);
        EXPECT_STREQ(errors.last.field, field);
        EXPECT_GT(std::strlen(errors.last.cure), 0u);
        EXPECT_EQ(inspect::GetStateHash(world), before) << field;
        EXPECT_EQ(world.GetJointCount(), joints);
    }

    template <typename Def>
    [[nodiscard]] Def Valid() const {
        Def def;
        def.bodyA = a;
        def.bodyB = b;
        return def;
    }

    /// A definition with one change must be refused.
    template <typename Def, typename Change>
    void Refuse(ErrorCode code, const char* field, Change change) {
        ExpectRefused(code, field, [&] {
            Def def = Valid<Def>();
            change(def);
            EXPECT_EQ(world.CreateJoint(&def), nullptr);
        });
    }
    template <typename Def>
    void RefuseNumber(const char* field, float Def::*member, bool mayBeNegative) {
        for (const float bad : {nan, infinity, -infinity}) {
            Refuse<Def>(ErrorCode::nonFinite, field, [&](Def& def) { def.*member = bad; });
        }
        if (!mayBeNegative) Refuse<Def>(ErrorCode::outOfRange, field, [&](Def& def) { def.*member = -1.0f; });
    }
    template <typename Def>
    void RefuseVector(const char* field, Vec2 Def::*member) {
        Refuse<Def>(ErrorCode::nonFinite, field, [&](Def& def) { def.*member = {nan, 0.0f}; });
        Refuse<Def>(ErrorCode::nonFinite, field, [&](Def& def) { def.*member = {0.0f, infinity}; });
    }
    /// Bodies: null, the same twice, of another world, dead.
    template <typename Def>
    void RefuseBodies() {
        Refuse<Def>(ErrorCode::nullArgument, "JointDef::bodyA", [](Def& def) { def.bodyA = nullptr; });
        Refuse<Def>(ErrorCode::nullArgument, "JointDef::bodyB", [](Def& def) { def.bodyB = nullptr; });
        Refuse<Def>(ErrorCode::outOfRange, "JointDef::bodyB", [](Def& def) { def.bodyB = def.bodyA; });
        World other({0, 0});
        Body* foreign = AddBody(other, dynamicBody, {0, 0});
        Refuse<Def>(ErrorCode::foreignHandle, "JointDef::bodyA", [&](Def& def) { def.bodyA = foreign; });
        Refuse<Def>(ErrorCode::foreignHandle, "JointDef::bodyB", [&](Def& def) { def.bodyB = foreign; });
        Body* dead = AddBody(world, dynamicBody, {9, 9});
        world.DestroyBody(dead);
        Refuse<Def>(ErrorCode::foreignHandle, "JointDef::bodyB", [&](Def& def) { def.bodyB = dead; });
    }
    template <typename Def>
    auto* Make() {
        Def def = Valid<Def>();
        return world.CreateJoint(&def);
    }
    /// A setter of one number.
    template <typename Setter>
    void RefuseSetter(const char* field, bool mayBeNegative, Setter set) {
        for (const float bad : {nan, infinity, -infinity}) {
            ExpectRefused(ErrorCode::nonFinite, field, [&] { EXPECT_EQ(set(bad), ErrorCode::nonFinite); });
        }
        if (!mayBeNegative) {
            ExpectRefused(ErrorCode::outOfRange, field, [&] { EXPECT_EQ(set(-1.0f), ErrorCode::outOfRange); });
        }
    }
    template <typename J>
    void RefuseLimitSetters(J* joint) {
        RefuseSetter("lower", true, [&](float x) { return joint->SetLimits(x, 1.0f); });
        RefuseSetter("upper", true, [&](float x) { return joint->SetLimits(0.0f, x); });
        ExpectRefused(ErrorCode::outOfRange, "lower", [&] { joint->SetLimits(1.0f, 0.0f); });
        RefuseSetter("speed", true, [&](float x) { return joint->SetMotorSpeed(x); });
    }
    template <typename J>
    void RefuseSpringSetters(J* joint) {
        RefuseSetter("stiffness", false, [&](float x) { return joint->SetStiffness(x); });
        RefuseSetter("damping", false, [&](float x) { return joint->SetDamping(x); });
    }

    World world;
    ErrorLog errors;
    Body *a, *b, *ground;
};

TEST_F(JointBadInput, Revolute) {
    using D = RevoluteJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("RevoluteJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("RevoluteJointDef::localAnchorB", &D::localAnchorB);
    RefuseNumber<D>("RevoluteJointDef::referenceAngle", &D::referenceAngle, true);
    RefuseNumber<D>("RevoluteJointDef::lowerAngle", &D::lowerAngle, true);
    RefuseNumber<D>("RevoluteJointDef::upperAngle", &D::upperAngle, true);
    Refuse<D>(ErrorCode::outOfRange, "RevoluteJointDef::lowerAngle", [](D& def) { def.lowerAngle = 1.0f; });
    RefuseNumber<D>("RevoluteJointDef::motorSpeed", &D::motorSpeed, true);
    RefuseNumber<D>("RevoluteJointDef::maxMotorTorque", &D::maxMotorTorque, false);
    auto* joint = static_cast<RevoluteJoint*>(Make<D>());
    RefuseLimitSetters(joint);
    RefuseSetter("torque", false, [&](float x) { return joint->SetMaxMotorTorque(x); });
}

TEST_F(JointBadInput, Prismatic) {
    using D = PrismaticJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("PrismaticJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("PrismaticJointDef::localAnchorB", &D::localAnchorB);
    RefuseVector<D>("PrismaticJointDef::localAxisA", &D::localAxisA);
    Refuse<D>(ErrorCode::outOfRange, "PrismaticJointDef::localAxisA", [](D& def) { def.localAxisA = {0, 0}; });
    Refuse<D>(ErrorCode::outOfRange, "PrismaticJointDef::localAxisA", [](D& def) { def.localAxisA = {1e30f, 0}; });
    RefuseNumber<D>("PrismaticJointDef::referenceAngle", &D::referenceAngle, true);
    RefuseNumber<D>("PrismaticJointDef::lowerTranslation", &D::lowerTranslation, true);
    RefuseNumber<D>("PrismaticJointDef::upperTranslation", &D::upperTranslation, true);
    Refuse<D>(ErrorCode::outOfRange, "PrismaticJointDef::lowerTranslation", [](D& def) { def.lowerTranslation = 1; });
    RefuseNumber<D>("PrismaticJointDef::motorSpeed", &D::motorSpeed, true);
    RefuseNumber<D>("PrismaticJointDef::maxMotorForce", &D::maxMotorForce, false);
    auto* joint = static_cast<PrismaticJoint*>(Make<D>());
    RefuseLimitSetters(joint);
    RefuseSetter("force", false, [&](float x) { return joint->SetMaxMotorForce(x); });
}

TEST_F(JointBadInput, Wheel) {
    using D = WheelJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("WheelJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("WheelJointDef::localAnchorB", &D::localAnchorB);
    RefuseVector<D>("WheelJointDef::localAxisA", &D::localAxisA);
    Refuse<D>(ErrorCode::outOfRange, "WheelJointDef::localAxisA", [](D& def) { def.localAxisA = {0, 0}; });
    RefuseNumber<D>("WheelJointDef::lowerTranslation", &D::lowerTranslation, true);
    RefuseNumber<D>("WheelJointDef::upperTranslation", &D::upperTranslation, true);
    Refuse<D>(ErrorCode::outOfRange, "WheelJointDef::lowerTranslation", [](D& def) { def.lowerTranslation = 1; });
    RefuseNumber<D>("WheelJointDef::motorSpeed", &D::motorSpeed, true);
    RefuseNumber<D>("WheelJointDef::maxMotorTorque", &D::maxMotorTorque, false);
    RefuseNumber<D>("WheelJointDef::stiffness", &D::stiffness, false);
    RefuseNumber<D>("WheelJointDef::damping", &D::damping, false);
    auto* joint = static_cast<WheelJoint*>(Make<D>());
    RefuseLimitSetters(joint);
    RefuseSpringSetters(joint);
    RefuseSetter("torque", false, [&](float x) { return joint->SetMaxMotorTorque(x); });
}

TEST_F(JointBadInput, Weld) {
    using D = WeldJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("WeldJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("WeldJointDef::localAnchorB", &D::localAnchorB);
    RefuseNumber<D>("WeldJointDef::referenceAngle", &D::referenceAngle, true);
    RefuseNumber<D>("WeldJointDef::stiffness", &D::stiffness, false);
    RefuseNumber<D>("WeldJointDef::damping", &D::damping, false);
    RefuseSpringSetters(static_cast<WeldJoint*>(Make<D>()));
}

TEST_F(JointBadInput, Distance) {
    using D = DistanceJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("DistanceJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("DistanceJointDef::localAnchorB", &D::localAnchorB);
    RefuseNumber<D>("DistanceJointDef::length", &D::length, false);
    RefuseNumber<D>("DistanceJointDef::minLength", &D::minLength, false);
    RefuseNumber<D>("DistanceJointDef::maxLength", &D::maxLength, false);
    Refuse<D>(ErrorCode::outOfRange, "DistanceJointDef::minLength",
              [](D& def) { def.minLength = 2, def.maxLength = 1; });
    RefuseNumber<D>("DistanceJointDef::stiffness", &D::stiffness, false);
    RefuseNumber<D>("DistanceJointDef::damping", &D::damping, false);
    auto* joint = static_cast<DistanceJoint*>(Make<D>());
    RefuseSpringSetters(joint);
    RefuseSetter("length", false, [&](float x) { return joint->SetLength(x); });
    RefuseSetter("minLength", false, [&](float x) { return joint->SetMinLength(x); });
    RefuseSetter("maxLength", false, [&](float x) { return joint->SetMaxLength(x); });
}

TEST_F(JointBadInput, Friction) {
    using D = FrictionJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("FrictionJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("FrictionJointDef::localAnchorB", &D::localAnchorB);
    RefuseNumber<D>("FrictionJointDef::maxForce", &D::maxForce, false);
    RefuseNumber<D>("FrictionJointDef::maxTorque", &D::maxTorque, false);
    auto* joint = static_cast<FrictionJoint*>(Make<D>());
    RefuseSetter("force", false, [&](float x) { return joint->SetMaxForce(x); });
    RefuseSetter("torque", false, [&](float x) { return joint->SetMaxTorque(x); });
}

TEST_F(JointBadInput, Motor) {
    using D = MotorJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("MotorJointDef::linearOffset", &D::linearOffset);
    RefuseNumber<D>("MotorJointDef::angularOffset", &D::angularOffset, true);
    RefuseNumber<D>("MotorJointDef::maxForce", &D::maxForce, false);
    RefuseNumber<D>("MotorJointDef::maxTorque", &D::maxTorque, false);
    RefuseNumber<D>("MotorJointDef::correctionFactor", &D::correctionFactor, false);
    Refuse<D>(ErrorCode::outOfRange, "MotorJointDef::correctionFactor", [](D& def) { def.correctionFactor = 1.5f; });
    auto* joint = static_cast<MotorJoint*>(Make<D>());
    RefuseSetter("force", false, [&](float x) { return joint->SetMaxForce(x); });
    RefuseSetter("torque", false, [&](float x) { return joint->SetMaxTorque(x); });
    RefuseSetter("factor", false, [&](float x) { return joint->SetCorrectionFactor(x); });
    ExpectRefused(ErrorCode::outOfRange, "factor", [&] { joint->SetCorrectionFactor(1.5f); });
    RefuseSetter("angularOffset", true, [&](float x) { return joint->SetAngularOffset(x); });
    RefuseSetter("linearOffset", true, [&](float x) { return joint->SetLinearOffset({x, 0.0f}); });
}

TEST_F(JointBadInput, Mouse) {
    using D = MouseJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("MouseJointDef::target", &D::target);
    RefuseNumber<D>("MouseJointDef::maxForce", &D::maxForce, false);
    RefuseNumber<D>("MouseJointDef::stiffness", &D::stiffness, false);
    RefuseNumber<D>("MouseJointDef::damping", &D::damping, false);
    auto* joint = static_cast<MouseJoint*>(Make<D>());
    RefuseSpringSetters(joint);
    RefuseSetter("force", false, [&](float x) { return joint->SetMaxForce(x); });
    RefuseSetter("target", true, [&](float x) { return joint->SetTarget({0.0f, x}); });
}

TEST_F(JointBadInput, Pulley) {
    using D = PulleyJointDef;
    RefuseBodies<D>();
    RefuseVector<D>("PulleyJointDef::groundAnchorA", &D::groundAnchorA);
    RefuseVector<D>("PulleyJointDef::groundAnchorB", &D::groundAnchorB);
    RefuseVector<D>("PulleyJointDef::localAnchorA", &D::localAnchorA);
    RefuseVector<D>("PulleyJointDef::localAnchorB", &D::localAnchorB);
    RefuseNumber<D>("PulleyJointDef::lengthA", &D::lengthA, false);
    RefuseNumber<D>("PulleyJointDef::lengthB", &D::lengthB, false);
    RefuseNumber<D>("PulleyJointDef::ratio", &D::ratio, true);
    Refuse<D>(ErrorCode::outOfRange, "PulleyJointDef::ratio", [](D& def) { def.ratio = 0.0f; });
}

TEST_F(JointBadInput, Gear) {
    RevoluteJointDef hinge;
    hinge.bodyA = ground, hinge.bodyB = a;
    Joint* joint1 = world.CreateJoint(&hinge);
    hinge.bodyB = b;
    Joint* joint2 = world.CreateJoint(&hinge);
    WeldJointDef weld;
    weld.bodyA = a, weld.bodyB = b;
    Joint* welded = world.CreateJoint(&weld);
    World other({0, 0});
    hinge.bodyA = AddBody(other, staticBody, {0, 0}), hinge.bodyB = AddBody(other, dynamicBody, {0, 0});
    Joint* foreign = other.CreateJoint(&hinge);
    const auto refuse = [&](ErrorCode code, const char* field, auto change) {
        ExpectRefused(code, field, [&] {
            GearJointDef def;
            def.joint1 = joint1, def.joint2 = joint2;
            change(def);
            EXPECT_EQ(world.CreateJoint(&def), nullptr);
        });
    };
    using D = GearJointDef;
    refuse(ErrorCode::nullArgument, "GearJointDef::joint1", [](D& def) { def.joint1 = nullptr; });
    refuse(ErrorCode::nullArgument, "GearJointDef::joint2", [](D& def) { def.joint2 = nullptr; });
    refuse(ErrorCode::foreignHandle, "GearJointDef::joint1", [&](D& def) { def.joint1 = foreign; });
    refuse(ErrorCode::foreignHandle, "GearJointDef::joint2", [&](D& def) { def.joint2 = foreign; });
    refuse(ErrorCode::outOfRange, "GearJointDef::joint1", [&](D& def) { def.joint1 = welded; });
    refuse(ErrorCode::outOfRange, "GearJointDef::joint2", [&](D& def) { def.joint2 = welded; });
    refuse(ErrorCode::outOfRange, "GearJointDef::joint2", [&](D& def) { def.joint2 = joint1; });
    refuse(ErrorCode::nonFinite, "GearJointDef::ratio", [](D& def) { def.ratio = nan; });
    refuse(ErrorCode::outOfRange, "GearJointDef::ratio", [](D& def) { def.ratio = 0.0f; });
    D def;
    def.joint1 = joint1, def.joint2 = joint2;
    auto* gear = static_cast<GearJoint*>(world.CreateJoint(&def));
    ASSERT_NE(gear, nullptr);
    RefuseSetter("ratio", true, [&](float x) { return gear->SetRatio(x); });
    ExpectRefused(ErrorCode::outOfRange, "ratio", [&] { gear->SetRatio(0.0f); });
    Joint* dead = welded;
    world.DestroyJoint(welded);
    refuse(ErrorCode::foreignHandle, "GearJointDef::joint1", [&](D& d) { d.joint1 = dead; });
}

TEST_F(JointBadInput, HandlesAndTypes) {
    ExpectRefused(ErrorCode::nullArgument, "def", [&] { world.CreateJoint(nullptr); });
    ExpectRefused(ErrorCode::nullArgument, "joint", [&] { world.DestroyJoint(nullptr); });
    for (const int type : {int{e_unknownJoint}, int{e_ropeJoint}, 77}) {
        Refuse<WeldJointDef>(ErrorCode::outOfRange, "JointDef::type",
                             [&](WeldJointDef& def) { def.type = static_cast<JointType>(type); });
    }
    auto* dead = static_cast<WeldJoint*>(Make<WeldJointDef>());
    world.DestroyJoint(dead);
    ExpectRefused(ErrorCode::foreignHandle, "joint", [&] { world.DestroyJoint(dead); });
    ExpectRefused(ErrorCode::foreignHandle, "this", [&] { dead->SetDamping(1.0f); });
    float k = -3.0f, c = -4.0f;
    EXPECT_EQ(LinearStiffness(k, c, 1.0f, 1.0f, nullptr, a), ErrorCode::nullArgument);
    ExpectRefused(ErrorCode::nonFinite, "frequencyHertz", [&] { LinearStiffness(k, c, nan, 1.0f, a, b); });
    ExpectRefused(ErrorCode::outOfRange, "dampingRatio", [&] { AngularStiffness(k, c, 1.0f, -1.0f, a, b); });
    EXPECT_EQ(k, -3.0f);
    EXPECT_EQ(c, -4.0f);
}

TEST_F(JointBadInput, DefinitionsInitialisedWithoutABodyAreRefusedOnCreation) {
    RevoluteJointDef revolute;
    revolute.Initialize(a, nullptr, {0, 0});
    ExpectRefused(ErrorCode::nullArgument, "JointDef::bodyB", [&] { world.CreateJoint(&revolute); });
    PulleyJointDef pulley;
    pulley.Initialize(nullptr, b, {0, 9}, {2, 9}, {0, 5}, {2, 5}, 1.0f);
    ExpectRefused(ErrorCode::nullArgument, "JointDef::bodyA", [&] { world.CreateJoint(&pulley); });
}

/// Tries to make and destroy joints inside of a step.
struct Meddler : ContactListener {
    void BeginContact(Contact*) override {
        WeldJointDef def;
        def.bodyA = a, def.bodyB = b;
        EXPECT_EQ(world->CreateJoint(&def), nullptr);
        EXPECT_EQ(world->DestroyJoint(joint), ErrorCode::locked);
        ++calls;
    }
    World* world;
    Body *a, *b;
    Joint* joint;
    int calls = 0;
};

TEST_F(JointBadInput, NothingIsMadeOrDestroyedInsideAStep) {
    Meddler meddler;
    meddler.world = &world, meddler.a = a, meddler.b = b;
    WeldJointDef def = Valid<WeldJointDef>();
    def.localAnchorB = {-2.0f, 0.0f};
    meddler.joint = world.CreateJoint(&def);
    AddBox(AddBody(world, dynamicBody, {0.2f, 5.3f}), 0.5f, 0.5f);
    world.SetContactListener(&meddler);
    StepFor(world, 2);
    EXPECT_GT(meddler.calls, 0);
    EXPECT_EQ(errors.last.code, ErrorCode::locked);
    EXPECT_EQ(world.GetJointCount(), 1);
}

}  // namespace
}  // namespace scree::test
