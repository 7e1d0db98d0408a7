// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Values and edits of objects by the calls that our engine and Box2D 2.4 have in common, for the runs of both.

#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <utility>

#include "testbed/engines/run_values.h"

namespace testbed {

/// A list that grows by values of any kind.
class ValueList {
public:
    void Add(const char* name, float value, const char* unit = "") {
        m_values.push_back({name, fmt::format("{:.5g}{}{}", value, *unit != '\0' ? " " : "", unit)});
    }
    void Add(const char* name, bool value) { m_values.push_back({name, value ? "yes" : "no"}); }
    void Add(const char* name, const std::string& value) { m_values.push_back({name, value}); }
    template <typename Whole>
    requires(std::is_integral_v<Whole> && !std::is_same_v<Whole, bool>) void Add(const char* name, Whole value) {
        m_values.push_back({name, fmt::format("{}", value)});
    }
    template <typename Vec>
    requires requires(Vec v) { v.x + v.y; }
    void Add(const char* name, const Vec& v, const char* unit = "") {
        m_values.push_back({name, fmt::format("{:.5g}, {:.5g}{}{}", v.x, v.y, *unit != '\0' ? " " : "", unit)});
    }
    [[nodiscard]] RunValues Take() { return std::move(m_values); }

private:
    RunValues m_values;
};

template <class Body>
RunValues ValuesOfBody(const Body& body) {
    constexpr const char* types[]{"static", "kinematic", "dynamic"};
    ValueList list;
    list.Add("type", std::string(types[static_cast<int>(body.GetType())]));
    list.Add("position", body.GetPosition(), "m");
    list.Add("angle", body.GetAngle(), "rad");
    list.Add("centre of mass", body.GetWorldCenter(), "m");
    list.Add("local centre", body.GetLocalCenter(), "m");
    list.Add("velocity", body.GetLinearVelocity(), "m/s");
    list.Add("spin", body.GetAngularVelocity(), "rad/s");
    list.Add("mass", body.GetMass(), "kg");
    list.Add("inertia", body.GetInertia(), "kg m²");
    list.Add("damping", body.GetLinearDamping(), "1/s");
    list.Add("angular damping", body.GetAngularDamping(), "1/s");
    list.Add("gravity scale", body.GetGravityScale());
    list.Add("awake", body.IsAwake());
    list.Add("may sleep", body.IsSleepingAllowed());
    list.Add("bullet", body.IsBullet());
    list.Add("fixed rotation", body.IsFixedRotation());
    list.Add("enabled", body.IsEnabled());
    return list.Take();
}

template <class Fixture>
RunValues ValuesOfFixture(const Fixture& fixture) {
    ValueList list;
    list.Add("density", fixture.GetDensity(), "kg/m²");
    list.Add("friction", fixture.GetFriction());
    list.Add("restitution", fixture.GetRestitution());
    list.Add("bounces above", fixture.GetRestitutionThreshold(), "m/s");
    list.Add("sensor", fixture.IsSensor());
    const auto& filter = fixture.GetFilterData();
    list.Add("category", fmt::format("{:#06x}", filter.categoryBits));
    list.Add("mask", fmt::format("{:#06x}", filter.maskBits));
    list.Add("group", static_cast<int>(filter.groupIndex));
    return list.Take();
}

/// Of a joint by its own type; `inverse` of the last time step, 1/s.
template <class Joint>
RunValues ValuesOfJoint(const Joint& joint, float inverse) {
    ValueList list;
    list.Add("force", joint.GetReactionForce(inverse), "N");
    list.Add("torque", joint.GetReactionTorque(inverse), "N m");
    list.Add("collide", joint.GetCollideConnected());
#define SCREE_VALUE(name, unit, call) \
    if constexpr (requires { joint.call; }) list.Add(name, joint.call, unit)
#define SCREE_FLAG(name, call) \
    if constexpr (requires { joint.call; }) list.Add(name, joint.call)
    SCREE_VALUE("anchor A, local", "m", GetLocalAnchorA());
    SCREE_VALUE("anchor B, local", "m", GetLocalAnchorB());
    SCREE_VALUE("axis A, local", "", GetLocalAxisA());
    SCREE_VALUE("reference angle", "rad", GetReferenceAngle());
    SCREE_VALUE("angle", "rad", GetJointAngle());
    SCREE_VALUE("translation", "m", GetJointTranslation());
    SCREE_VALUE("speed", "", GetJointSpeed());
    SCREE_FLAG("limit", IsLimitEnabled());
    SCREE_VALUE("lower limit", "", GetLowerLimit());
    SCREE_VALUE("upper limit", "", GetUpperLimit());
    SCREE_FLAG("motor", IsMotorEnabled());
    SCREE_VALUE("motor speed", "", GetMotorSpeed());
    SCREE_VALUE("motor torque", "N m", GetMotorTorque(inverse));
    SCREE_VALUE("motor force", "N", GetMotorForce(inverse));
    SCREE_VALUE("most motor torque", "N m", GetMaxMotorTorque());
    SCREE_VALUE("most motor force", "N", GetMaxMotorForce());
    SCREE_VALUE("length", "m", GetLength());
    SCREE_VALUE("length now", "m", GetCurrentLength());
    SCREE_VALUE("least length", "m", GetMinLength());
    SCREE_VALUE("most length", "m", GetMaxLength());
    SCREE_VALUE("stiffness", "", GetStiffness());
    SCREE_VALUE("damping", "", GetDamping());
    SCREE_VALUE("most force", "N", GetMaxForce());
    SCREE_VALUE("most torque", "N m", GetMaxTorque());
    SCREE_VALUE("offset", "m", GetLinearOffset());
    SCREE_VALUE("angle offset", "rad", GetAngularOffset());
    SCREE_VALUE("correction factor", "", GetCorrectionFactor());
    SCREE_VALUE("target", "m", GetTarget());
    SCREE_VALUE("ground anchor A", "m", GetGroundAnchorA());
    SCREE_VALUE("ground anchor B", "m", GetGroundAnchorB());
    SCREE_VALUE("rope A", "m", GetCurrentLengthA());
    SCREE_VALUE("rope B", "m", GetCurrentLengthB());
    SCREE_VALUE("ratio", "", GetRatio());
#undef SCREE_VALUE
#undef SCREE_FLAG
    return list.Take();
}

/// Types has the engine's classes of joints.
template <class Types, class Joint>
RunValues ValuesOfJoint(const Joint& joint, scenes::JointType type, float inverse) {
    const auto as = [&]<class Own>(std::type_identity<Own>) {
        return ValuesOfJoint(static_cast<const Own&>(joint), inverse);
    };
    switch (type) {
        case scenes::JointType::revolute:
            return as(std::type_identity<typename Types::Revolute>());
        case scenes::JointType::distance:
            return as(std::type_identity<typename Types::Distance>());
        case scenes::JointType::friction:
            return as(std::type_identity<typename Types::Friction>());
        case scenes::JointType::gear:
            return as(std::type_identity<typename Types::Gear>());
        case scenes::JointType::motor:
            return as(std::type_identity<typename Types::Motor>());
        case scenes::JointType::mouse:
            return as(std::type_identity<typename Types::Mouse>());
        case scenes::JointType::prismatic:
            return as(std::type_identity<typename Types::Prismatic>());
        case scenes::JointType::pulley:
            return as(std::type_identity<typename Types::Pulley>());
        case scenes::JointType::weld:
            return as(std::type_identity<typename Types::Weld>());
        case scenes::JointType::wheel:
            return as(std::type_identity<typename Types::Wheel>());
    }
    return {};
}

/// `toVec` makes the engine's vectors.
template <class Body, class ToVec>
void ApplyEdit(Body& body, const BodyEdit& edit, ToVec&& toVec) {
    if (edit.type) body.SetType(static_cast<std::remove_cvref_t<decltype(body.GetType())>>(*edit.type));
    if (edit.position || edit.angle) {
        body.SetTransform(edit.position ? toVec(*edit.position) : body.GetPosition(),
                          edit.angle.value_or(body.GetAngle()));
    }
    if (edit.fixedRotation) body.SetFixedRotation(*edit.fixedRotation);
    if (edit.density) {
        for (auto* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
            fixture->SetDensity(*edit.density);
        }
        body.ResetMassData();
    }
    if (edit.linearVelocity) body.SetLinearVelocity(toVec(*edit.linearVelocity));
    if (edit.angularVelocity) body.SetAngularVelocity(*edit.angularVelocity);
    if (edit.linearDamping) body.SetLinearDamping(*edit.linearDamping);
    if (edit.angularDamping) body.SetAngularDamping(*edit.angularDamping);
    if (edit.gravityScale) body.SetGravityScale(*edit.gravityScale);
    if (edit.bullet) body.SetBullet(*edit.bullet);
    if (edit.allowSleep) body.SetSleepingAllowed(*edit.allowSleep);
    body.SetAwake(edit.awake.value_or(true));
}

}  // namespace testbed
