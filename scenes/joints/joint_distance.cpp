// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Distance joints: five boxes hang from a beam. They hang by a rod, a rope, a spring, a damped spring, and a spring
// that may only go from 2 m to 5 m.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointDistance(int) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, Point(0.0, 12.0));
    AddFixture(scene, Box(14.0, 0.25, Point(0.0, 0.25)));
    const auto addBox = [&scene](double x, double y) {
        AddBody(scene, BodyType::dynamic, Point(x, y));
        AddFixture(scene, Box(0.5, 0.5), 5.0);
        return LastBody(scene);
    };
    constexpr double mass = 5.0;
    const auto setSpring = [](Joint& joint, double hertz, double dampingRatio) {
        const Spring spring = MakeSpring(mass, hertz, dampingRatio);
        joint.stiffness = spring.stiffness;
        joint.damping = spring.damping;
    };
    const auto add = [&](double x, Vec2 box) -> Joint& {
        return AddDistance(scene, 0, addBox(box.x, box.y), Point(x, 12.0), box);
    };
    add(-12.0, Point(-9.0, 8.0));  // a rod of 5 m, let go at an angle
    Joint& rope = add(-6.0, Point(-4.0, 11.0));
    rope.minLength = 0.0f;
    rope.maxLength = 5.0f;
    Joint& spring = add(1.0, Point(1.0, 8.0));
    spring.minLength = 0.0f;
    spring.maxLength = Joint{}.maxLength;
    setSpring(spring, 0.7, 0.0);
    Joint& damped = add(5.0, Point(5.0, 8.0));
    damped.minLength = 0.0f;
    damped.maxLength = Joint{}.maxLength;
    setSpring(damped, 0.7, 0.5);
    Joint& limited = add(10.0, Point(10.0, 8.5));
    limited.minLength = 2.0f;
    limited.maxLength = 5.0f;
    setSpring(limited, 0.5, 0.1);
    return scene;
}

}  // namespace scenes
