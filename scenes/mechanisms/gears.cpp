// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Gears: a train of n wheels of 1 m and 2 m radius in turn on revolute joints, coupled by gear joints. The first is
// driven by a motor, and the last lifts a rack on a prismatic joint. The teeth are drawn, not felt. Size → scene.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

constexpr double RadiusOf(int gear) { return gear % 2 == 0 ? 1.0 : 2.0; }

void AddTooth(Scene& scene, const Shape& tooth) { AddFixture(scene, tooth, 1.0).maskBits = 0; }

void AddToothedWheel(Scene& scene, int gear, Vec2 center) {
    const double radius = RadiusOf(gear);
    const int teeth = gear % 2 == 0 ? 8 : 16;
    AddBody(scene, BodyType::dynamic, center);
    AddFixture(scene, Circle(radius - 0.1), 1.0).maskBits = 0;
    for (int i = 0; i < teeth; ++i) {
        // Neighbours mesh: where the wheels meet, one has a tooth and the other a gap.
        const double angle = 2.0 * pi * (i + (gear % 2 == 0 ? 0.0 : 0.5)) / teeth;
        const auto [sin, cos] = SinCos(angle);
        AddTooth(scene, Box(0.12, 0.1, Point(radius * cos, radius * sin), angle));
    }
}

}  // namespace

Scene Gears(int n) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(-3.0, -5.0), Point(3.0 * n + 3.0, -5.0)));
    double x = 0.0;
    for (int i = 0; i < n; ++i) {
        if (i > 0) x += 3.0;
        AddToothedWheel(scene, i, Point(x, 0.0));
        Joint& hinge = AddJoint(scene, JointType::revolute, 0, LastBody(scene), Point(x, 0.0));
        if (i > 0) continue;
        hinge.enableMotor = true;
        hinge.motorSpeed = static_cast<float>(n % 2 == 1 ? 1.0 : -1.0);  // so that the last one turns counter-clockwise
        hinge.maxMotorTorque = 1e4f;
    }
    const double last = RadiusOf(n - 1);
    x += last + 0.35;
    AddBody(scene, BodyType::dynamic, Point(x, 0.0));
    AddFixture(scene, Box(0.25, 4.0), 1.0).maskBits = 0;
    for (int i = 0; i < 9; ++i) AddTooth(scene, Box(0.1, 0.12, Point(-0.35, -3.5 + pi / 4.0 * i + pi / 8.0)));
    Joint& slider = AddPrismatic(scene, 0, LastBody(scene), Point(x, 0.0), Point(0.0, 1.0));
    slider.enableLimit = true;
    slider.lowerTranslation = -5.0f;
    slider.upperTranslation = 5.0f;

    const int hinges = LastJoint(scene);
    // Wheels roll on each other: r1 θ1 + r2 θ2 = const; the rack goes up where the last wheel turns counter-clockwise.
    for (int i = 1; i < hinges; ++i) AddGear(scene, i - 1, i, RadiusOf(i) / RadiusOf(i - 1));
    AddGear(scene, hinges - 1, hinges, -1.0 / last);
    return scene;
}

}  // namespace scenes
