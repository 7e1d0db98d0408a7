// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pulley: a rope with ratio 1.5 over two wheels holds two boxes of equal mass; the side with the smaller pull rises.
// After Box2D's testbed.

#include "scenes/build.h"
#include "scenes/build_joints.h"

namespace scenes {

Scene Pulley(int) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Circle(1.0, Point(-6.0, 16.0)));
    AddFixture(scene, Circle(1.0, Point(6.0, 16.0)));
    AddFixture(scene, Edge(Point(-15.0, 0.0), Point(15.0, 0.0)));
    for (const double x : {-6.0, 6.0}) {
        AddBody(scene, BodyType::dynamic, Point(x, 7.0));
        AddFixture(scene, Box(1.0, 2.0), 5.0);
    }
    AddPulley(scene, 1, 2,
              {.groundA = Point(-6.0, 15.0),
               .groundB = Point(6.0, 15.0),
               .anchorA = Point(-6.0, 9.0),
               .anchorB = Point(6.0, 9.0)})
        .ratio = 1.5f;
    return scene;
}

}  // namespace scenes
