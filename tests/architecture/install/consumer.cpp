// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program outside this project: a circle falls onto an edge and must rest one radius above it. Exit code 0 if so.

#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "scree/inspect.h"
#include "scree/scree.h"

int main() {
    scree::World world(scree::Vec2{0.0f, -10.0f});

    const scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-10.0f, 0.0f}, {10.0f, 0.0f});
    scree::Body* ground = world.CreateBody(&groundDef);
    ground->CreateFixture(&edge, 0.0f);

    scree::BodyDef ballDef;
    ballDef.type = scree::BodyType::dynamicBody;
    ballDef.position = {0.0f, 3.0f};
    scree::CircleShape circle;
    circle.m_radius = 0.5f;
    scree::Body* ball = world.CreateBody(&ballDef);
    ball->CreateFixture(&circle, 1.0f);

    for (int step = 0; step < 120; ++step) world.Step(1.0f / 60.0f, 8, 3);
    const float height = ball->GetPosition().y;
    std::printf("height after 2 s: %.3f m, state %016" PRIx64 "\n", static_cast<double>(height),
                scree::inspect::GetStateHash(world));
    // The edge has a skin, and the solver lets bodies sink by the slop.
    return std::abs(height - 0.5f) < scree::polygonRadius + 2.0f * scree::linearSlop ? 0 : 1;
}
