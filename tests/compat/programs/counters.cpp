// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D exports counters of its distance and time-of-impact work without declaring them. They count calls of the
// program and of the world's steps alike; how many there are in a step is each engine's own affair.

#include "program.h"

extern int32 b2_gjkCalls, b2_gjkIters, b2_gjkMaxIters;
extern float b2_toiTime, b2_toiMaxTime;
extern int32 b2_toiCalls, b2_toiIters, b2_toiMaxIters;
extern int32 b2_toiRootIters, b2_toiMaxRootIters;

namespace {

void Reset() {
    b2_gjkCalls = b2_gjkIters = b2_gjkMaxIters = 0;
    b2_toiCalls = b2_toiIters = b2_toiMaxIters = b2_toiRootIters = b2_toiMaxRootIters = 0;
    b2_toiTime = b2_toiMaxTime = 0.0f;
}

/// Which counters moved, and whether they fit together.
void SayCounters(const char* when) {
    Say("%s: gjk %d %d %d toi %d %d %d root %d %d time %d", when, b2_gjkCalls > 0, b2_gjkIters > 0,
        b2_gjkMaxIters > 0 && b2_gjkMaxIters <= b2_gjkIters, b2_toiCalls > 0, b2_toiIters > 0,
        b2_toiMaxIters > 0 && b2_toiMaxIters <= b2_toiIters, b2_toiRootIters > 0,
        b2_toiMaxRootIters > 0 && b2_toiMaxRootIters <= b2_toiRootIters, b2_toiTime > 0.0f);
    Say("every search for a time asks for distances: %d", b2_gjkCalls >= b2_toiCalls);
}

b2Fixture* MakeSensor(b2World& world, float x, float y) {
    b2BodyDef def;
    def.position.Set(x, y);
    b2PolygonShape zone;
    zone.SetAsBox(2.0f, 2.0f);
    b2FixtureDef fixture;
    fixture.shape = &zone;
    fixture.isSensor = true;
    return world.CreateBody(&def)->CreateFixture(&fixture);
}

}  // namespace

void Counters() {
    Reset();
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* box = MakeBox(world, 0.0f, 3.0f, 0.5f, 0.5f);
    world.SetContinuousPhysics(false);
    Run(world, 5);
    SayCounters("falls");
    world.SetContinuousPhysics(true);
    box->SetLinearVelocity(b2Vec2(0.0f, -100.0f));
    Run(world, 3);
    SayCounters("hits the ground");
    world.SetContinuousPhysics(false);
    box->SetTransform(b2Vec2(0.0f, 30.0f), 0.0f);
    Run(world, 2);
    Reset();
    MakeSensor(world, 0.0f, 30.0f);
    Run(world, 4);
    Say("sensor: gjk %d toi %d, a distance for each step in it: %d", b2_gjkCalls > 0, b2_toiCalls, b2_gjkCalls >= 3);
    Reset();
    b2PolygonShape shape;
    shape.SetAsBox(1.0f, 1.0f);
    b2Transform here, there;
    here.SetIdentity();
    there.Set(b2Vec2(1.5f, 0.0f), 0.3f);
    const bool overlap = b2TestOverlap(&shape, 0, &shape, 0, here, there);
    Say("overlap %d calls %d", overlap, b2_gjkCalls);
}
