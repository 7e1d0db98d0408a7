// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs of several bodies: stacks, dominoes, a character, a shifted origin, overlapping spawns.

#include <string>

#include "program.h"

void Pyramid() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* top = nullptr;
    for (int row = 0; row < 6; ++row) {
        for (int i = row; i < 6; ++i) {
            top = MakeBox(world, 1.1f * (static_cast<float>(i) - 0.5f * static_cast<float>(row)),
                          0.5f + 1.02f * static_cast<float>(row), 0.5f, 0.5f, 5.0f);
        }
    }
    Run(world, 300);
    Number("top", top->GetPosition().y);
    Number("angle", top->GetAngle(), 5e-3);  // it creeps until all sleep
    int awake = 0;
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) awake += b->GetType() == b2_dynamicBody && b->IsAwake();
    Say("all asleep: %d, bodies %d", awake == 0, world.GetBodyCount());
    int touching = 0;
    for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) touching += c->IsTouching();
    Say("touching %d", touching);
}

void Dominoes() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* pieces[10];
    for (int i = 0; i < 10; ++i) {
        pieces[i] = MakeBox(world, static_cast<float>(i), 1.0f, 0.1f, 1.0f, 20.0f);
        pieces[i]->GetFixtureList()->SetFriction(0.1f);
    }
    pieces[0]->ApplyLinearImpulse(b2Vec2(20.0f, 0.0f), b2Vec2(0.0f, 2.0f), true);
    int order = 0;
    std::string fallen;
    bool down[10] = {};
    for (int step = 0; step < 600 && order < 10; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        for (int i = 0; i < 10; ++i) {
            if (down[i] || pieces[i]->GetAngle() > -0.3f) continue;
            down[i] = true;
            fallen += std::to_string(i) + " ";
            ++order;
        }
    }
    Say("fall in order %s", fallen.c_str());
}

void Character() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 2.0f);
    def.fixedRotation = true;
    def.allowSleep = false;
    b2Body* hero = world.CreateBody(&def);
    b2PolygonShape body;
    const b2Vec2 outline[] = {b2Vec2(-0.4f, -0.8f), b2Vec2(0.4f, -0.8f), b2Vec2(0.5f, 0.0f),
                              b2Vec2(0.4f, 0.9f),   b2Vec2(-0.4f, 0.9f), b2Vec2(-0.5f, 0.0f)};
    body.Set(outline, 6);
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &body;
    fixtureDef.density = 2.0f;
    fixtureDef.friction = 0.1f;
    hero->CreateFixture(&fixtureDef);
    b2BodyDef stepDef;
    stepDef.position.Set(6.0f, 0.25f);
    b2PolygonShape stair;
    stair.SetAsBox(1.0f, 0.25f);
    world.CreateBody(&stepDef)->CreateFixture(&stair, 0.0f);
    for (int i = 0; i < 120; ++i) {
        const float wanted = 2.0f;
        const float change = wanted - hero->GetLinearVelocity().x;
        hero->ApplyLinearImpulseToCenter(b2Vec2(hero->GetMass() * change, 0.0f), true);
        world.Step(1.0f / 60.0f, 8, 3);
    }
    Number("walked", hero->GetPosition());
    Say("upright %d", hero->GetAngle() == 0.0f && hero->IsFixedRotation());
    Run(world, 120);
    Number("before the step", hero->GetPosition());
    hero->ApplyLinearImpulse(b2Vec2(0.0f, 6.0f * hero->GetMass()), hero->GetWorldCenter(), true);
    for (int i = 0; i < 60; ++i) {
        hero->SetLinearVelocity(b2Vec2(2.0f, hero->GetLinearVelocity().y));
        world.Step(1.0f / 60.0f, 8, 3);
    }
    Say("on or past the step %d", hero->GetPosition().x > 5.0f);
}

void OriginShift() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* box = MakeBox(world, 10.0f, 0.5f, 0.5f, 0.5f);
    b2Body* falling = MakeDisk(world, 12.0f, 6.0f, 0.5f);
    Run(world, 30);
    world.ShiftOrigin(b2Vec2(8.0f, -3.0f));
    Pose("box", box);
    Pose("disk", falling);
    Run(world, 120);
    Pose("box", box);
    Number("disk", falling->GetPosition());
}

void Overlaps() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* body = MakeBox(world, 1.0f, 1.0f, 0.5f, 0.5f);
    b2CircleShape circle;
    circle.m_radius = 0.4f;
    b2ChainShape chain;
    const b2Vec2 line[] = {b2Vec2(2.0f, 0.0f), b2Vec2(0.0f, 0.0f), b2Vec2(-2.0f, 1.0f)};
    chain.CreateChain(line, 3, b2Vec2(3.0f, 0.0f), b2Vec2(-3.0f, 1.0f));
    for (int i = 0; i < 8; ++i) {
        b2Transform xf;
        xf.Set(b2Vec2(0.25f * static_cast<float>(i), 0.9f), 0.0f);
        b2Fixture* fixture = body->GetFixtureList();
        Say("%d %d %d", b2TestOverlap(fixture->GetShape(), 0, &circle, 0, body->GetTransform(), xf),
            b2TestOverlap(&chain, 0, &circle, 0, body->GetTransform(), xf),
            b2TestOverlap(&chain, 1, fixture->GetShape(), 0, xf, body->GetTransform()));
    }
    b2AABB box;
    b2Transform xf;
    xf.Set(b2Vec2(1.0f, 2.0f), 0.3f);
    chain.ComputeAABB(&box, xf, 1);
    Number("lower", box.lowerBound, 0.011);
    Number("upper", box.upperBound, 0.011);
    // Two boxes at the same place push each other out.
    MakeGround(world, -2.0f);
    b2Body* twin = MakeBox(world, 1.1f, 1.05f, 0.5f, 0.5f);
    Run(world, 240);
    const float apart = b2Distance(twin->GetPosition(), body->GetPosition());
    Say("apart %d", apart > 0.95f);
    b2PolygonShape hull;
    const b2Vec2 cloud[] = {b2Vec2(0.0f, 0.0f), b2Vec2(1.0f, 0.0f), b2Vec2(0.5f, 0.2f),
                            b2Vec2(1.0f, 1.0f), b2Vec2(0.0f, 1.0f), b2Vec2(0.5f, 1.5f)};
    hull.Set(cloud, 6);
    Say("hull %d valid %d", hull.m_count, hull.Validate());
    for (int i = 0; i < hull.m_count; ++i) Number("vertex", hull.m_vertices[i], 1e-6);
    Number("centroid", hull.m_centroid, 1e-5);
}
