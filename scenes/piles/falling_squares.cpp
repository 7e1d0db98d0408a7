// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Falling squares: 15 columns of dynamic squares of growing size collapse onto a ground. Size → scene. Tsamis 2020,
// §8.1.

#include "scenes/piles/falling_columns.h"

namespace scenes {

Scene FallingSquares(int n) {
    Scene scene;
    BuildFallingColumns(scene, n, [&scene](int i, int j, int rows, double a, Vec2 origin) {
        AddBody(scene, BodyType::dynamic, Point(origin.x + (7.0 * i - 30.0), origin.y + 2.0 * a * (rows - j)));
        AddFixture(scene, Box(a, a), 5.0);
    });
    return scene;
}

}  // namespace scenes
