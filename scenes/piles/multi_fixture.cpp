// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Multi-fixture: tables cut into up to 150 fixtures each fall into a tray. Size → scene. Tsamis 2020, §8.1.

#include "scenes/build.h"

namespace scenes {

namespace {

// Table i and its slices. A hundred tables use up the slice counts 50 … 1; beyond, the hundred is repeated 85 m higher
// (17 rows of 5 m), where it overlaps nothing.
void AddTable(Scene& scene, int number) {
    const int i = number % 100;
    const int slices = 50 - i / 2;
    AddBody(scene, BodyType::dynamic,
            Point(-20.0 + 7.0 * (i % 6) + i / 10, 1.0 + 5.0 * (i / 6) + 85.0 * (number / 100)));
    const double b = 2.0 / slices;
    for (int z = 0; z < slices; ++z) {
        const double p = 2.0 * z * b + b;
        AddFixture(scene, Box(0.5, b, Point(-1.5, p)), b);
        AddFixture(scene, Box(0.5, b, Point(1.5, p)), b);
        AddFixture(scene, Box(b, 0.5, Point(p - 2.0, 3.5)), b);
    }
}

}  // namespace

Scene MultiFixture(int n) {
    Scene scene;
    Reserve(scene, n + 1, 3 + (n / 100 + 1) * 7650);
    AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Box(35.0, 1.0));
    AddFixture(scene, Box(1.0, 25.0, Point(-36.0, 24.0)));
    AddFixture(scene, Box(1.0, 25.0, Point(36.0, 24.0)));
    for (int i = 0; i < n; ++i) AddTable(scene, i);
    return scene;
}

}  // namespace scenes
