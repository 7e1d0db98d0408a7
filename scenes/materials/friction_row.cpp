// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Friction row: n boxes on n ramps of 20 degrees; box and ramp i have friction 0.8 i / (n − 1). Those above
// tan 20° = 0.364 stay. Size → scene. After Box2D's testbed.

#include "scenes/build.h"

namespace scenes {

Scene FrictionRow(int n) {
    Scene scene;
    Reserve(scene, n + 1, 2 * n + 1);
    constexpr double angle = 20.0 * pi / 180.0;
    const auto [sin, cos] = SinCos(angle);
    constexpr double pitch = 9.0, halfLength = 4.0, halfBox = 0.5;
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(-5.0, 0.0), Point(pitch * n, 0.0)));
    const auto frictionOf = [n](int i) { return static_cast<float>(0.8 * i / (n - 1)); };
    // Ramp i descends to the left from its top; the box stands flush near the top.
    const auto along = [&](int i, double distance, double height) {
        return Point(pitch * i + distance * cos - height * sin, 2.0 + distance * sin + height * cos);
    };
    for (int i = 0; i < n; ++i) {
        AddFixture(scene, Box(halfLength, 0.1, along(i, 0.0, -0.1), angle)).friction = frictionOf(i);
    }
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, along(i, halfLength - 1.0, halfBox)).angle = static_cast<float>(angle);
        AddFixture(scene, Box(halfBox, halfBox), 25.0).friction = frictionOf(i);
    }
    return scene;
}

}  // namespace scenes
