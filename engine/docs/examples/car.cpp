// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A car on two sprung wheels with a motor, and a bridge of planks on hinges.

#include <cstdio>

#include "scree/scree.h"

int main() {
    scree::World world({0.0f, -10.0f});
    scree::BodyDef groundDef;
    scree::Body* ground = world.CreateBody(&groundDef);
    scree::EdgeShape edge;
    edge.SetTwoSided({-20.0f, 0.0f}, {20.0f, 0.0f});
    ground->CreateFixture(&edge, 0.0f);
    edge.SetTwoSided({30.0f, 0.0f}, {80.0f, 0.0f});
    ground->CreateFixture(&edge, 0.0f);

    // A bridge: ten planks of 1 m on eleven hinges.
    scree::PolygonShape plank;
    plank.SetAsBox(0.5f, 0.05f);
    scree::Body* previous = ground;
    for (int i = 0; i <= 10; ++i) {
        scree::Body* next = ground;
        if (i < 10) {
            scree::BodyDef def;
            def.type = scree::dynamicBody;
            def.position = {20.5f + static_cast<float>(i), -0.05f};
            next = world.CreateBody(&def);
            next->CreateFixture(&plank, 20.0f);
        }
        scree::RevoluteJointDef hinge;
        hinge.Initialize(previous, next, {20.0f + static_cast<float>(i), -0.05f});
        world.CreateJoint(&hinge);
        previous = next;
    }

    // A car: a chassis and two wheels, the rear one driven.
    scree::BodyDef chassisDef;
    chassisDef.type = scree::dynamicBody;
    chassisDef.position = {0.0f, 1.0f};
    scree::Body* chassis = world.CreateBody(&chassisDef);
    scree::PolygonShape hull;
    hull.SetAsBox(1.5f, 0.25f);
    chassis->CreateFixture(&hull, 1.0f);
    scree::CircleShape tire;
    tire.m_radius = 0.4f;
    scree::FixtureDef tireDef;
    tireDef.shape = &tire;
    tireDef.density = 1.0f;
    tireDef.friction = 0.9f;
    for (const float x : {-1.0f, 1.0f}) {
        scree::BodyDef wheelDef;
        wheelDef.type = scree::dynamicBody;
        wheelDef.position = {x, 0.45f};
        scree::Body* wheel = world.CreateBody(&wheelDef);
        wheel->CreateFixture(&tireDef);
        scree::WheelJointDef axle;
        axle.Initialize(chassis, wheel, wheel->GetPosition(), {0.0f, 1.0f});
        scree::LinearStiffness(axle.stiffness, axle.damping, 4.0f, 0.7f, chassis, wheel);  // 4 Hz, damping ratio 0.7
        axle.enableMotor = x < 0.0f;
        axle.motorSpeed = -15.0f;
        axle.maxMotorTorque = 20.0f;
        world.CreateJoint(&axle);
    }

    for (int step = 0; step < 600; ++step) world.Step(1.0f / 60.0f, scree::Accuracy::game);
    std::printf("over the bridge: %s\n",
                chassis->GetPosition().x > 31.0f && chassis->GetPosition().y > 0.0f ? "yes" : "no");
}

// Output:
// over the bridge: yes
