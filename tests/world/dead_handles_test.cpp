// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every call on a dead handle is one error, changes nothing and gives 0, false, null or an error code. These are all
// calls of all handles, with arguments of zero and null.

#include <gtest/gtest.h>

#include <tuple>
#include <type_traits>
#include <utility>

#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

template <typename T>
bool IsNothing(const T& value) {
    if constexpr (std::is_same_v<T, ErrorCode>) {
        return value == ErrorCode::foreignHandle;
    } else if constexpr (requires { value == T{}; }) {
        return value == T{};
    } else {
        return true;
    }
}

/// Calls methods of a dead object one by one.
class DeadCalls {
public:
    explicit DeadCalls(World& world) : m_log(world) {}

    template <typename Object, typename... Methods>
    void Make(const char* name, Object* object, Methods... methods) {
        int number = 0;
        (MakeOne(name, number++, object, methods), ...);
    }

private:
    template <typename Object, typename Result, typename Class, typename... Arguments>
    void MakeOne(const char* name, int number, Object* object, Result (Class::*method)(Arguments...)) {
        Expect(name, number, [&] { return (object->*method)(std::remove_cvref_t<Arguments>{}...); });
    }
    template <typename Object, typename Result, typename Class, typename... Arguments>
    void MakeOne(const char* name, int number, Object* object, Result (Class::*method)(Arguments...) const) {
        Expect(name, number, [&] { return (object->*method)(std::remove_cvref_t<Arguments>{}...); });
    }
    template <typename Call>
    void Expect(const char* name, int number, Call&& call) {
        m_log.count = 0;
        if constexpr (std::is_void_v<decltype(call())>) {
            call();
        } else {
            EXPECT_TRUE(IsNothing(call())) << name << ", call " << number;
        }
        EXPECT_EQ(m_log.count, 1) << name << ", call " << number;
        EXPECT_EQ(m_log.last.code, ErrorCode::foreignHandle) << name << ", call " << number;
    }

    ErrorLog m_log;
};

/// Two boxes on a floor that touch it.
struct Pair {
    Pair() {
        AddGround(world);
        for (Body** body : {&a, &b}) {
            *body = AddBody(world, dynamicBody, {body == &a ? -1.0f : 1.0f, 0.5f});
            AddBox(*body, 0.5f, 0.5f);
        }
    }
    template <typename Def>
    auto* Join(Def def) {
        def.bodyA = a, def.bodyB = b;
        return world.CreateJoint(&def);
    }
    World world{Vec2{0.0f, -10.0f}};
    Body* a = nullptr;
    Body* b = nullptr;
};

/// Objects die alone, or with all others when the world goes back to a time when it was empty: then their tables have
/// no rows for them.
constexpr bool destroyed = false, goneBack = true;
class DeadHandles : public testing::TestWithParam<bool> {
protected:
    /// All that the world has dies where it goes back.
    template <typename Destroy>
    void Lose(World& world, const Destroy& destroy) const {
        if (GetParam() == destroyed) return static_cast<void>(destroy());
        ASSERT_EQ(RestoreWorld(world, SaveWorld(World(world.GetGravity()))), SnapshotError::ok);
    }
};
INSTANTIATE_TEST_SUITE_P(All, DeadHandles, testing::Values(destroyed, goneBack),
                         [](const auto& way) { return way.param == destroyed ? "Destroyed" : "GoneBack"; });

TEST(DeadDefinitions, ADefinitionOfAMotorJointReadsNothingOfADeadBody) {
    Pair pair;
    pair.world.SetErrorHandler([](const Error&, void*) {}, nullptr);
    const std::vector<std::byte> image = SaveWorld(pair.world);
    std::vector<Body*> dead;
    for (int i = 0; i < 3000; ++i)
        dead.push_back(AddBody(pair.world, dynamicBody, {3.0f, 4.0f + static_cast<float>(i)}));
    ASSERT_EQ(RestoreWorld(pair.world, image), SnapshotError::ok);  // whose tables have no rows for them
    pair.world.DestroyBody(pair.b);
    dead.push_back(pair.b);
    for (Body* body : dead) {
        for (const bool isFirst : {true, false}) {
            MotorJointDef def;
            isFirst ? def.Initialize(body, pair.a) : def.Initialize(pair.a, body);
            EXPECT_EQ(def.linearOffset.x, 0.0f);
            EXPECT_EQ(def.linearOffset.y, 0.0f);
            EXPECT_EQ(def.angularOffset, 0.0f);
            EXPECT_EQ(pair.world.CreateJoint(&def), nullptr);
        }
    }
}

