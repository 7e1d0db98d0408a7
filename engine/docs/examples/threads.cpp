// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The same world on one thread and on three: the same bits.

#include <cstdint>
#include <cstdio>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace {

uint64_t Simulate(int workers) {
    scree::WorldDef worldDef;
    worldDef.workerCount = workers;
    scree::World world(worldDef);
    scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-200.0f, 0.0f}, {200.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::CircleShape circle;
    circle.m_radius = 0.5f;
    for (int i = 0; i < 1000; ++i) {
        def.position = {static_cast<float>(i % 50) - 25.0f + 0.01f * static_cast<float>(i / 50),
                        1.0f + static_cast<float>(i / 50)};
        world.CreateBody(&def)->CreateFixture(&circle, 1.0f);
    }
    for (int step = 0; step < 60; ++step) world.Step(1.0f / 60.0f, scree::Accuracy::game);
    return scree::inspect::GetStateHash(world);
}

}  // namespace

int main() { std::printf("one thread and three: %s\n", Simulate(1) == Simulate(3) ? "equal" : "different"); }

// Output:
// one thread and three: equal
