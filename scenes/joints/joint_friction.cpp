// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Friction joints, seen from above: six pucks leave a line at 6 m/s, each held to the ground by a friction joint. Puck
// i is braked by 2 + 2i m/s² and goes 36 / (2 (2 + 2i)) m. They also spin, with as much braking of the spin.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointFriction(int) {
    Scene scene;
    scene.gravity = {};
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(0.0, -1.0), Point(0.0, 11.0))).isSensor = true;
    for (int i = 0; i < 6; ++i) {
        Body& puck = AddBody(scene, BodyType::dynamic, Point(0.0, 2.0 * i));
        puck.linearVelocity = Point(6.0, 0.0);
        puck.angularVelocity = 6.0f;
        AddFixture(scene, Box(0.5, 0.5), 1.0);
        Joint& joint = AddJoint(scene, JointType::friction, 0, LastBody(scene), Point(0.0, 2.0 * i));
        const double braking = 2.0 + 2.0 * i;
        joint.maxForce = static_cast<float>(braking);         // 1 kg
        joint.maxTorque = static_cast<float>(braking / 6.0);  // 1/6 kg·m²
    }
    return scene;
}

}  // namespace scenes