TEST_P(DeadHandles, EveryCallOnABodyIsAnError) {
    Pair pair;
    Lose(pair.world, [&] { pair.world.DestroyBody(pair.b); });
    DeadCalls calls(pair.world);
    calls.Make("Body", pair.b, static_cast<Fixture* (Body::*)(const FixtureDef*)>(&Body::CreateFixture),
               &Body::DestroyFixture, &Body::DestroyChain, &Body::SetTransform, &Body::GetTransform, &Body::GetPosition,
               &Body::GetAngle, &Body::GetWorldCenter, &Body::GetPositionRest, &Body::GetWorldCenterRest,
               &Body::GetLocalCenter, &Body::SetLinearVelocity, &Body::GetLinearVelocity, &Body::SetAngularVelocity,
               &Body::GetAngularVelocity, &Body::ApplyForce, &Body::ApplyForceToCenter, &Body::ApplyTorque,
               &Body::ApplyLinearImpulse, &Body::ApplyLinearImpulseToCenter, &Body::ApplyAngularImpulse, &Body::GetMass,
               &Body::GetInertia, &Body::GetMassData, &Body::SetMassData, &Body::ResetMassData);
    calls.Make("Body, points and settings", pair.b, &Body::GetWorldPoint, &Body::GetWorldVector, &Body::GetLocalPoint,
               &Body::GetLocalVector, &Body::GetLinearVelocityFromWorldPoint, &Body::GetLinearVelocityFromLocalPoint,
               &Body::GetLinearDamping, &Body::SetLinearDamping, &Body::GetAngularDamping, &Body::SetAngularDamping,
               &Body::GetGravityScale, &Body::SetGravityScale, &Body::GetType, &Body::SetType, &Body::SetBullet,
               &Body::IsBullet, &Body::SetSleepingAllowed, &Body::IsSleepingAllowed, &Body::SetAwake, &Body::IsAwake,
               &Body::SetEnabled, &Body::IsEnabled, &Body::SetFixedRotation, &Body::IsFixedRotation,
               &Body::SetMotionLocks, &Body::GetMotionLocks, &Body::SetTargetTransform);
    calls.Make("Body, lists", pair.b, static_cast<Fixture* (Body::*)()>(&Body::GetFixtureList),
               static_cast<const Fixture* (Body::*)() const>(&Body::GetFixtureList), &Body::GetContactCount,
               &Body::VisitContacts, &Body::VisitJoints, &Body::GetJointCount, &Body::GetJointList,
               static_cast<Body* (Body::*)()>(&Body::GetNext), &Body::GetUserData, &Body::SetUserData);
}

TEST_P(DeadHandles, EveryCallOnAFixtureIsAnError) {
    Pair pair;
    Fixture* fixture = pair.b->GetFixtureList();
    Lose(pair.world, [&] { pair.world.DestroyBody(pair.b); });
    DeadCalls calls(pair.world);
    calls.Make("Fixture", fixture, &Fixture::GetType, static_cast<Shape* (Fixture::*)()>(&Fixture::GetShape),
               static_cast<const Shape* (Fixture::*)() const>(&Fixture::GetShape), &Fixture::SetSensor,
               &Fixture::IsSensor, &Fixture::SetFilterData, &Fixture::GetFilterData, &Fixture::SetReports,
               &Fixture::GetReports, &Fixture::Refilter, static_cast<Body* (Fixture::*)()>(&Fixture::GetBody),
               &Fixture::GetChainId, &Fixture::GetChainIndex, static_cast<Fixture* (Fixture::*)()>(&Fixture::GetNext),
               &Fixture::GetUserData, &Fixture::SetUserData, &Fixture::TestPoint, &Fixture::RayCast,
               &Fixture::GetMassData, &Fixture::SetDensity, &Fixture::GetDensity, &Fixture::SetFriction,
               &Fixture::GetFriction, &Fixture::SetRestitution, &Fixture::GetRestitution,
               &Fixture::SetRestitutionThreshold, &Fixture::GetRestitutionThreshold, &Fixture::SetTangentSpeed,
               &Fixture::GetTangentSpeed, &Fixture::SetRollingResistance, &Fixture::GetRollingResistance,
               &Fixture::SetMixRules, &Fixture::GetFrictionRule, &Fixture::GetRestitutionRule, &Fixture::SetMaterialId,
               &Fixture::GetMaterialId, &Fixture::GetAABB);
}

