// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pyramid: n(n+1)/2 boxes settle into a pyramid of n rows. Size → scene. After Box2D's testbed.

#include "scenes/build.h"

namespace scenes {

Scene Pyramid(int n) {
    Scene scene;
    const int boxes = n * (n + 1) / 2;
    Reserve(scene, 1 + boxes, 1 + boxes);
    AddFlatGround(scene, 0.6 * n + 4.0);
    for (int row = 0; row < n; ++row) {
        for (int i = 0; i < n - row; ++i) {
            AddBody(scene, BodyType::dynamic, Point(1.125 * (i - 0.5 * (n - row - 1)), 0.5 + 1.05 * row));
            AddFixture(scene, Box(0.5, 0.5), 5.0);
        }
    }
    return scene;
}

}  // namespace scenes
