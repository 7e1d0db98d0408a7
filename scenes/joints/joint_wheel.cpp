// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Wheel joints: four carts fall on the ground, with soft, hard, undamped and no springs but a limit; the wheels of the
// first two are driven.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

namespace {

struct Suspension {
    double hertz, dampingRatio;
    bool isDriven;
};

void AddCart(Scene& scene, double x, const Suspension& suspension) {
    AddBody(scene, BodyType::dynamic, Point(x, 3.0));
    AddFixture(scene, Box(1.5, 0.25), 2.0);
    const int cart = LastBody(scene);
    for (const double side : {-1.0, 1.0}) {
        const Vec2 center = Point(x + side, 2.0);
        AddBody(scene, BodyType::dynamic, center);
        AddFixture(scene, Circle(0.5), 1.0).friction = 0.9f;
        Joint& joint = AddWheel(scene, cart, LastBody(scene), center, Point(0.0, 1.0));
        const Spring spring = MakeSpring(1.5, suspension.hertz, suspension.dampingRatio);  // half the cart
        joint.stiffness = spring.stiffness;
        joint.damping = spring.damping;
        joint.enableLimit = true;
        joint.lowerTranslation = -0.4f;
        joint.upperTranslation = 0.4f;
        joint.enableMotor = suspension.isDriven;
        joint.motorSpeed = -3.0f;
        joint.maxMotorTorque = 5.0f;
    }
}

}  // namespace

Scene JointWheel(int) {
    Scene scene;
    AddFlatGround(scene, 16.0);
    AddCart(scene, 6.0, {.hertz = 2.0, .dampingRatio = 0.4, .isDriven = true});
    AddCart(scene, 0.0, {.hertz = 6.0, .dampingRatio = 0.7, .isDriven = true});
    AddCart(scene, -6.0, {.hertz = 2.0, .dampingRatio = 0.0, .isDriven = false});
    AddCart(scene, -12.0, {.hertz = 0.0, .dampingRatio = 0.0, .isDriven = false});
    return scene;
}

}  // namespace scenes
