// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program outside this project that records its world with the installed capture header.

#include <scree_capture.h>

#include <cstdio>

int main() {
    scree::World world(scree::Vec2{0.0f, -10.0f});
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::Body* ball = world.CreateBody(&def);
    scree::CircleShape circle;
    circle.m_radius = 0.5f;
    ball->CreateFixture(&circle, 1.0f);
    scree_capture::Track track(world, "session.track");
    for (int step = 0; step < 60; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        track.Step(1.0f / 60.0f);
    }
    track.Close();
    if (!scree_capture::WriteScene(world, "level.scene.json") || !track.GetError().empty()) {
        std::puts("no track");
        return 1;
    }
    return 0;
}
