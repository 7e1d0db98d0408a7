// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bullets: n fast disks, the last bodies, fly at 120 m/s into a heap of 300 boxes.

#include "scenes/build.h"

namespace scenes {

Scene Bullets(int n) {
    Scene scene;
    AddFlatGround(scene, 200.0);
    scene.fixtures.back().friction = 0.6f;
    for (int i = 0; i < 300; ++i) {
        AddBody(scene, BodyType::dynamic, Point(0.95 * (i % 20) + 0.02 * (i % 7), 0.5 + 1.02 * (i / 20)));
        AddFixture(scene, Box(0.45, 0.45), 1.0).friction = 0.6f;
    }
    for (int i = 0; i < n; ++i) {
        Body& body = AddBody(scene, BodyType::dynamic, Point(-60.0, 1.0 + 0.5 * i));
        body.bullet = true;
        body.linearVelocity = Point(120.0, 0.0);
        AddFixture(scene, Circle(0.15), 3.0);
    }
    return scene;
}

}  // namespace scenes
