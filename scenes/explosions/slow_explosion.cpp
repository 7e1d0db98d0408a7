// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Slow explosion: circles on a spiral, moving outwards without gravity; nearly everything moves and little touches.
// Size → scene. Tsamis 2020, §8.1.

#include <cmath>

#include "scenes/build.h"

namespace scenes {

Scene SlowExplosion(int n) {
    Scene scene;
    scene.gravity = {};
    Reserve(scene, n, n);
    // Above the published sizes the area grows with n, so the density of bodies stays; velocities keep their size.
    const double spread = n > 6000 ? std::sqrt(n / 6000.0) : 1.0;
    for (int i = 0; i < n; ++i) {
        const double s = 10.0 * i / n;
        const auto [sin, cos] = SinCos(30.0 * s);
        const double qx = cos * (30.0 * s + 5.0);
        const double qy = sin * (30.0 * s + 5.0);
        AddBody(scene, BodyType::dynamic, Point(spread * qx, spread * qy)).linearVelocity = Point(0.2 * qx, 0.2 * qy);
        AddFixture(scene, Circle(0.5), 0.5);
    }
    return scene;
}

}  // namespace scenes
