// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What happened in a step, without a listener: blows, a sensor, and ids that tell when an object is gone.

#include <cstdio>

#include "scree/scree.h"

int main() {
    scree::World world({0.0f, -10.0f});
    scree::BodyDef groundDef;
    scree::Body* ground = world.CreateBody(&groundDef);
    scree::EdgeShape edge;
    edge.SetTwoSided({-50.0f, 0.0f}, {50.0f, 0.0f});
    ground->CreateFixture(&edge, 0.0f);

    scree::PolygonShape zone;
    zone.SetAsBox(1.0f, 0.5f, {0.0f, 2.5f}, 0.0f);
    scree::FixtureDef zoneDef;
    zoneDef.shape = &zone;
    zoneDef.isSensor = true;
    zoneDef.reports = scree::Report::contacts;
    ground->CreateFixture(&zoneDef);

    scree::BodyDef ballDef;
    ballDef.type = scree::dynamicBody;
    ballDef.position = {0.0f, 6.0f};
    scree::Body* ball = world.CreateBody(&ballDef);
    scree::CircleShape circle;
    circle.m_radius = 0.25f;
    scree::FixtureDef circleDef;
    circleDef.shape = &circle;
    circleDef.density = 1.0f;
    circleDef.reports = scree::Report::hits;
    const scree::FixtureId id = world.GetId(ball->CreateFixture(&circleDef));

    world.SetHitSpeed(2.0f);
    for (int step = 1; step <= 120; ++step) {
        world.Step(1.0f / 60.0f, scree::Accuracy::game);
        const scree::Events events = world.GetEvents();
        for (const scree::SensorEvent& event : events.sensorsEntered) {
            std::printf("%s enters the zone\n", event.visitor == id ? "the ball" : "something");
        }
        for (const scree::SensorEvent& event : events.sensorsLeft) {
            std::printf("%s leaves the zone\n", event.visitor == id ? "the ball" : "something");
        }
        for (const scree::HitEvent& event : events.hits) std::printf("hits the ground at %.0f m/s\n", event.speed);
    }
    world.DestroyBody(ball);
    std::printf("the ball is %s\n", world.Find(id) == nullptr ? "gone" : "there");
}

// Output:
// the ball enters the zone
// the ball leaves the zone
// hits the ground at 11 m/s
// the ball is gone
