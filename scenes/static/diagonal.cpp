// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Diagonal: 3000 circles rain through rows of static slabs turned by 45°, whose bounding boxes are far larger than they
// are. Size → scene. Tsamis 2020, §8.1.

#include "scenes/build.h"

namespace scenes {

Scene Diagonal(int n) {
    constexpr double a = 0.5;
    constexpr double quarterPi = 0.78539816339744830962;
    constexpr int circles = 3000;
    Scene scene;
    Reserve(scene, n * (n / 2) + circles, n * (n / 2) + circles);
    for (int j = 0; j < n / 2; ++j) {
        for (int i = 0; i < n; ++i) {
            // The published scene applies p twice, as body position and as the box's centre.
            const Vec2 p = Point(-n * a + 8.0 * a * i, -8.0 * a * j);
            AddBody(scene, BodyType::isStatic, p);
            AddFixture(scene, Box(a, (3.0 * j + 1.0) * a, p, quarterPi));
        }
    }
    for (int i = 0; i < circles; ++i) {
        AddBody(scene, BodyType::dynamic, Point(2.0 * (i / 15) - 75.0, 2.0 * (i % 15) + 50.0));
        AddFixture(scene, Circle(0.5), 1.0);
    }
    return scene;
}

}  // namespace scenes
