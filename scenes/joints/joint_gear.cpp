// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Gear joints: two wheels coupled as by teeth (2 : 1), two that turn alike as by a belt, a wheel and a rack. A motor
// turns the left wheel of each.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

// Returns the index of its hinge.
int AddWheelOnGround(Scene& scene, Vec2 center, double radius, bool isDriven) {
    AddBody(scene, BodyType::dynamic, center);
    AddFixture(scene, Circle(radius), 5.0).maskBits = 0;
    Joint& hinge = AddJoint(scene, JointType::revolute, 0, LastBody(scene), center);
    hinge.enableMotor = isDriven;
    hinge.motorSpeed = 1.0f;
    hinge.maxMotorTorque = 1e4f;
    return LastJoint(scene);
}

}  // namespace

Scene JointGear(int) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(-12.0, -4.5), Point(12.0, -4.5)));

    const int teeth1 = AddWheelOnGround(scene, Point(-10.0, 0.0), 1.0, true);
    const int teeth2 = AddWheelOnGround(scene, Point(-7.0, 0.0), 2.0, false);
    AddGear(scene, teeth1, teeth2, 2.0);

    const int belt1 = AddWheelOnGround(scene, Point(-2.5, 0.0), 1.0, true);
    const int belt2 = AddWheelOnGround(scene, Point(1.5, 0.0), 1.5, false);
    AddGear(scene, belt1, belt2, -1.5);

    const int pinion = AddWheelOnGround(scene, Point(7.0, 0.0), 1.0, true);
    AddBody(scene, BodyType::dynamic, Point(8.25, 0.0));
    AddFixture(scene, Box(0.25, 4.0), 5.0).maskBits = 0;
    AddPrismatic(scene, 0, LastBody(scene), Point(8.25, 0.0), Point(0.0, 1.0));
    AddGear(scene, pinion, LastJoint(scene), -1.0);
    return scene;
}

}  // namespace scenes
