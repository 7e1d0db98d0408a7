// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Conveyor: three belts above each other, the middle one running back, carry boxes, balls and triangles down to a
// bin. Belts are boxes whose surface has a tangent speed; they do not move.

#include "scenes/build.h"

namespace scenes {

Scene Conveyor(int) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    for (int i = 0; i < 3; ++i) {
        const bool goesRight = i % 2 == 0;
        // From one wall to a gap before the other.
        Fixture& belt = AddFixture(scene, Box(8.5, 0.3, Point(goesRight ? -2.5 : 2.5, 12.0 - 4.0 * i)));
        belt.friction = 0.8f;
        belt.tangentSpeed = goesRight ? 4.0f : -3.0f;
    }
    AddFixture(scene, Box(11.0, 0.3));
    for (const double side : {-1.0, 1.0}) AddFixture(scene, Box(0.2, 7.5, Point(11.2 * side, 7.2)));
    for (int i = 0; i < 9; ++i) {
        AddBody(scene, BodyType::dynamic, Point(-9.5 + 1.6 * i, 13.0));
        const Shape shape = i % 3 == 0 ? Box(0.45, 0.45) : i % 3 == 1 ? Circle(0.45) : RegularPolygon(3, 0.6);
        AddFixture(scene, shape, 2.0).friction = 0.6f;
    }
    return scene;
}

}  // namespace scenes
