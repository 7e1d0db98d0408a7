// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Ray-cast playground: shapes of every kind to cast rays at. n bodies drift without gravity and bounce inside a loop.
// In it are static shapes, one-sided edges, a sensor and two turning kinematic bars. Size → scene.

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/build.h"

namespace scenes {

namespace {

void AddScenery(Scene& scene, double half) {
    AddBody(scene, BodyType::isStatic, {});
    // Clockwise, so that it holds what is inside.
    const std::array<Vec2, 8> wall{Point(-half, half - 2.0),  Point(-half + 2.0, half), Point(half - 2.0, half),
                                   Point(half, half - 2.0),   Point(half, -half + 2.0), Point(half - 2.0, -half),
                                   Point(-half + 2.0, -half), Point(-half, -half + 2.0)};
    AddFixture(scene, Loop(scene, wall)).restitution = 1.0f;
    AddFixture(scene, Circle(1.5, Point(-0.5 * half, 0.5 * half)));
    AddFixture(scene, Box(1.5, 0.8, Point(0.5 * half, 0.5 * half), 0.5));
    AddFixture(scene, RegularPolygon(7, 1.3, Point(-0.5 * half, -0.5 * half)));
    AddFixture(scene, Edge(Point(0.3 * half, -0.6 * half), Point(0.6 * half, -0.4 * half)));
    AddFixture(scene, OneSidedEdge(Point(-1.0, 0.9 * half), Point(-1.0, 0.75 * half), Point(1.0, 0.75 * half),
                                   Point(1.0, 0.9 * half)));
    AddFixture(scene, Circle(2.0)).isSensor = true;
    for (const double side : {-1.0, 1.0}) {
        AddBody(scene, BodyType::kinematic, Point(0.5 * half * side, 0.0)).angularVelocity =
            static_cast<float>(0.7 * side);
        AddFixture(scene, Box(2.0, 0.15));
        AddFixture(scene, Box(0.15, 2.0));
    }
}

}  // namespace

Scene RayCastPlayground(int n) {
    Scene scene;
    scene.gravity = {};
    const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
    const double pitch = 2.5, half = std::max(10.0, 0.5 * pitch * columns + 4.0);
    AddScenery(scene, half);
    Random random(2024);
    for (int i = 0; i < n; ++i) {
        const double angle = random.Uniform(-pi, pi);
        const auto [sin, cos] = SinCos(random.Uniform(-pi, pi));
        Body& body =
            AddBody(scene, BodyType::dynamic,
                    Point(pitch * (i % columns - 0.5 * (columns - 1)), pitch * (i / columns - 0.5 * (columns - 1))));
        body.angle = static_cast<float>(angle);
        body.linearVelocity = Point(2.0 * cos, 2.0 * sin);
        body.angularVelocity = static_cast<float>(random.Uniform(-1.0, 1.0));
        const Shape shapes[] = {Circle(0.5), Box(0.6, 0.3), RegularPolygon(3, 0.6), RegularPolygon(5, 0.5),
                                RegularPolygon(8, 0.5)};
        Fixture& fixture = AddFixture(scene, shapes[i % 5], 1.0);
        fixture.restitution = 1.0f;
        fixture.friction = 0.0f;
    }
    return scene;
}

}  // namespace scenes
