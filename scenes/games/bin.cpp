// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bin: n small disks and boxes fall into a bin 24 m wide.

#include "scenes/build.h"

namespace scenes {

Scene Bin(int n) {
    Scene scene;
    AddFlatGround(scene, 20.0);
    scene.fixtures.back().friction = 0.6f;
    for (const double x : {-12.0, 12.0}) AddFixture(scene, Edge(Point(x, 0.0), Point(x, 200.0)));
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.55 * (i % 40) - 10.8 + 0.01 * (i % 7), 1.0 + 0.6 * (i / 40)));
        AddFixture(scene, i % 2 == 0 ? Circle(0.25) : Box(0.25, 0.25), 1.0);
    }
    return scene;
}

}  // namespace scenes
