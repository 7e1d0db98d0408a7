// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A world of what the scenes lack: round corners, whose masses come from angles, and steps whose sub-steps come from
// what the last one found.

#pragma once

#include <cstdint>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace determinism {

inline uint64_t HashOfRoundShapes(bool withTolerance) {
    scree::World world(scree::Vec2{0.0f, -10.0f});
    scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-30.0f, 0.0f}, {30.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
    scree::Body* before = nullptr;
    for (int i = 0; i < 60; ++i) {
        const auto f = static_cast<float>(i);
        scree::BodyDef def;
        def.type = scree::dynamicBody;
        def.position = {1.3f * static_cast<float>(i % 10) - 6.0f, 1.0f + 1.4f * static_cast<float>(i / 10)};
        def.angle = 0.37f * f;
        scree::Body* body = world.CreateBody(&def);
        const scree::Vec2 corners[] = {
            {-0.3f - 0.002f * f, -0.2f}, {0.4f, -0.25f}, {0.35f, 0.2f + 0.001f * f}, {-0.1f, 0.33f}};
        const scree::ConvexShape shape = i % 3 == 0   ? scree::MakeRoundedPolygon(corners, 4, 0.05f + 0.001f * f)
                                         : i % 3 == 1 ? scree::MakeCapsule({-0.3f, 0.01f * f}, {0.3f, 0.0f}, 0.2f)
                                                      : scree::MakeEllipse(0.4f, 0.25f + 0.001f * f);
        body->CreateFixture(&shape, 1.0f);
        if (i % 6 == 1) {
            scree::RevoluteJointDef joint;
            joint.Initialize(before, body, body->GetPosition());
            world.CreateJoint(&joint);
        }
        before = body;
    }
    for (int step = 0; step < 120; ++step) {
        withTolerance ? world.Step(1.0f / 60.0f, scree::Tolerance{.overlap = 0.008f}) : world.Step(1.0f / 60.0f, 8, 3);
    }
    return scree::inspect::GetStateHash(world);
}

}  // namespace determinism
