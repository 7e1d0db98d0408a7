// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rays, overlaps and casts between steps, from several threads.

#include <array>
#include <cstdio>
#include <thread>
#include <vector>

#include "scree/scree.h"

int main() {
    scree::World world({0.0f, -10.0f});
    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    for (int i = 0; i < 100; ++i) {
        scree::BodyDef def;
        def.position = {static_cast<float>(2 * i), 0.0f};
        world.CreateBody(&def)->CreateFixture(&box, 0.0f);
    }
    world.PrepareQueries();

    // Queries only read: any number of threads may ask while nobody steps or edits the world.
    std::array<int, 4> hits{};
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&world, &hits, t] {
                for (int i = t; i < 200; i += 4) {
                    const float x = static_cast<float>(i);
                    if (world.RayCastClosest({x, 5.0f}, {x, -5.0f})) ++hits[static_cast<size_t>(t)];
                }
            });
        }
    }
    std::printf("%d of 200 rays hit\n", hits[0] + hits[1] + hits[2] + hits[3]);

    int inside = 0;
    scree::CircleShape blast;
    blast.m_radius = 5.0f;
    world.OverlapShape(blast, scree::Transform({50.0f, 0.0f}, scree::Rot(0.0f)), [&inside](scree::Fixture*) {
        ++inside;
        return true;
    });
    std::printf("%d boxes within 5 m\n", inside);

    const auto first = world.ShapeCastClosest(blast, scree::Transform({-20.0f, 0.0f}, scree::Rot(0.0f)), {40.0f, 0.0f});
    if (first) std::printf("a ball of 5 m gets %.1f m far\n", 40.0 * static_cast<double>(first->fraction));
}

// Output:
// 100 of 200 rays hit
// 5 boxes within 5 m
// a ball of 5 m gets 14.5 m far