TEST_P(DeadHandles, EveryCallOnAContactIsAnErrorWhetherItsRowIsLeftOrNot) {
    for (const int steps : {0, 1, 3}) {
        Pair pair;
        StepFor(pair.world, 2);
        Contact* contact = nullptr;
        pair.b->VisitContacts([&](Contact* each) { return contact = each, false; });
        ASSERT_NE(contact, nullptr);
        const ContactId id = pair.world.GetId(contact);
        Lose(pair.world, [&] {
            pair.world.DestroyBody(pair.b);
            if (steps > 0) pair.world.DestroyBody(pair.a);
        });
        StepFor(pair.world, steps);
        EXPECT_EQ(pair.world.Find(id), nullptr);
        EXPECT_TRUE(pair.world.GetId(contact) == ContactId{});
        DeadCalls calls(pair.world);
        calls.Make("Contact", contact, &Contact::GetManifold, &Contact::SetManifold, &Contact::GetWorldManifold,
                   &Contact::IsTouching, &Contact::SetEnabled, &Contact::IsEnabled,
                   static_cast<Contact* (Contact::*)()>(&Contact::GetNext),
                   static_cast<Fixture* (Contact::*)()>(&Contact::GetFixtureA),
                   static_cast<Fixture* (Contact::*)()>(&Contact::GetFixtureB), &Contact::SetFriction,
                   &Contact::GetFriction, &Contact::ResetFriction, &Contact::SetRestitution, &Contact::GetRestitution,
                   &Contact::ResetRestitution, &Contact::SetRestitutionThreshold, &Contact::GetRestitutionThreshold,
                   &Contact::ResetRestitutionThreshold, &Contact::SetTangentSpeed, &Contact::GetTangentSpeed);
    }
}

/// What all joints have.
void CallAll(DeadCalls& calls, const char* name, Joint* joint) {
    calls.Make(name, joint, &Joint::GetType, &Joint::GetBodyA, &Joint::GetBodyB, &Joint::GetOther,
               &Joint::GetCollideConnected, &Joint::GetUserData, &Joint::SetUserData, &Joint::IsEnabled,
               static_cast<Joint* (Joint::*)() const>(&Joint::GetNext),
               static_cast<Joint* (Joint::*)(const Body*) const>(&Joint::GetNext), &Joint::ShiftOrigin,
               &Joint::GetAnchorA, &Joint::GetAnchorB, &Joint::GetReactionForce, &Joint::GetReactionTorque,
               &Joint::SetThresholds, &Joint::GetForceThreshold, &Joint::GetTorqueThreshold, &Joint::BreaksAtThreshold);
}

template <typename Handle, typename Def>
Handle* Make(Pair& pair, const Def& def) {
    return static_cast<Handle*>(pair.Join(def));
}

/// Limits and a motor.
template <typename J, typename... More>
void CallBounds(DeadCalls& calls, const char* name, J* joint, More... more) {
    calls.Make(name, joint, &J::GetLocalAnchorA, &J::GetLocalAnchorB, &J::IsLimitEnabled, &J::EnableLimit,
               &J::GetLowerLimit, &J::GetUpperLimit, &J::SetLimits, &J::IsMotorEnabled, &J::EnableMotor,
               &J::SetMotorSpeed, &J::GetMotorSpeed, more...);
}

