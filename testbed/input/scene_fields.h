// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The members of a scene by name: the one list that reading, writing and the tests of the schema walk. Each list is
// checked against the number of members of its struct, so that a member added to scene.h cannot be forgotten here.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "scenes/scene.h"

namespace testbed {

template <typename Owner, typename Value>
struct SceneField {
    std::string_view name;
    Value Owner::*member;
};
/// Said aloud for compilers that deduce nothing for aggregates, such as clang 16.
template <typename Owner, typename Value>
SceneField(const char*, Value Owner::*) -> SceneField<Owner, Value>;

/// Converts to any type, in initialisers that are never evaluated.
struct Anything {
    template <typename T>
    operator T() const;
};

/// The number of members of an aggregate: the most values that can initialise one.
template <typename Aggregate, typename... Values>
consteval std::size_t MemberCount() {
    if constexpr (requires { Aggregate{Values{}..., Anything{}}; }) {
        return MemberCount<Aggregate, Values..., Anything>();
    } else {
        return sizeof...(Values);
    }
}

/// `sceneFields<T>`: the members of T that stand in a file under their own name. What is left out (ranges into the
/// arrays of the scene, which a file nests instead) is counted beside each list.
template <typename Owner>
inline constexpr auto sceneFields = std::tuple<>{};

template <>
inline constexpr auto sceneFields<scenes::Shape> = std::tuple{
    SceneField{"type", &scenes::Shape::type},     SceneField{"radius", &scenes::Shape::radius},
    SceneField{"center", &scenes::Shape::center}, SceneField{"halfExtents", &scenes::Shape::halfExtents},
    SceneField{"angle", &scenes::Shape::angle},   SceneField{"opening", &scenes::Shape::opening},
};
// vertexCount and vertices, firstChainVertex and chainVertexCount, support: written as vertices, chainVertices and a
// name.
static_assert(MemberCount<scenes::Shape>() == std::tuple_size_v<decltype(sceneFields<scenes::Shape>)> + 5);

template <>
inline constexpr auto sceneFields<scenes::Fixture> = std::tuple{
    SceneField{"density", &scenes::Fixture::density},
    SceneField{"friction", &scenes::Fixture::friction},
    SceneField{"restitution", &scenes::Fixture::restitution},
    SceneField{"tangentSpeed", &scenes::Fixture::tangentSpeed},
    SceneField{"isSensor", &scenes::Fixture::isSensor},
    SceneField{"categoryBits", &scenes::Fixture::categoryBits},
    SceneField{"maskBits", &scenes::Fixture::maskBits},
    SceneField{"groupIndex", &scenes::Fixture::groupIndex},
};
// shape: an object of its own.
static_assert(MemberCount<scenes::Fixture>() == std::tuple_size_v<decltype(sceneFields<scenes::Fixture>)> + 1);

template <>
inline constexpr auto sceneFields<scenes::Body> = std::tuple{
    SceneField{"type", &scenes::Body::type},
    SceneField{"bullet", &scenes::Body::bullet},
    SceneField{"allowSleep", &scenes::Body::allowSleep},
    SceneField{"awake", &scenes::Body::awake},
    SceneField{"fixedRotation", &scenes::Body::fixedRotation},
    SceneField{"position", &scenes::Body::position},
    SceneField{"angle", &scenes::Body::angle},
    SceneField{"linearVelocity", &scenes::Body::linearVelocity},
    SceneField{"angularVelocity", &scenes::Body::angularVelocity},
    SceneField{"linearDamping", &scenes::Body::linearDamping},
    SceneField{"angularDamping", &scenes::Body::angularDamping},
    SceneField{"gravityScale", &scenes::Body::gravityScale},
};
// firstFixture and fixtureCount: the fixtures stand in their body.
static_assert(MemberCount<scenes::Body>() == std::tuple_size_v<decltype(sceneFields<scenes::Body>)> + 2);

template <>
inline constexpr auto sceneFields<scenes::Joint> = std::tuple{
    SceneField{"type", &scenes::Joint::type},
    SceneField{"collideConnected", &scenes::Joint::collideConnected},
    SceneField{"enableMotor", &scenes::Joint::enableMotor},
    SceneField{"enableLimit", &scenes::Joint::enableLimit},
    SceneField{"bodyA", &scenes::Joint::bodyA},
    SceneField{"bodyB", &scenes::Joint::bodyB},
    SceneField{"localAnchorA", &scenes::Joint::localAnchorA},
    SceneField{"localAnchorB", &scenes::Joint::localAnchorB},
    SceneField{"localAxisA", &scenes::Joint::localAxisA},
    SceneField{"referenceAngle", &scenes::Joint::referenceAngle},
    SceneField{"lowerAngle", &scenes::Joint::lowerAngle},
    SceneField{"upperAngle", &scenes::Joint::upperAngle},
    SceneField{"lowerTranslation", &scenes::Joint::lowerTranslation},
    SceneField{"upperTranslation", &scenes::Joint::upperTranslation},
    SceneField{"motorSpeed", &scenes::Joint::motorSpeed},
    SceneField{"maxMotorTorque", &scenes::Joint::maxMotorTorque},
    SceneField{"maxMotorForce", &scenes::Joint::maxMotorForce},
    SceneField{"maxForce", &scenes::Joint::maxForce},
    SceneField{"maxTorque", &scenes::Joint::maxTorque},
    SceneField{"stiffness", &scenes::Joint::stiffness},
    SceneField{"damping", &scenes::Joint::damping},
    SceneField{"length", &scenes::Joint::length},
    SceneField{"minLength", &scenes::Joint::minLength},
    SceneField{"maxLength", &scenes::Joint::maxLength},
    SceneField{"linearOffset", &scenes::Joint::linearOffset},
    SceneField{"angularOffset", &scenes::Joint::angularOffset},
    SceneField{"correctionFactor", &scenes::Joint::correctionFactor},
    SceneField{"target", &scenes::Joint::target},
    SceneField{"groundAnchorA", &scenes::Joint::groundAnchorA},
    SceneField{"groundAnchorB", &scenes::Joint::groundAnchorB},
    SceneField{"lengthA", &scenes::Joint::lengthA},
    SceneField{"lengthB", &scenes::Joint::lengthB},
    SceneField{"ratio", &scenes::Joint::ratio},
    SceneField{"joint1", &scenes::Joint::joint1},
    SceneField{"joint2", &scenes::Joint::joint2},
};
static_assert(MemberCount<scenes::Joint>() == std::tuple_size_v<decltype(sceneFields<scenes::Joint>)>);

template <>
inline constexpr auto sceneFields<scenes::Spawn> = std::tuple{
    SceneField{"afterStep", &scenes::Spawn::afterStep},
    SceneField{"body", &scenes::Spawn::body},
};
static_assert(MemberCount<scenes::Spawn>() == std::tuple_size_v<decltype(sceneFields<scenes::Spawn>)>);

template <>
inline constexpr auto sceneFields<scenes::Scene> = std::tuple{
    SceneField{"name", &scenes::Scene::name},
    SceneField{"size", &scenes::Scene::size},
    SceneField{"steps", &scenes::Scene::steps},
    SceneField{"showStep", &scenes::Scene::showStep},
    SceneField{"gravity", &scenes::Scene::gravity},
    SceneField{"timeStep", &scenes::Scene::timeStep},
    SceneField{"velocityIterations", &scenes::Scene::velocityIterations},
    SceneField{"positionIterations", &scenes::Scene::positionIterations},
};
// bodies, fixtures, joints, spawns, chainVertices, user: arrays and an object of their own.
static_assert(MemberCount<scenes::Scene>() == std::tuple_size_v<decltype(sceneFields<scenes::Scene>)> + 6);

/// Calls `action(field)` for each member of Owner's list.
template <typename Owner, typename Action>
constexpr void ForEachField(Action&& action) {
    std::apply([&](const auto&... field) { (action(field), ...); }, sceneFields<Owner>);
}

inline constexpr std::array<std::string_view, 3> bodyTypeNames{"static", "kinematic", "dynamic"};
inline constexpr std::array<std::string_view, 11> shapeTypeNames{"circle",  "box",     "polygon",        "edge",
                                                                 "chain",   "capsule", "roundedPolygon", "largePolygon",
                                                                 "ellipse", "sector",  "supported"};
inline constexpr std::array<std::string_view, scenes::jointTypeCount> jointTypeNames{
    "revolute", "distance", "friction", "gear", "motor", "mouse", "prismatic", "pulley", "weld", "wheel"};

/// The keys that a shape or a joint of a type has beside "type" (scenes/scene.h says what they mean); a joint also has
/// bodyA, bodyB and collideConnected.
[[nodiscard]] std::span<const std::string_view> KeysOf(scenes::ShapeType type);
[[nodiscard]] std::span<const std::string_view> KeysOf(scenes::JointType type);

}  // namespace testbed
