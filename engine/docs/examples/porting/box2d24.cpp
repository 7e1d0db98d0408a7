// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A door that a ball pushes open, in Box2D 2.4. The same program stands in box2d3.cpp for Box2D 3, and in scree.cpp.

#include <box2d/box2d.h>

#include <cstdio>

struct Touches : b2ContactListener {
    void BeginContact(b2Contact* contact) override {
        if (contact->GetFixtureA() == door || contact->GetFixtureB() == door) ++count;
    }
    b2Fixture* door = nullptr;
    int count = 0;
};

int main() {
    b2World world(b2Vec2(0.0f, 0.0f));
    Touches touches;
    world.SetContactListener(&touches);

    b2BodyDef frameDef;
    b2Body* frame = world.CreateBody(&frameDef);

    b2BodyDef doorDef;
    doorDef.type = b2_dynamicBody;
    doorDef.position.Set(0.0f, 1.0f);
    b2Body* door = world.CreateBody(&doorDef);
    b2PolygonShape box;
    box.SetAsBox(0.1f, 1.0f);
    touches.door = door->CreateFixture(&box, 1.0f);

    b2RevoluteJointDef hinge;
    hinge.Initialize(frame, door, b2Vec2(0.0f, 0.0f));
    hinge.enableLimit = true;
    hinge.lowerAngle = -0.5f * b2_pi;
    hinge.upperAngle = 0.5f * b2_pi;
    world.CreateJoint(&hinge);

    b2BodyDef ballDef;
    ballDef.type = b2_dynamicBody;
    ballDef.position.Set(-3.0f, 1.5f);
    ballDef.linearVelocity.Set(5.0f, 0.0f);
    b2Body* ball = world.CreateBody(&ballDef);
    b2CircleShape circle;
    circle.m_radius = 0.25f;
    ball->CreateFixture(&circle, 1.0f);

    for (int i = 0; i < 60; ++i) world.Step(1.0f / 60.0f, 8, 3);
    std::printf("touched: %s, open: %s\n", touches.count > 0 ? "yes" : "no", door->GetAngle() < -0.5f ? "yes" : "no");
}

// Output:
// touched: yes, open: yes
