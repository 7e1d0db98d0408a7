// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A door that a ball pushes open: what box2d24.cpp and box2d3.cpp become when they are ported.

#include <cstdio>

#include "scree/scree.h"

int main() {
    scree::World world({0.0f, 0.0f});

    scree::BodyDef frameDef;
    scree::Body* frame = world.CreateBody(&frameDef);

    scree::BodyDef doorDef;
    doorDef.type = scree::dynamicBody;
    doorDef.position = {0.0f, 1.0f};
    scree::Body* door = world.CreateBody(&doorDef);
    scree::PolygonShape box;
    box.SetAsBox(0.1f, 1.0f);
    scree::Fixture* doorShape = door->CreateFixture(&box, 1.0f);
    doorShape->SetReports(scree::Report::contacts);

    scree::RevoluteJointDef hinge;
    hinge.Initialize(frame, door, {0.0f, 0.0f});
    hinge.enableLimit = true;
    hinge.lowerAngle = -0.5f * scree::pi;
    hinge.upperAngle = 0.5f * scree::pi;
    world.CreateJoint(&hinge);

    scree::BodyDef ballDef;
    ballDef.type = scree::dynamicBody;
    ballDef.position = {-3.0f, 1.5f};
    ballDef.linearVelocity = {5.0f, 0.0f};
    scree::Body* ball = world.CreateBody(&ballDef);
    scree::CircleShape circle;
    circle.m_radius = 0.25f;
    ball->CreateFixture(&circle, 1.0f);

    size_t touches = 0;
    for (int i = 0; i < 60; ++i) {
        world.Step(1.0f / 60.0f, 4);  // 4 sub-steps, as in Box2D 3; Step(1.0f / 60.0f, 8, 3) as in Box2D 2.4
        touches += world.GetEvents().contactsBegun.size();  // only the door reports its contacts
    }
    std::printf("touched: %s, open: %s\n", touches > 0 ? "yes" : "no", door->GetAngle() < -0.5f ? "yes" : "no");
}

// Output:
// touched: yes, open: yes
