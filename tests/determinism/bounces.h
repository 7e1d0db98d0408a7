// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene of what the catalogue has little of: boxes, disks and polygons that bounce, with one point and with two. They
// meet walls, each other, and bodies that move on their own.

#pragma once

#include "scenes/build.h"

namespace determinism {

/// A closed room, 32 × 16 m, with a turning bar, a lift and a ram, and 96 things that fly about.
inline scenes::Scene BuildBounces() {
    constexpr double halfWidth = 16.0, height = 16.0;
    scenes::Scene scene;
    scene.name = "bounces";
    scenes::Random random(11);
    const auto bounce = [&](scenes::Fixture& fixture, double restitution, double friction) {
        fixture.restitution = static_cast<float>(restitution), fixture.friction = static_cast<float>(friction);
    };
    AddBody(scene, scenes::BodyType::isStatic, {});
    bounce(AddFixture(scene, scenes::Box(halfWidth, 0.5, scenes::Point(0.0, -0.5))), 0.4, 0.6);
    bounce(AddFixture(scene, scenes::Box(halfWidth, 0.5, scenes::Point(0.0, height + 0.5))), 1.0, 0.0);
    for (const double side : {-1.0, 1.0}) {
        bounce(AddFixture(scene, scenes::Box(0.5, height, scenes::Point(side * (halfWidth + 0.5), 0.5 * height))), 0.8,
               0.2);
    }
    struct Mover {
        double x, y, halfX, halfY, vx, vy, turn;
    };
    for (const Mover& mover : {Mover{0.0, 8.0, 4.0, 0.25, 0.0, 0.0, 5.0}, Mover{-11.0, 0.0, 3.0, 0.5, 0.0, 4.0, 0.0},
                               Mover{15.0, 4.0, 0.5, 3.0, -9.0, 0.0, 0.0}}) {
        scenes::Body& body = AddBody(scene, scenes::BodyType::kinematic, scenes::Point(mover.x, mover.y));
        body.linearVelocity = scenes::Point(mover.vx, mover.vy);
        body.angularVelocity = static_cast<float>(mover.turn);
        bounce(AddFixture(scene, scenes::Box(mover.halfX, mover.halfY)), 0.9, 0.5);
    }
    for (int i = 0; i < 96; ++i) {
        const double x = -14.0 + 2.5 * (i % 12), y = 1.5 + 1.75 * (i / 12);
        scenes::Body& body = AddBody(scene, scenes::BodyType::dynamic, scenes::Point(x, y));
        // One draw a statement: compilers differ in the order of arguments.
        const double vx = random.Uniform(-8.0, 8.0), vy = random.Uniform(-8.0, 8.0);
        body.linearVelocity = scenes::Point(vx, vy);
        // A third falls flat.
        if (i % 3 != 0) body.angularVelocity = static_cast<float>(random.Uniform(-4.0, 4.0));
        const double size = random.Uniform(0.2, 0.6);
        const scenes::Shape shape = i % 4 == 0   ? scenes::Circle(size)
                                    : i % 4 == 1 ? scenes::RegularPolygon(3 + i % 5, size)
                                                 : scenes::Box(size, 0.7 * size);
        const double density = random.Uniform(0.5, 50.0);
        const double restitution = random.Uniform(0.0, 1.0), friction = random.Uniform(0.0, 1.0);
        bounce(AddFixture(scene, shape, density), restitution, friction);
    }
    return scene;
}

}  // namespace determinism
