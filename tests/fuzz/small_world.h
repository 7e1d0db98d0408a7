// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world with a bit of everything, a few kilobytes as an image: the start of what is damaged.

#pragma once

#include <memory>

#include "scree/scree.h"

namespace fuzz {

inline std::unique_ptr<scree::World> MakeSmallWorld() {
    using namespace scree;
    auto world = std::make_unique<World>(Vec2{0.0f, -10.0f});
    BodyDef def;
    Body* ground = world->CreateBody(&def);
    ChainShape chain;
    const Vec2 points[] = {{10.0f, 0.0f}, {-10.0f, 0.0f}, {-10.0f, -2.0f}, {10.0f, -2.0f}};
    if (chain.CreateLoop(points, 4)) ground->CreateFixture(&chain, 0.0f);
    def.type = dynamicBody;
    Body* bodies[8];
    for (int i = 0; i < 8; ++i) {
        const auto f = static_cast<float>(i);
        def.position = {f - 4.0f, 0.6f + 0.2f * f};
        def.bullet = i == 7;
        bodies[i] = world->CreateBody(&def);
        CircleShape circle;
        circle.m_radius = 0.5f;
        PolygonShape box;
        box.SetAsBox(0.5f, 0.4f);
        if (i % 3 == 0) {
            bodies[i]->CreateFixture(&circle, 1.0f);
        } else if (i % 3 == 1) {
            bodies[i]->CreateFixture(&box, 1.0f);
        } else {
            const ConvexShape capsule = MakeCapsule({-0.3f, 0.0f}, {0.3f, 0.0f}, 0.3f);
            bodies[i]->CreateFixture(&capsule, 1.0f);
        }
    }
    RevoluteJointDef hinge;
    hinge.Initialize(bodies[0], bodies[1], {-3.5f, 1.0f});
    world->CreateJoint(&hinge);
    DistanceJointDef rope;
    rope.Initialize(ground, bodies[4], {0.0f, 3.0f}, bodies[4]->GetPosition());
    world->CreateJoint(&rope);
    for (int i = 0; i < 20; ++i) world->Step(1.0f / 60.0f, 4);
    return world;
}

}  // namespace fuzz
