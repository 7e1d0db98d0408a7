// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mouse joints. A bar gripped at one end is pulled up, and a box gripped at its corner swings to its target. A ball is
// pulled by too little force to lift it, and a box is torn out of a stack.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointMouse(int) {
    Scene scene;
    AddFlatGround(scene, 16.0);
    const auto add = [&scene](const Shape& shape, Vec2 position) {
        AddBody(scene, BodyType::dynamic, position);
        AddFixture(scene, shape, 1.0);
        return LastBody(scene);
    };
    // 5 Hz and a damping ratio of 0.7 are what a user's hand gets in Box2D's testbed.
    const auto pull = [&scene](int body, Vec2 grip, Vec2 target, double mass, double maxForce) {
        Joint& joint = AddMouse(scene, 0, body, grip, target);
        const Spring spring = MakeSpring(mass, 5.0, 0.7);
        joint.stiffness = spring.stiffness;
        joint.damping = spring.damping;
        joint.maxForce = static_cast<float>(maxForce);
    };
    pull(add(Box(2.0, 0.25), Point(-11.0, 0.25)), Point(-9.0, 0.25), Point(-9.0, 7.0), 2.0, 200.0);
    pull(add(Box(0.75, 0.75), Point(-5.0, 4.0)), Point(-4.25, 4.75), Point(-3.0, 6.0), 2.25, 200.0);
    pull(add(Circle(1.0), Point(2.0, 1.0)), Point(2.0, 1.5), Point(2.0, 6.0), 3.1, 20.0);
    for (int i = 0; i < 4; ++i) {
        const int box = add(Box(0.5, 0.5), Point(9.0, 0.5 + i));
        if (i == 1) pull(box, Point(8.6, 1.5), Point(5.5, 3.0), 1.0, 1000.0);
    }
    return scene;
}

}  // namespace scenes
