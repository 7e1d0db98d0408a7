// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A bug on another machine: record the calls there, replay them here, and find the first step that differs.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "scree/scree.h"

namespace {

void PlayGame(scree::World& world) {
    scree::BodyDef def;
    def.type = scree::dynamicBody;
    scree::CircleShape circle;
    circle.m_radius = 0.5f;
    for (int step = 0; step < 60; ++step) {
        if (step % 20 == 0) {
            def.position = {0.1f * static_cast<float>(step), 5.0f};
            world.CreateBody(&def)->CreateFixture(&circle, 1.0f);
        }
        world.Step(1.0f / 60.0f, scree::Accuracy::game);
    }
}

}  // namespace

int main() {
    // In the game:
    scree::World world({0.0f, -10.0f});
    scree::Recorder recorder;
    scree::StartRecording(world, recorder);
    PlayGame(world);
    {
        std::ofstream file("session.recording", std::ios::binary);
        const auto bytes = recorder.GetBytes();
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }

    // On another machine:
    std::ifstream file("session.recording", std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    scree::Player player(std::as_bytes(std::span(bytes)));
    while (player.Step()) {
        if (player.GetReport().steps == 30)
            std::printf("at step 30 there are %d bodies\n", player.GetWorld()->GetBodyCount());
    }
    const scree::ReplayReport& report = player.GetReport();
    std::printf("%s, %d steps, first difference: %d\n", report.valid ? "replayed" : "damaged", report.steps,
                report.firstDifference);
}

// Output:
// at step 30 there are 2 bodies
// replayed, 60 steps, first difference: 0
