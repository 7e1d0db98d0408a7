// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tiles: an inverted pyramid of n(n+1)/2 boxes above a ground that is one static body of 2000 fixtures. Size → scene.
// Tsamis 2020, §3.8 (figures 7 and 8), after Box2D's testbed.

#include "scenes/build.h"

namespace scenes {

Scene Tiles(int n) {
    Scene scene;
    Reserve(scene, 1 + n * (n + 1) / 2, 2000 + n * (n + 1) / 2);
    AddBody(scene, BodyType::isStatic, Point(0.0, -0.5));
    for (int j = 0; j < 10; ++j) {
        for (int i = 0; i < 200; ++i) AddFixture(scene, Box(0.5, 0.5, Point(-100.0 + i, -j)));
    }
    for (int i = 0; i < n; ++i) {
        for (int j = i; j < n; ++j) {
            AddBody(scene, BodyType::dynamic, Point(-7.0 + 0.5625 * i + 1.125 * (j - i), 190.0 - 0.75 - 1.25 * i));
            AddFixture(scene, Box(0.5, 0.5), 5.0);
        }
    }
    return scene;
}

}  // namespace scenes
