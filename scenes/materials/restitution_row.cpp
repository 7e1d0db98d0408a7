// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Restitution row: n balls fall from one height; ball i has restitution i / (n − 1). Size → scene. After Box2D's
// testbed.

#include "scenes/build.h"

namespace scenes {

Scene RestitutionRow(int n) {
    Scene scene;
    Reserve(scene, n + 1, n + 1);
    AddFlatGround(scene, 1.5 * n + 3.0);
    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(3.0 * (i - 0.5 * (n - 1)), 12.0));
        AddFixture(scene, Circle(1.0), 20.0).restitution = static_cast<float>(static_cast<double>(i) / (n - 1));
    }
    return scene;
}

}  // namespace scenes
