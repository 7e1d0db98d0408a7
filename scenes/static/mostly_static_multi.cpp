// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mostly static, many bodies: n circles slide through a corridor between up to n² static bodies of one box each.
// Size → scene. Tsamis 2020, §8.1.

#include "scenes/static/static_grid.h"

namespace scenes {

Scene MostlyStaticMulti(int n) {
    Scene scene;
    Reserve(scene, n + StaticGridBoxes(n), n + StaticGridBoxes(n));
    ForEachGridCell(
        n,
        [&scene](Vec2 center) {
            AddBody(scene, BodyType::isStatic, center);
            AddFixture(scene, Box(gridHalfCell, gridHalfCell));
        },
        [&scene](Vec2 center) { AddDiagonalCircle(scene, center); });
    return scene;
}

}  // namespace scenes
