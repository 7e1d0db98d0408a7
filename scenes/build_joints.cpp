// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of build_joints.h.

#include "scenes/build_joints.h"

#include <cmath>

#include "scenes/build.h"

namespace scenes {

namespace {

const Body& BodyAt(const Scene& scene, int body) { return scene.bodies[static_cast<std::size_t>(body)]; }

// The world axis in body A's coordinates, of length 1.
Vec2 LocalAxis(const Body& body, Vec2 axis) {
    const auto [sin, cos] = SinCos(body.angle);
    const double length = std::sqrt(static_cast<double>(axis.x) * axis.x + static_cast<double>(axis.y) * axis.y);
    return Point((cos * axis.x + sin * axis.y) / length, (cos * axis.y - sin * axis.x) / length);
}

double Distance(Vec2 a, Vec2 b) {
    const double x = static_cast<double>(b.x) - a.x, y = static_cast<double>(b.y) - a.y;
    return std::sqrt(x * x + y * y);
}

Joint& AddBetween(Scene& scene, JointType type, int bodyA, int bodyB) {
    Joint& joint = scene.joints.emplace_back();
    joint.type = type;
    joint.bodyA = bodyA;
    joint.bodyB = bodyB;
    joint.referenceAngle = BodyAt(scene, bodyB).angle - BodyAt(scene, bodyA).angle;
    return joint;
}

}  // namespace

Vec2 ToLocal(const Body& body, Vec2 world) {
    const auto [sin, cos] = SinCos(body.angle);
    const double x = static_cast<double>(world.x) - body.position.x, y = static_cast<double>(world.y) - body.position.y;
    return Point(cos * x + sin * y, cos * y - sin * x);
}

Vec2 ToWorld(const Body& body, Vec2 local) {
    const auto [sin, cos] = SinCos(body.angle);
    return Point(body.position.x + cos * local.x - sin * local.y, body.position.y + sin * local.x + cos * local.y);
}

Spring MakeSpring(double mass, double hertz, double dampingRatio) {
    const double omega = 2.0 * pi * hertz;
    return {static_cast<float>(mass * omega * omega), static_cast<float>(2.0 * mass * dampingRatio * omega)};
}

Joint& AddJoint(Scene& scene, JointType type, int bodyA, int bodyB, Vec2 anchor) {
    Joint& joint = AddBetween(scene, type, bodyA, bodyB);
    joint.localAnchorA = ToLocal(BodyAt(scene, bodyA), anchor);
    joint.localAnchorB = ToLocal(BodyAt(scene, bodyB), anchor);
    return joint;
}

Joint& AddPrismatic(Scene& scene, int bodyA, int bodyB, Vec2 anchor, Vec2 axis) {
    Joint& joint = AddJoint(scene, JointType::prismatic, bodyA, bodyB, anchor);
    joint.localAxisA = LocalAxis(BodyAt(scene, bodyA), axis);
    return joint;
}

Joint& AddWheel(Scene& scene, int bodyA, int bodyB, Vec2 anchor, Vec2 axis) {
    Joint& joint = AddJoint(scene, JointType::wheel, bodyA, bodyB, anchor);
    joint.localAxisA = LocalAxis(BodyAt(scene, bodyA), axis);
    return joint;
}

Joint& AddDistance(Scene& scene, int bodyA, int bodyB, Vec2 anchorA, Vec2 anchorB) {
    Joint& joint = AddBetween(scene, JointType::distance, bodyA, bodyB);
    joint.localAnchorA = ToLocal(BodyAt(scene, bodyA), anchorA);
    joint.localAnchorB = ToLocal(BodyAt(scene, bodyB), anchorB);
    joint.length = joint.minLength = joint.maxLength = static_cast<float>(Distance(anchorA, anchorB));
    return joint;
}

Joint& AddSpring(Scene& scene, int bodyA, int bodyB, Vec2 anchorA, Vec2 anchorB) {
    Joint& joint = AddDistance(scene, bodyA, bodyB, anchorA, anchorB);
    joint.minLength = Joint{}.minLength;
    joint.maxLength = Joint{}.maxLength;
    return joint;
}

Joint& AddPulley(Scene& scene, int bodyA, int bodyB, const PulleyPoints& points) {
    Joint& joint = AddBetween(scene, JointType::pulley, bodyA, bodyB);
    joint.collideConnected = true;
    joint.localAnchorA = ToLocal(BodyAt(scene, bodyA), points.anchorA);
    joint.localAnchorB = ToLocal(BodyAt(scene, bodyB), points.anchorB);
    joint.groundAnchorA = points.groundA;
    joint.groundAnchorB = points.groundB;
    joint.lengthA = static_cast<float>(Distance(points.groundA, points.anchorA));
    joint.lengthB = static_cast<float>(Distance(points.groundB, points.anchorB));
    return joint;
}

Joint& AddGear(Scene& scene, int joint1, int joint2, double ratio) {
    const int bodyA = scene.joints[static_cast<std::size_t>(joint1)].bodyB;
    const int bodyB = scene.joints[static_cast<std::size_t>(joint2)].bodyB;
    Joint& joint = AddBetween(scene, JointType::gear, bodyA, bodyB);
    joint.joint1 = joint1;
    joint.joint2 = joint2;
    joint.ratio = static_cast<float>(ratio);
    return joint;
}

Joint& AddMouse(Scene& scene, int ground, int bodyB, Vec2 grip, Vec2 target) {
    Joint& joint = AddBetween(scene, JointType::mouse, ground, bodyB);
    joint.collideConnected = true;
    joint.localAnchorB = ToLocal(BodyAt(scene, bodyB), grip);
    joint.target = target;
    return joint;
}

Joint& AddMotor(Scene& scene, int bodyA, int bodyB) {
    Joint& joint = AddBetween(scene, JointType::motor, bodyA, bodyB);
    joint.collideConnected = true;
    joint.linearOffset = ToLocal(BodyAt(scene, bodyA), BodyAt(scene, bodyB).position);
    joint.angularOffset = joint.referenceAngle;
    return joint;
}

}  // namespace scenes
