// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Save a world, restore it, and see that both go on alike.

#include <cstdio>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"

int main() {
    scree::World world({0.0f, -10.0f});
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    for (int i = 0; i < 10; ++i) {
        def.position = {0.0f, 1.5f * static_cast<float>(i)};
        world.CreateBody(&def)->CreateFixture(&box, 1.0f);
    }
    for (int step = 0; step < 30; ++step) world.Step(1.0f / 60.0f, scree::Accuracy::game);

    const std::vector<std::byte> image = scree::SaveWorld(world);
    scree::SnapshotError error;
    const std::unique_ptr<scree::World> restored = scree::LoadWorld(image, &error);
    if (restored == nullptr) {
        std::printf("refused: %s\n", scree::GetName(error));
        return 1;
    }
    for (int step = 0; step < 30; ++step) {
        world.Step(1.0f / 60.0f, scree::Accuracy::game);
        restored->Step(1.0f / 60.0f, scree::Accuracy::game);
    }
    const bool isEqual = scree::inspect::GetStateHash(world) == scree::inspect::GetStateHash(*restored);
    std::printf("30 steps later both are %s\n", isEqual ? "equal, bit for bit" : "different");
}

// Output:
// 30 steps later both are equal, bit for bit
