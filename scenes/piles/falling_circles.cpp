// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Falling circles: 15 leaning columns of dynamic circles fall onto a ground. Size → scene. Tsamis 2020, §8.1.

#include "scenes/piles/falling_columns.h"

namespace scenes {

Scene FallingCircles(int n) {
    Scene scene;
    BuildFallingColumns(scene, n, [&scene](int i, int j, int rows, double a, Vec2 origin) {
        AddBody(scene, BodyType::dynamic,
                Point(origin.x + (7.0 * i + 0.25 * j - 100.0), origin.y + 2.0 * a * (rows - j)));
        AddFixture(scene, Circle(a / 2.0), 5.0);
    });
    return scene;
}

}  // namespace scenes
