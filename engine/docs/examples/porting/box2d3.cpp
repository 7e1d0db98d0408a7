// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A door that a ball pushes open, in Box2D 3. The same program stands in box2d24.cpp for Box2D 2.4, and in scree.cpp.

#include <box2d/box2d.h>

#include <cstdio>

int main() {
    b2WorldDef worldDef = b2DefaultWorldDef();
    worldDef.gravity = {0.0f, 0.0f};
    b2WorldId world = b2CreateWorld(&worldDef);

    b2BodyDef frameDef = b2DefaultBodyDef();
    b2BodyId frame = b2CreateBody(world, &frameDef);

    b2BodyDef doorDef = b2DefaultBodyDef();
    doorDef.type = b2_dynamicBody;
    doorDef.position = {0.0f, 1.0f};
    b2BodyId door = b2CreateBody(world, &doorDef);
    b2ShapeDef shapeDef = b2DefaultShapeDef();
    shapeDef.enableContactEvents = true;
    b2Polygon box = b2MakeBox(0.1f, 1.0f);
    b2ShapeId doorShape = b2CreatePolygonShape(door, &shapeDef, &box);

    b2RevoluteJointDef hinge = b2DefaultRevoluteJointDef();
    hinge.base.bodyIdA = frame;
    hinge.base.bodyIdB = door;
    hinge.base.localFrameB.p = {0.0f, -1.0f};
    hinge.enableLimit = true;
    hinge.lowerAngle = -0.5f * B2_PI;
    hinge.upperAngle = 0.5f * B2_PI;
    b2CreateRevoluteJoint(world, &hinge);

    b2BodyDef ballDef = b2DefaultBodyDef();
    ballDef.type = b2_dynamicBody;
    ballDef.position = {-3.0f, 1.5f};
    ballDef.linearVelocity = {5.0f, 0.0f};
    b2BodyId ball = b2CreateBody(world, &ballDef);
    b2Circle circle = {{0.0f, 0.0f}, 0.25f};
    b2CreateCircleShape(ball, &shapeDef, &circle);

    int touches = 0;
    for (int i = 0; i < 60; ++i) {
        b2World_Step(world, 1.0f / 60.0f, 4);
        b2ContactEvents events = b2World_GetContactEvents(world);
        for (int k = 0; k < events.beginCount; ++k) {
            const b2ContactBeginTouchEvent& event = events.beginEvents[k];
            if (B2_ID_EQUALS(event.shapeIdA, doorShape) || B2_ID_EQUALS(event.shapeIdB, doorShape)) ++touches;
        }
    }
    std::printf("touched: %s, open: %s\n", touches > 0 ? "yes" : "no",
                b2Rot_GetAngle(b2Body_GetRotation(door)) < -0.5f ? "yes" : "no");
    b2DestroyWorld(world);
}

// Output:
// touched: yes, open: yes
