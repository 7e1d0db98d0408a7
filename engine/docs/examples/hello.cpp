// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A box falls on the ground. Programs of this folder are compiled and run by a test, which holds each to the output
// that stands at its end.

#include <cstdio>
#include "scree/scree.h"

int main() {
    scree::World world({0.0f, -10.0f});

    scree::BodyDef groundDef;  // static by default
    scree::EdgeShape edge;
    edge.SetTwoSided({-50.0f, 0.0f}, {50.0f, 0.0f});
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);

    scree::BodyDef boxDef;
    boxDef.type = scree::dynamicBody;
    boxDef.position = {0.0f, 4.0f};
    scree::Body* body = world.CreateBody(&boxDef);
    scree::PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    body->CreateFixture(&box, 1.0f);

    for (int i = 0; i < 120; ++i) world.Step(1.0f / 60.0f, 4);  // the soft step; Step(1.0f / 60.0f, 8, 3): as Box2D 2.4
    std::printf("rests at %.3f m\n", body->GetPosition().y);
}

// Output:
// rests at 1.000 m
