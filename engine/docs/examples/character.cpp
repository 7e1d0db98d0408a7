// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A character that walks up a step, rides a moving platform and jumps off it. It is a mover: a capsule that is cast
// through the world and is no body, so it neither tips over nor bounces.

#include <cstdio>

#include "scree/mover.h"
#include "scree/scree.h"

namespace {

constexpr float timeStep = 1.0f / 60.0f;

scree::Body* AddBox(scree::World& world, scree::BodyType type, scree::Vec2 center, float width, float height) {
    scree::BodyDef def;
    def.type = type;
    def.position = center;
    scree::Body* body = world.CreateBody(&def);
    scree::PolygonShape box;
    box.SetAsBox(0.5f * width, 0.5f * height);
    body->CreateFixture(&box, 1.0f);
    return body;
}

}  // namespace

int main() {
    scree::World world({0.0f, -10.0f});
    AddBox(world, scree::staticBody, {0.0f, -0.5f}, 10.0f, 1.0f);                          // ground, x from -5 to 5
    AddBox(world, scree::staticBody, {4.0f, 0.125f}, 2.0f, 0.25f);                         // a step of 0.25 m
    scree::Body* lift = AddBox(world, scree::kinematicBody, {6.5f, 0.125f}, 3.0f, 0.25f);  // moves up later
    scree::MoverDef mover;                                                                 // 1.6 m tall, steps of 0.3 m
    scree::MoverState state;
    state.position = {0.0f, 1.0f};

    const auto walk = [&](float speed, int steps, bool jumps) {
        for (int i = 0; i < steps; ++i) {
            // The velocity of a mover is relative to the ground that it stands on.
            if (state.isGrounded) {
                state.velocity = {speed, jumps ? 5.0f : 0.0f};
            } else {
                state.velocity.y -= 10.0f * timeStep;
            }
            jumps = jumps && !state.isGrounded;
            world.Step(timeStep, scree::Accuracy::game);
            state = scree::MoveMover(world, mover, state, timeStep);
        }
        std::printf("at %.1f, %.1f, %s\n", state.position.x, state.position.y,
                    !state.isGrounded                             ? "in the air"
                    : world.Find(state.ground)->GetBody() == lift ? "on the lift"
                                                                  : "on the ground");
    };

    walk(0.0f, 30, false);   // falls to the ground
    walk(2.0f, 80, false);   // walks to the step
    walk(2.0f, 115, false);  // goes up the step, and on to the lift
    lift->SetLinearVelocity({0.0f, 1.0f});
    walk(0.0f, 120, false);  // rides up for two seconds
    walk(2.0f, 20, true);    // jumps
}

// Output:
// at 0.0, 0.8, on the ground
// at 2.7, 0.8, on the ground
// at 6.6, 1.1, on the lift
// at 6.6, 3.1, on the lift
// at 7.2, 4.5, in the air
