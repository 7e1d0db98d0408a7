// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What scene files join bodies with: bodies by index and world points in, joints with local anchors appended to the
// scene out. All take the bodies' poses as they are now for the rest state. A returned reference holds until the next
// joint is added.

#pragma once

#include "scenes/scene.h"

namespace scenes {

/// Between body and world coordinates.
[[nodiscard]] Vec2 ToLocal(const Body& body, Vec2 world);
[[nodiscard]] Vec2 ToWorld(const Body& body, Vec2 local);

/// A spring as the engines take it.
struct Spring {
    float stiffness, damping;
};

/// The spring on which `mass` oscillates at `hertz` with a damping ratio (0 none, 1 critical): k = m ω², d = 2 m ζ ω.
/// `mass` is in kg, or an inertia in kg·m² for an angular one.
[[nodiscard]] Spring MakeSpring(double mass, double hertz, double dampingRatio);
/// What two masses or inertias on a spring between them move like: a·b / (a + b).
[[nodiscard]] constexpr double Reduced(double a, double b) { return a * b / (a + b); }

/// Any joint whose two anchors meet at one world point; the present relative angle becomes its reference.
Joint& AddJoint(Scene& scene, JointType type, int bodyA, int bodyB, Vec2 anchor);
/// A slider along a world axis of any length.
Joint& AddPrismatic(Scene& scene, int bodyA, int bodyB, Vec2 anchor, Vec2 axis);
/// A wheel that travels along a world axis of any length.
Joint& AddWheel(Scene& scene, int bodyA, int bodyB, Vec2 anchor, Vec2 axis);
/// A rod of the present distance; change minLength and maxLength for a rope, add a spring for a spring.
Joint& AddDistance(Scene& scene, int bodyA, int bodyB, Vec2 anchorA, Vec2 anchorB);
/// The same as a spring without limits, at rest at the present distance.
Joint& AddSpring(Scene& scene, int bodyA, int bodyB, Vec2 anchorA, Vec2 anchorB);

/// World points of a pulley.
struct PulleyPoints {
    Vec2 groundA, groundB;  ///< where the rope is hung
    Vec2 anchorA, anchorB;  ///< where it holds the bodies
};
/// A rope of the present lengths; the bodies collide.
Joint& AddPulley(Scene& scene, int bodyA, int bodyB, const PulleyPoints& points);

/// Couples two joints of the scene, given by index.
Joint& AddGear(Scene& scene, int joint1, int joint2, double ratio);
/// Pulls the point of body B that is now at `grip` to `target`; body A is any static one. The bodies collide.
Joint& AddMouse(Scene& scene, int ground, int bodyB, Vec2 grip, Vec2 target);
/// Drives B towards its present pose in A. The bodies collide.
Joint& AddMotor(Scene& scene, int bodyA, int bodyB);

/// The index of the joint added last.
[[nodiscard]] inline int LastJoint(const Scene& scene) { return static_cast<int>(scene.joints.size()) - 1; }

}  // namespace scenes
