// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bridge: n planks on revolute joints hang between two piers; two triangles and three balls fall on them. Size → scene.
// After Box2D's testbed.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene Bridge(int n) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Box(2.0, 2.5, Point(-0.5 * n - 2.0, 2.5)));
    AddFixture(scene, Box(2.0, 2.5, Point(0.5 * n + 2.0, 2.5)));
    AddFixture(scene, Edge(Point(-0.5 * n - 4.0, 0.0), Point(0.5 * n + 4.0, 0.0)));
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(-0.5 * n + 0.5 + i, 4.875));
        AddFixture(scene, Box(0.5, 0.125), 20.0);
        AddJoint(scene, JointType::revolute, i, i + 1, Point(-0.5 * n + i, 4.875));  // body 0 is the piers
    }
    AddJoint(scene, JointType::revolute, 0, LastBody(scene), Point(0.5 * n, 4.875));
    for (int i = 0; i < 2; ++i) {
        AddBody(scene, BodyType::dynamic, Point(n * (0.25 * i - 0.25), 8.0));
        AddFixture(scene, Polygon({Point(-0.5, 0.0), Point(0.5, 0.0), Point(0.0, 1.5)}), 1.0);
    }
    for (int i = 0; i < 3; ++i) {
        AddBody(scene, BodyType::dynamic, Point(n * (0.15 * i - 0.1), 10.0));
        AddFixture(scene, Circle(0.5), 1.0);
    }
    return scene;
}

}  // namespace scenes
