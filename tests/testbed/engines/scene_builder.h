// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Small scenes for tests: add bodies with one fixture each.

#pragma once

#include "scenes/scene.h"

namespace testbed::checks {

/// Adds a body with one fixture; returns its index.
inline int AddBody(scenes::Scene& scene, scenes::Body body, const scenes::Shape& shape, float density) {
    body.firstFixture = static_cast<int>(scene.fixtures.size());
    body.fixtureCount = 1;
    scenes::Fixture fixture;
    fixture.shape = shape;
    fixture.density = density;
    scene.fixtures.push_back(fixture);
    scene.bodies.push_back(body);
    return static_cast<int>(scene.bodies.size()) - 1;
}

inline scenes::Shape MakeBoxShape(float hx, float hy) {
    return {.type = scenes::ShapeType::box, .halfExtents = {hx, hy}};
}

inline scenes::Shape MakeCircleShape(float radius, scenes::Vec2 center = {}) {
    return {.type = scenes::ShapeType::circle, .radius = radius, .center = center};
}

inline scenes::Body MakeDynamic(float x, float y) { return {.type = scenes::BodyType::dynamic, .position = {x, y}}; }

/// A box of 1 m standing on a wide ground whose upper side is at y = 1.
inline scenes::Scene RestingBox() {
    scenes::Scene scene;
    scene.name = "resting-box";
    AddBody(scene, {}, MakeBoxShape(20.0f, 1.0f), 0.0f);
    AddBody(scene, MakeDynamic(0.0f, 1.5f), MakeBoxShape(0.5f, 0.5f), 1.0f);
    return scene;
}

/// A fast bullet flying at a thin wall at x = 0.
inline scenes::Scene BulletAndWall() {
    scenes::Scene scene;
    scene.name = "bullet-and-wall";
    scene.gravity = {0.0f, 0.0f};
    AddBody(scene, {}, MakeBoxShape(0.05f, 5.0f), 0.0f);
    scenes::Body bullet = MakeDynamic(-5.0f, 0.0f);
    bullet.bullet = true;
    bullet.linearVelocity = {100.0f, 0.0f};
    AddBody(scene, bullet, MakeCircleShape(0.1f), 1.0f);
    return scene;
}

/// Bodies of all kinds far from each other, thrown and spinning, damped and not, with centres of mass off their
/// origins.
inline scenes::Scene FreeFlight() {
    scenes::Scene scene;
    scene.name = "free-flight";
    for (int i = 0; i < 12; ++i) {
        const auto k = static_cast<float>(i);
        scenes::Body body = MakeDynamic(20.0f * k - 100.0f, 3.0f * k);
        body.angle = 0.3f * k;
        body.linearVelocity = {k - 4.0f, 0.7f * k};
        body.angularVelocity = 0.5f * k - 2.0f;
        body.linearDamping = i % 3 == 0 ? 0.4f : 0.0f;
        body.angularDamping = i % 3 == 1 ? 0.2f : 0.0f;
        body.gravityScale = i % 4 == 3 ? 0.5f : 1.0f;
        body.fixedRotation = i == 7;
        if (i % 3 == 0) AddBody(scene, body, MakeCircleShape(0.4f, {0.3f, -0.2f}), 2.0f);
        if (i % 3 == 1) AddBody(scene, body, MakeBoxShape(0.5f, 1.5f), 1.0f);
        if (i % 3 == 2) {
            scenes::Shape triangle{.type = scenes::ShapeType::polygon, .vertexCount = 3};
            triangle.vertices = {scenes::Vec2{-1.0f, 0.0f}, scenes::Vec2{1.0f, 0.0f}, scenes::Vec2{0.5f, 2.0f}};
            AddBody(scene, body, triangle, 3.0f);
        }
    }
    return scene;
}

}  // namespace testbed::checks
