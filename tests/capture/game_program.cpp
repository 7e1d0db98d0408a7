// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// game_program [STEPS]: the game of testbed/docs/own-world.md. Crates fall onto platforms between two walls. A jump pad
// throws the player, which is a fault, over a wall. session.track has four seconds, from step STEPS of the game on.

#include <scree_capture_box2d.h>

#include <cstdlib>

namespace {

void AddBlock(b2World& world, float x, float y, float halfWidth, float halfHeight, float angle) {
    b2BodyDef def;
    b2PolygonShape box;
    box.SetAsBox(halfWidth, halfHeight, b2Vec2(x, y), angle);
    world.CreateBody(&def)->CreateFixture(&box, 0.0f);
}

void MakeLevel(b2World& world) {
    AddBlock(world, 0.0f, -0.5f, 16.0f, 0.5f, 0.0f);
    AddBlock(world, -16.5f, 2.0f, 0.5f, 3.0f, 0.0f);
    AddBlock(world, 16.5f, 2.0f, 0.5f, 3.0f, 0.0f);
    for (int i = 0; i < 12; ++i) {
        const float side = i % 2 == 0 ? -1.0f : 1.0f;
        AddBlock(world, side * (4.0f + 4.0f * static_cast<float>(i % 3)), 2.0f + 1.5f * static_cast<float>(i / 2), 1.6f,
                 0.15f, 0.2f * side);
    }
}

void AddCrates(b2World& world) {
    b2PolygonShape crate;
    crate.SetAsBox(0.35f, 0.35f);
    for (int i = 0; i < 160; ++i) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position.Set(-12.0f + 0.8f * static_cast<float>(i % 31), 12.0f + 1.1f * static_cast<float>(i / 31));
        world.CreateBody(&def)->CreateFixture(&crate, 1.0f);
    }
}

b2Body* AddPlayer(b2World& world) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(14.2f, 0.5f);
    b2CircleShape circle;
    circle.m_radius = 0.5f;
    b2Body* player = world.CreateBody(&def);
    player->CreateFixture(&circle, 4.0f);
    return player;
}

}  // namespace

int main(int count, char** arguments) {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeLevel(world);
    AddCrates(world);
    b2Body* player = AddPlayer(world);
    const float dt = 1.0f / 60.0f;
    for (int step = 0; count > 1 && step < std::atoi(arguments[1]); ++step) world.Step(dt, 8, 3);

    scree_capture::Options options;
    options.contacts = true;
    options.stages = true;
    options.tree = true;
    scree_capture::Track track(world, "session.track", options);
    track.Name(player, "player");
    for (int step = 1; step <= 240; ++step) {
        if (step == 100) {
            track.Mark("the player is on the jump pad");
            player->SetLinearVelocity(b2Vec2(3.0f, 18.0f));
        }
        world.Step(dt, 8, 3);
        track.Step(dt);
    }
    track.Close();
    return track.GetError().empty() ? 0 : 1;
}
