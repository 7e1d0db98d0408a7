// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Slider-crank: a motor turns a crank, a rod follows, and a piston on a prismatic joint throws a box up. After Box2D's
// testbed.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene SliderCrank(int) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, Point(0.0, 5.0));
    AddFixture(scene, Circle(0.3)).maskBits = 0;
    AddFixture(scene, Box(0.2, 5.0, Point(-1.8, 9.0)));
    AddFixture(scene, Box(0.2, 5.0, Point(1.8, 9.0)));
    AddBody(scene, BodyType::dynamic, Point(0.0, 6.0));
    AddFixture(scene, Box(0.25, 1.0), 2.0).maskBits = 0;
    Joint& motor = AddJoint(scene, JointType::revolute, 0, LastBody(scene), Point(0.0, 5.0));
    motor.enableMotor = true;
    motor.motorSpeed = static_cast<float>(pi);
    motor.maxMotorTorque = 1e4f;
    AddBody(scene, BodyType::dynamic, Point(0.0, 9.0));
    AddFixture(scene, Box(0.25, 2.0), 2.0).maskBits = 0;
    AddJoint(scene, JointType::revolute, 1, 2, Point(0.0, 7.0));
    AddBody(scene, BodyType::dynamic, Point(0.0, 11.0));
    AddFixture(scene, Box(1.5, 0.75), 2.0);
    AddJoint(scene, JointType::revolute, 2, 3, Point(0.0, 11.0));
    AddPrismatic(scene, 0, 3, Point(0.0, 11.0), Point(0.0, 1.0));
    AddBody(scene, BodyType::dynamic, Point(0.0, 12.75));
    AddFixture(scene, Box(1.0, 1.0), 2.0);
    return scene;
}

}  // namespace scenes
