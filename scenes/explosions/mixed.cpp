// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Mixed: a dense spiral of circles explodes inside a static body of some 8400 circles with a round hole. Size → scene.
// Tsamis 2020, §8.1.

#include "scenes/build.h"

namespace scenes {

Scene Mixed(int n) {
    constexpr int center = 75;
    constexpr int holeRadius = 67;
    Scene scene;
    Reserve(scene, n + 1, n + 150 * 150);
    AddBody(scene, BodyType::isStatic, {});
    for (int x = 0; x < 150; ++x) {
        for (int y = 0; y < 150; ++y) {
            const int dx = x - center;
            const int dy = y - center;
            if (dx * dx + dy * dy > holeRadius * holeRadius) AddFixture(scene, Circle(0.5, Point(x, y)));
        }
    }
    for (int i = 0; i < n; ++i) {
        const double s = static_cast<double>(i) / n;
        const auto [sin, cos] = SinCos(30.0 * s);
        const double qx = cos * (50.0 * s + 10.0);
        const double qy = sin * (50.0 * s + 10.0);
        AddBody(scene, BodyType::dynamic, Point(qx + center, qy + center)).linearVelocity = Point(qx, qy);
        AddFixture(scene, Circle(0.5), 0.5);
    }
    return scene;
}

}  // namespace scenes
