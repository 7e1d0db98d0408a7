// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sensors: n balls fall through sensors of every shape, static and carried by a kinematic and by a dynamic body, onto a
// ground. Sensors report and never push. Size → scene.

#include "scenes/build.h"

namespace scenes {

Scene Sensors(int n) {
    Scene scene;
    AddFlatGround(scene, 24.0);
    AddFixture(scene, Edge(Point(-24.0, 0.0), Point(-24.0, 12.0)));
    AddFixture(scene, Edge(Point(24.0, 0.0), Point(24.0, 12.0)));
    AddFixture(scene, Circle(3.0, Point(-14.0, 8.0))).isSensor = true;
    AddFixture(scene, Box(3.0, 1.5, Point(-5.0, 6.0), 0.4)).isSensor = true;
    AddFixture(scene, RegularPolygon(5, 2.5, Point(4.0, 8.0))).isSensor = true;
    AddFixture(scene, Edge(Point(9.0, 5.0), Point(18.0, 7.0))).isSensor = true;

    // A bar that turns through the balls, and a box that carries a cone ahead of it.
    Body& bar = AddBody(scene, BodyType::kinematic, Point(14.0, 11.0));
    bar.angularVelocity = 1.0f;
    AddFixture(scene, Box(4.0, 0.2)).isSensor = true;
    Body& guard = AddBody(scene, BodyType::dynamic, Point(-22.0, 0.8));
    guard.linearVelocity = Point(3.0, 0.0);
    guard.fixedRotation = true;
    AddFixture(scene, Box(0.6, 0.8), 5.0).friction = 0.0f;
    AddFixture(scene, Polygon({Point(0.6, 0.4), Point(5.6, -0.6), Point(5.6, 2.0)}), 0.0).isSensor = true;

    for (int i = 0; i < n; ++i) {
        AddBody(scene, BodyType::dynamic, Point(-18.0 + 37.0 * (i % 12) / 11.0, 14.0 + 2.5 * (i / 12) + 0.7 * (i % 3)));
        AddFixture(scene, Circle(0.5), 1.0);
    }
    return scene;
}

}  // namespace scenes
