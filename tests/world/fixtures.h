// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Short ways to put bodies into a test world.

#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace scree::test {

inline constexpr float frame = 1.0f / 60.0f;  // s
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();

inline Body* AddBody(World& world, BodyType type, Vec2 position, float angle = 0.0f) {
    BodyDef def;
    def.type = type;
    def.position = position;
    def.angle = angle;
    return world.CreateBody(&def);
}

inline Fixture* AddBox(Body* body, float hx, float hy, float density = 1.0f) {
    PolygonShape shape;
    shape.SetAsBox(hx, hy);
    return body->CreateFixture(&shape, density);
}

inline Fixture* AddCircle(Body* body, float radius, float density = 1.0f) {
    CircleShape shape;
    shape.m_radius = radius;
    return body->CreateFixture(&shape, density);
}

/// A static edge along y = 0.
inline Body* AddGround(World& world, float halfWidth = 100.0f) {
    Body* ground = AddBody(world, staticBody, {0.0f, 0.0f});
    EdgeShape edge;
    edge.SetTwoSided({-halfWidth, 0.0f}, {halfWidth, 0.0f});
    ground->CreateFixture(&edge, 0.0f);
    return ground;
}

/// Steps at 60 Hz with Box2D's usual iterations.
inline StepReport StepFor(World& world, int steps) {
    StepReport report;
    for (int i = 0; i < steps; ++i) report = world.Step(1.0f / 60.0f, 8, 3);
    return report;
}

/// What StepWith takes as `substeps`: sequential impulses, soft step of four.
inline constexpr int solvers[] = {0, 4};

/// Steps at 60 Hz with so many sub-steps; with 0 by sequential impulses, as StepFor.
inline StepReport StepWith(World& world, int substeps, int steps = 1) {
    if (substeps == 0) return StepFor(world, steps);
    StepReport report;
    for (int i = 0; i < steps; ++i) report = world.Step(1.0f / 60.0f, substeps);
    return report;
}

/// Poses, velocities and sleep of all bodies, to the bit.
inline std::vector<uint32_t> BitsOf(const World& world) {
    std::vector<uint32_t> bits;
    for (const Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const Vec2 p = body->GetPosition(), v = body->GetLinearVelocity();
        for (const float x : {p.x, p.y, body->GetAngle(), v.x, v.y, body->GetAngularVelocity()})
            bits.push_back(std::bit_cast<uint32_t>(x));
        bits.push_back(body->IsAwake() ? 1 : 0);
    }
    return bits;
}

/// Collects refused calls.
struct ErrorLog {
    int count = 0;
    Error last{ErrorCode::ok, "", "", ""};

    explicit ErrorLog(World& world) { world.SetErrorHandler(&ErrorLog::Receive, this); }
    static void Receive(const Error& error, void* self) {
        static_cast<ErrorLog*>(self)->last = error;
        ++static_cast<ErrorLog*>(self)->count;
    }
};

}  // namespace scree::test
