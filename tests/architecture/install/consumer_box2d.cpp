// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D's hello world outside this project, against the installed scree::box2d: a box falls onto another and must rest
// on it. Exit code 0 if so.

#include <box2d/box2d.h>

#include <cmath>
#include <cstdio>

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));

    b2BodyDef groundDef;
    groundDef.position.Set(0.0f, -10.0f);
    b2PolygonShape groundBox;
    groundBox.SetAsBox(50.0f, 10.0f);
    world.CreateBody(&groundDef)->CreateFixture(&groundBox, 0.0f);

    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(0.0f, 4.0f);
    b2Body* body = world.CreateBody(&bodyDef);
    b2PolygonShape dynamicBox;
    dynamicBox.SetAsBox(1.0f, 1.0f);
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &dynamicBox;
    fixtureDef.density = 1.0f;
    fixtureDef.friction = 0.3f;
    body->CreateFixture(&fixtureDef);

    for (int step = 0; step < 120; ++step) world.Step(1.0f / 60.0f, 6, 2);
    const float height = body->GetPosition().y;
    std::printf("Box2D %d.%d: height after 2 s: %.3f m\n", b2_version.major, b2_version.minor,
                static_cast<double>(height));
    // Both boxes have a skin, and the solver lets bodies sink by the slop.
    return std::abs(height - 1.0f) < 2.0f * b2_polygonRadius + 2.0f * b2_linearSlop ? 0 : 1;
}