TEST_P(DeadHandles, EveryCallOnAJointIsAnError) {
    Pair pair;
    auto* revolute = Make<RevoluteJoint>(pair, RevoluteJointDef{});
    auto* prismatic = Make<PrismaticJoint>(pair, PrismaticJointDef{});
    auto* wheel = Make<WheelJoint>(pair, WheelJointDef{});
    auto* distance = Make<DistanceJoint>(pair, DistanceJointDef{});
    auto* weld = Make<WeldJoint>(pair, WeldJointDef{});
    auto* friction = Make<FrictionJoint>(pair, FrictionJointDef{});
    auto* motor = Make<MotorJoint>(pair, MotorJointDef{});
    auto* mouse = Make<MouseJoint>(pair, MouseJointDef{});
    auto* pulley = Make<PulleyJoint>(pair, PulleyJointDef{});
    const std::pair<const char*, Joint*> joints[] = {
        {"revolute", revolute}, {"prismatic", prismatic}, {"wheel", wheel}, {"distance", distance}, {"weld", weld},
        {"friction", friction}, {"motor", motor},         {"mouse", mouse}, {"pulley", pulley}};
    Lose(pair.world, [&] {
        for (const auto& [name, joint] : joints) pair.world.DestroyJoint(joint);
    });
    DeadCalls calls(pair.world);
    for (const auto& [name, joint] : joints) CallAll(calls, name, joint);
    CallBounds(calls, "revolute", revolute, &RevoluteJoint::GetReferenceAngle, &RevoluteJoint::GetJointAngle,
               &RevoluteJoint::GetJointSpeed, &RevoluteJoint::SetMaxMotorTorque, &RevoluteJoint::GetMaxMotorTorque,
               &RevoluteJoint::GetMotorTorque, &RevoluteJoint::IsSpringEnabled, &RevoluteJoint::EnableSpring,
               &RevoluteJoint::SetSpring, &RevoluteJoint::GetStiffness, &RevoluteJoint::GetDamping,
               &RevoluteJoint::SetTargetAngle, &RevoluteJoint::GetTargetAngle, &RevoluteJoint::SetMaxSpringTorque,
               &RevoluteJoint::GetMaxSpringTorque, &RevoluteJoint::GetSpringTorque);
    CallBounds(calls, "prismatic", prismatic, &PrismaticJoint::GetLocalAxisA, &PrismaticJoint::GetReferenceAngle,
               &PrismaticJoint::GetJointTranslation, &PrismaticJoint::GetJointSpeed, &PrismaticJoint::SetMaxMotorForce,
               &PrismaticJoint::GetMaxMotorForce, &PrismaticJoint::GetMotorForce, &PrismaticJoint::IsSpringEnabled,
               &PrismaticJoint::EnableSpring, &PrismaticJoint::SetSpring, &PrismaticJoint::GetStiffness,
               &PrismaticJoint::GetDamping, &PrismaticJoint::SetTargetTranslation,
               &PrismaticJoint::GetTargetTranslation, &PrismaticJoint::SetMaxSpringForce,
               &PrismaticJoint::GetMaxSpringForce, &PrismaticJoint::GetSpringForce);
    CallBounds(calls, "wheel", wheel, &WheelJoint::GetLocalAxisA, &WheelJoint::GetJointTranslation,
               &WheelJoint::GetJointLinearSpeed, &WheelJoint::GetJointAngle, &WheelJoint::GetJointAngularSpeed,
               &WheelJoint::SetMaxMotorTorque, &WheelJoint::GetMaxMotorTorque, &WheelJoint::GetMotorTorque,
               &WheelJoint::SetStiffness, &WheelJoint::GetStiffness, &WheelJoint::SetDamping, &WheelJoint::GetDamping,
               &WheelJoint::SetMaxSpringForce, &WheelJoint::GetMaxSpringForce);
    calls.Make("distance", distance, &DistanceJoint::GetLocalAnchorA, &DistanceJoint::GetLength,
               &DistanceJoint::SetLength, &DistanceJoint::GetMinLength, &DistanceJoint::SetMinLength,
               &DistanceJoint::GetMaxLength, &DistanceJoint::SetMaxLength, &DistanceJoint::GetCurrentLength,
               &DistanceJoint::SetStiffness, &DistanceJoint::GetStiffness, &DistanceJoint::SetDamping,
               &DistanceJoint::GetDamping, &DistanceJoint::SetMaxSpringForce, &DistanceJoint::GetMaxSpringForce);
    calls.Make("weld", weld, &WeldJoint::GetLocalAnchorA, &WeldJoint::GetReferenceAngle, &WeldJoint::SetStiffness,
               &WeldJoint::GetStiffness, &WeldJoint::SetDamping, &WeldJoint::GetDamping);
    calls.Make("friction", friction, &FrictionJoint::GetLocalAnchorA, &FrictionJoint::SetMaxForce,
               &FrictionJoint::GetMaxForce, &FrictionJoint::SetMaxTorque, &FrictionJoint::GetMaxTorque);
    calls.Make("motor", motor, &MotorJoint::SetLinearOffset, &MotorJoint::GetLinearOffset,
               &MotorJoint::SetAngularOffset, &MotorJoint::GetAngularOffset, &MotorJoint::SetMaxForce,
               &MotorJoint::GetMaxForce, &MotorJoint::SetMaxTorque, &MotorJoint::GetMaxTorque,
               &MotorJoint::SetCorrectionFactor, &MotorJoint::GetCorrectionFactor);
    calls.Make("mouse", mouse, &MouseJoint::SetTarget, &MouseJoint::GetTarget, &MouseJoint::SetMaxForce,
               &MouseJoint::GetMaxForce, &MouseJoint::SetStiffness, &MouseJoint::GetStiffness, &MouseJoint::SetDamping,
               &MouseJoint::GetDamping);
    calls.Make("pulley", pulley, &PulleyJoint::GetGroundAnchorA, &PulleyJoint::GetLengthA, &PulleyJoint::GetRatio,
               &PulleyJoint::GetCurrentLengthA);
}

}  // namespace
}  // namespace scree::test
