// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mostly static, one body: n circles slide through a corridor in one static body of up to n² box fixtures. Size →
// scene. Tsamis 2020, §8.1.

#include <vector>

#include "scenes/static/static_grid.h"

namespace scenes {

Scene MostlyStaticSingle(int n) {
    Scene scene;
    Reserve(scene, n + 1, n + StaticGridBoxes(n));
    AddBody(scene, BodyType::isStatic, Point(0.0, -gridHalfCell));
    // A body's fixtures are contiguous, so the circles wait until the static body is complete.
    std::vector<Vec2> circles;
    ForEachGridCell(
        n, [&scene](Vec2 center) { AddFixture(scene, Box(gridHalfCell, gridHalfCell, center)); },
        [&circles](Vec2 center) { circles.push_back(center); });
    for (Vec2 center : circles) AddDiagonalCircle(scene, center);
    return scene;
}

}  // namespace scenes
