// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Cars: n cars with two driven wheels each on sprung wheel joints, on a road of bumps and hills.

#include "scenes/build_joints.h"
#include "scenes/games/terrain.h"

namespace scenes {

namespace {

double RoadAt(double x) { return 0.25 * SinCos(0.9 * x).sin + 0.8 * SinCos(0.11 * x).sin; }

void AddWheelOf(Scene& scene, int chassis, Vec2 hub) {
    AddBody(scene, BodyType::dynamic, hub);
    AddFixture(scene, Circle(0.4), 1.0).friction = 0.9f;
    Joint& wheel = AddWheel(scene, chassis, LastBody(scene), hub, Point(0.0, 1.0));
    const Spring spring = MakeSpring(0.5, 4.0, 0.7);
    wheel.stiffness = 4.0f * spring.stiffness;
    wheel.damping = 4.0f * spring.damping;
    wheel.enableLimit = true;
    wheel.lowerTranslation = -0.25f;
    wheel.upperTranslation = 0.25f;
    wheel.enableMotor = true;
    wheel.motorSpeed = -10.0f;
    wheel.maxMotorTorque = 20.0f;
}

}  // namespace

Scene Cars(int n) {
    Scene scene;
    AddTerrain(scene, 16.0 * n + 20.0, 0.5, RoadAt);
    for (int i = 0; i < n; ++i) {
        const double x = 12.0 * i + 10.0;
        AddBody(scene, BodyType::dynamic, Point(x, 3.0));
        AddFixture(scene, Box(1.5, 0.4), 1.0);
        const int chassis = LastBody(scene);
        for (const double offset : {-1.0, 1.0}) AddWheelOf(scene, chassis, Point(x + offset, 2.4));
    }
    return scene;
}

}  // namespace scenes
