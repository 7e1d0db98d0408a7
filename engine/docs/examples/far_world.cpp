// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A stack 10,000 km from the origin, where a float is a multiple of 1 m. Positions have a rest, which is added in
// double.

#include <cmath>
#include <cstdio>

#include "scree/scree.h"

int main() {
    const float east = 1e7f;
    scree::World world({0.0f, -10.0f});
    scree::BodyDef groundDef;
    groundDef.position = {east, 0.0f};
    scree::EdgeShape edge;
    edge.SetTwoSided({-50.0f, 0.0f}, {50.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);

    scree::BodyDef def;
    def.type = scree::dynamicBody;
    def.position = {east, 3.0f};
    def.positionRest = {0.25f, 0.0f};  // the body is at 10,000,000.25 m
    scree::Body* body = world.CreateBody(&def);
    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    body->CreateFixture(&box, 1.0f);

    for (int step = 0; step < 120; ++step) world.Step(1.0f / 60.0f, scree::Accuracy::game);
    const double x = static_cast<double>(body->GetPosition().x) + static_cast<double>(body->GetPositionRest().x);
    std::printf("rests at %.2f m east\n", x);
    std::printf("a quarter of a metre off: %s\n", std::abs(x - 10000000.25) < 1e-3 ? "yes" : "no");
}

// Output:
// rests at 10000000.25 m east
// a quarter of a metre off: yes
