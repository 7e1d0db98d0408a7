// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Revolute joints: a free pendulum, a bar that falls to its limit, a bar turned by a motor that carries a pendulum, and
// two bars hinged to each other alone.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointRevolute(int) {
    Scene scene;
    AddFlatGround(scene, 16.0);
    const auto addBar = [&scene](double x, double y) {
        AddBody(scene, BodyType::dynamic, Point(x, y));
        AddFixture(scene, Box(2.0, 0.2), 5.0);
        return LastBody(scene);
    };
    AddJoint(scene, JointType::revolute, 0, addBar(-11.0, 8.0), Point(-13.0, 8.0));

    Joint& limited = AddJoint(scene, JointType::revolute, 0, addBar(-5.0, 8.0), Point(-7.0, 8.0));
    limited.enableLimit = true;
    limited.lowerAngle = static_cast<float>(-0.25 * pi);
    limited.upperAngle = static_cast<float>(0.5 * pi);

    const int driven = addBar(3.0, 8.0);
    Joint& motor = AddJoint(scene, JointType::revolute, 0, driven, Point(3.0, 8.0));
    motor.enableMotor = true;
    motor.motorSpeed = 1.0f;
    motor.maxMotorTorque = 1e4f;
    AddJoint(scene, JointType::revolute, driven, addBar(7.0, 8.0), Point(5.0, 8.0));

    const int left = addBar(10.0, 4.0);
    AddJoint(scene, JointType::revolute, left, addBar(14.0, 4.0), Point(12.0, 4.0));
    return scene;
}

}  // namespace scenes
