// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Platformer: a long level of a chain, with blocks in the air, sensors and crates. n figures, the last bodies, run over
// it. Each is a box on a ball that cannot turn.

#include "scenes/games/terrain.h"

namespace scenes {

namespace {

// Level for a figure, m; one block every 2 m, a sensor and a crate every 6 m.
constexpr double lengthEach = 10.0;
constexpr int blocksEach = 5, lengthBetween = 6;

double LevelAt(double x) { return 1.5 * SinCos(0.05 * x).sin + 0.4 * SinCos(0.31 * x).sin; }

void AddFigure(Scene& scene, double x, double speed) {
    Body& body = AddBody(scene, BodyType::dynamic, Point(x, LevelAt(x) + 2.0));
    body.fixedRotation = true;
    body.linearVelocity = Point(speed, 0.0);
    AddFixture(scene, Box(0.3, 0.6), 1.0).friction = 0.1f;
    AddFixture(scene, Circle(0.3, Point(0.0, -0.6)), 1.0).friction = 0.1f;
}

}  // namespace

Scene Platformer(int n) {
    Scene scene;
    const int places = static_cast<int>(lengthEach) * n / lengthBetween;
    AddTerrain(scene, lengthEach * n, 0.25, LevelAt);
    for (int i = 0; i < blocksEach * n; ++i) {
        AddBody(scene, BodyType::isStatic, Point(2.0 * i, LevelAt(2.0 * i) + 4.0 + i % 3));
        AddFixture(scene, Box(0.8, 0.2));
    }
    for (int i = 0; i < places; ++i) {
        const double x = lengthBetween * i + 3.0;
        AddBody(scene, BodyType::isStatic, Point(x, LevelAt(x) + 1.0));
        AddFixture(scene, Circle(0.5)).isSensor = true;
    }
    for (int i = 0; i < places; ++i) {
        const double x = lengthBetween * i + 1.0;
        AddBody(scene, BodyType::dynamic, Point(x, LevelAt(x) + 0.6));
        AddFixture(scene, Box(0.4, 0.4), 1.0).friction = 0.6f;
    }
    for (int i = 0; i < n; ++i) AddFigure(scene, 9.0 * i + 5.0, i % 2 == 0 ? 3.0 : -3.0);
    return scene;
}

}  // namespace scenes
