// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A pyramid that comes to rest, and how accurately it stands under three settings.

#include <cstdio>

#include "scree/scree.h"

namespace {

void BuildPyramid(scree::World& world, int rows) {
    scree::BodyDef groundDef;
    scree::EdgeShape edge;
    edge.SetTwoSided({-50.0f, 0.0f}, {50.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);

    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    scree::FixtureDef fixtureDef;
    fixtureDef.shape = &box;
    fixtureDef.density = 1.0f;
    fixtureDef.friction = 0.6f;
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < rows - row; ++i) {
            scree::BodyDef def;
            def.type = scree::dynamicBody;
            def.position = {static_cast<float>(i) - 0.5f * static_cast<float>(rows - row - 1),
                            0.5f + static_cast<float>(row)};
            world.CreateBody(&def)->CreateFixture(&fixtureDef);
        }
    }
}

/// Steps until nothing is awake, ten seconds at most; returns the seconds.
double TimeToSleep(scree::Accuracy accuracy) {
    scree::World world({0.0f, -10.0f});
    BuildPyramid(world, 15);
    int steps = 0;
    while (steps < 600) {
        const scree::StepReport report = world.Step(1.0f / 60.0f, accuracy);
        ++steps;
        if (report.awakeBodyCount == 0) break;
    }
    return steps / 60.0;
}

}  // namespace

int main() {
    const double draft = TimeToSleep(scree::Accuracy::draft), game = TimeToSleep(scree::Accuracy::game);
    const double fine = TimeToSleep(scree::Accuracy::fine);
    std::printf("asleep within three seconds: draft %s, game %s, fine %s\n", draft < 3 ? "yes" : "no",
                game < 3 ? "yes" : "no", fine < 3 ? "yes" : "no");

    scree::World world({0.0f, -10.0f});
    BuildPyramid(world, 15);
    world.SetMeasureErrors(true);
    float deepest = 0.0f;
    for (int step = 0; step < 120; ++step) {
        const scree::StepErrors errors = world.Step(1.0f / 60.0f, scree::Accuracy::game).errors;
        if (errors.overlap > deepest) deepest = errors.overlap;
    }
    std::printf("overlap below 1 cm: %s\n", deepest < 0.01f ? "yes" : "no");
}

// Output:
// asleep within three seconds: draft no, game yes, fine yes
// overlap below 1 cm: yes
