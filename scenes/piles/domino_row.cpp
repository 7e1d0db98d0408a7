// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Domino row: a heavy ball hits the first of n dominoes, which fall one after the other. Size → scene.

#include "scenes/build.h"

namespace scenes {

Scene DominoRow(int n) {
    Scene scene;
    Reserve(scene, 2 + n, 2 + n);
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(-4.0, 0.0), Point(0.6 * n + 4.0, 0.0))).friction = 0.6f;
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.6 * i, 0.5));
        AddFixture(scene, Box(0.1, 0.5), 10.0).friction = 0.3f;
    }
    AddBody(scene, BodyType::dynamic, Point(-1.5, 0.9)).linearVelocity = Point(6.0, 1.0);
    AddFixture(scene, Circle(0.15), 20.0);
    return scene;
}

}  // namespace scenes
