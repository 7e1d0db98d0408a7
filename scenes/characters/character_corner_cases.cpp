// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Character corner cases: figures that must not catch where a surface has seams. Four tracks lie above each other: of
// two-sided edges, of a chain, of square tiles, and of a chain with ramps and steps. On each slide a box, a capsule, a
// ball and a hexagon without friction or rotation. Above them one stands on a moving platform, one on a lift.

#include <vector>

#include "scenes/build.h"

namespace scenes {

namespace {

constexpr double halfTrack = 20.0, floorHeight = 6.0, walkingSpeed = 4.0;

Fixture& AddSlippery(Scene& scene, const Shape& shape, double density = 0.0) {
    Fixture& fixture = AddFixture(scene, shape, density);
    fixture.friction = 0.0f;
    return fixture;
}

void AddFigure(Scene& scene, int kind, Vec2 feet, double speed) {
    Body& body = AddBody(scene, BodyType::dynamic, feet);
    body.fixedRotation = true;
    body.allowSleep = false;
    body.linearVelocity = Point(speed, 0.0);
    switch (kind) {
        case 0:
            AddSlippery(scene, Box(0.3, 0.6, Point(0.0, 0.6)), 20.0);
            return;
        case 1:  // a capsule of two circles and a box
            AddSlippery(scene, Circle(0.3, Point(0.0, 0.3)), 20.0);
            AddSlippery(scene, Box(0.3, 0.3, Point(0.0, 0.6)), 20.0);
            AddSlippery(scene, Circle(0.3, Point(0.0, 0.9)), 20.0);
            return;
        case 2:
            AddSlippery(scene, Circle(0.4, Point(0.0, 0.4)), 20.0);
            return;
        default:  // stands on a corner
            AddSlippery(scene, RegularPolygon(6, 0.5, Point(0.0, 0.4330127)), 20.0);
            return;
    }
}

void AddFigures(Scene& scene, double height) {
    for (int kind = 0; kind < 4; ++kind) AddFigure(scene, kind, Point(-17.0 + 2.5 * kind, height + 0.01), walkingSpeed);
}

// From right to left, so that the upper side is the one that collides.
std::vector<Vec2> Reversed(const std::vector<Vec2>& points) { return {points.rbegin(), points.rend()}; }

void AddTracks(Scene& scene) {
    AddBody(scene, BodyType::isStatic, {});
    for (int i = 0; i < 40; ++i) AddSlippery(scene, Edge(Point(i - halfTrack, 0.0), Point(i + 1 - halfTrack, 0.0)));

    std::vector<Vec2> flat;
    for (int i = 0; i <= 40; ++i) flat.push_back(Point(i - halfTrack, floorHeight));
    AddSlippery(scene, Chain(scene, Reversed(flat)));

    for (int i = 0; i < 40; ++i) {
        AddSlippery(scene, Box(0.5, 0.5, Point(i + 0.5 - halfTrack, 2.0 * floorHeight - 0.5)));
    }

    const double y = 3.0 * floorHeight;
    AddSlippery(scene, Chain(scene, Reversed({Point(-20.0, y), Point(-6.0, y), Point(-4.0, y + 0.5),
                                              Point(-1.0, y + 0.5), Point(1.0, y), Point(6.0, y), Point(6.0, y - 0.5),
                                              Point(12.0, y - 0.5), Point(16.0, y + 0.3), Point(20.0, y + 0.3)})));
    for (int floor = 0; floor < 4; ++floor) {
        for (const double x : {-halfTrack, halfTrack}) {
            AddSlippery(scene, Edge(Point(x, floor * floorHeight), Point(x, floor * floorHeight + 3.0)));
        }
    }
}

void AddPlatform(Scene& scene, Vec2 position, Vec2 velocity) {
    AddBody(scene, BodyType::kinematic, position).linearVelocity = velocity;
    AddFixture(scene, Box(2.0, 0.2, Point(0.0, -0.2))).friction = 0.9f;
}

}  // namespace

Scene CharacterCornerCases(int) {
    Scene scene;
    AddTracks(scene);
    for (int floor = 0; floor < 4; ++floor) AddFigures(scene, floor * floorHeight);
    const double top = 4.0 * floorHeight;
    AddPlatform(scene, Point(-12.0, top), Point(1.5, 0.0));
    AddPlatform(scene, Point(10.0, top - 1.5), Point(0.0, 1.0));
    for (const double x : {-12.0, 10.0}) {
        AddFigure(scene, 1, Point(x, x < 0.0 ? top : top - 1.5), x < 0.0 ? 1.5 : 0.0);
        for (int i = scene.bodies.back().firstFixture; i < static_cast<int>(scene.fixtures.size()); ++i) {
            scene.fixtures[static_cast<std::size_t>(i)].friction = 0.9f;
        }
    }
    return scene;
}

}  // namespace scenes
