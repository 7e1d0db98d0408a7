// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tumbler: a motor turns a hollow drum into which one small box falls after each step, until there are n. Size → scene.
// Tsamis 2020, §8.1, after Box2D's testbed.

#include <algorithm>

#include "scenes/build.h"

namespace scenes {

Scene Tumbler(int n) {
    Scene scene;
    Reserve(scene, n + 2, n + 4);
    scene.spawns.reserve(static_cast<std::size_t>(n));
    // The published run is 1500 steps for up to 1000 boxes; more boxes get the same 500 steps after the last one.
    scene.steps = std::max(1500, n + 500);

    AddBody(scene, BodyType::isStatic, {});
    AddBody(scene, BodyType::dynamic, Point(0.0, 10.0));
    AddFixture(scene, Box(0.5, 10.0, Point(10.0, 0.0)), 5.0);
    AddFixture(scene, Box(0.5, 10.0, Point(-10.0, 0.0)), 5.0);
    AddFixture(scene, Box(10.0, 0.5, Point(0.0, 10.0)), 5.0);
    AddFixture(scene, Box(10.0, 0.5, Point(0.0, -10.0)), 5.0);

    Joint& joint = scene.joints.emplace_back();
    joint.bodyA = 0;
    joint.bodyB = 1;
    joint.localAnchorA = Point(0.0, 10.0);
    joint.enableMotor = true;
    joint.motorSpeed = static_cast<float>(0.05 * pi);
    joint.maxMotorTorque = 1e8f;

    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.0, 10.0));
        AddFixture(scene, Box(0.125, 0.125), 1.0);
        scene.spawns.push_back({.afterStep = i + 1, .body = LastBody(scene)});
    }
    return scene;
}

}  // namespace scenes
