// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// n²: circles nearly on one spot, where every pair is real and no broad phase can help. Size → scene. Tsamis 2020,
// §8.1.

#include "scenes/build.h"

namespace scenes {

Scene NSquared(int n) {
    Scene scene;
    Reserve(scene, n, n);
    for (int j = 0; j < n; ++j) {
        AddBody(scene, BodyType::dynamic, Point(0.01 * j, 0.01 * j));
        AddFixture(scene, Circle(1.0), 1.0);
    }
    return scene;
}

}  // namespace scenes
