// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Weld joints: a rigid and an elastic arm on a wall, and a cross of four bars welded together that falls on a corner.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene JointWeld(int) {
    Scene scene;
    AddFlatGround(scene, 10.0);
    AddFixture(scene, Box(0.5, 5.0, Point(-8.0, 5.0)));
    const auto addBar = [&scene](Vec2 position, double angle) {
        AddBody(scene, BodyType::dynamic, position).angle = static_cast<float>(angle);
        AddFixture(scene, Box(1.5, 0.2), 5.0);
        return LastBody(scene);
    };
    AddJoint(scene, JointType::weld, 0, addBar(Point(-6.0, 8.0), 0.0), Point(-7.5, 8.0));
    Joint& elastic = AddJoint(scene, JointType::weld, 0, addBar(Point(-6.0, 4.0), 0.0), Point(-7.5, 4.0));
    const Spring spring = MakeSpring(6.0 * (1.5 * 1.5 + 0.2 * 0.2) / 3.0 + 6.0 * 1.5 * 1.5, 2.0, 0.2);
    elastic.stiffness = spring.stiffness;
    elastic.damping = spring.damping;

    constexpr double turn = 0.3;
    int hub = 0;
    for (int i = 0; i < 4; ++i) {
        const double angle = turn + 0.5 * pi * i;
        const auto [sin, cos] = SinCos(angle);
        // Bars that are welded to the hub but not to each other must not collide.
        const int bar = addBar(Point(3.0 + 1.5 * cos, 6.0 + 1.5 * sin), angle);
        scene.fixtures.back().groupIndex = -1;
        if (i == 0) {
            hub = bar;
        } else {
            AddJoint(scene, JointType::weld, hub, bar, Point(3.0, 6.0));
        }
    }
    return scene;
}

}  // namespace scenes
