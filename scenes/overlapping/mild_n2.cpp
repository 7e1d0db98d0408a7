// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mild n²: n tables on one spot and n spaceships on another, each body of several fixtures, over an edge. Size → scene.
// Tsamis 2020, §8.1, after the compound shapes of Box2D's testbed.

#include "scenes/build.h"

namespace scenes {

Scene MildNSquared(int n) {
    Scene scene;
    Reserve(scene, 1 + 2 * n, 1 + 5 * n);
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(50.0, 0.0), Point(-50.0, 0.0)));
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(-5.0, 1.0));
        AddFixture(scene, Box(3.0, 0.5, Point(0.0, 3.5)), 2.0);
        AddFixture(scene, Box(0.5, 2.0, Point(-2.5, 2.0)), 2.0);
        AddFixture(scene, Box(0.5, 2.0, Point(2.5, 2.0)), 2.0);
    }
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(15.0, 1.0));
        AddFixture(scene, Polygon({{-2.0f, 0.0f}, {1.0f, 2.0f}, {0.0f, 4.0f}}), 2.0);
        AddFixture(scene, Polygon({{2.0f, 0.0f}, {0.0f, 4.0f}, {-1.0f, 2.0f}}), 2.0);
    }
    return scene;
}

}  // namespace scenes
