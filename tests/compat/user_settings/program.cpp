// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Uses what its b2_user_settings.h defines.

#include <box2d/box2d.h>

int CountTeam(b2World& world, int team);

int CountTeam(b2World& world, int team) {
    b2BodyDef def;
    def.userData.name = "new";
    def.userData.team = team;
    world.CreateBody(&def);
    b2PolygonShape shape;
    static_assert(sizeof(shape.m_vertices) == 12 * sizeof(b2Vec2));
    int count = 0;
    for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
        if (body->GetUserData().team == team) ++count;
        for (b2Fixture* fixture = body->GetFixtureList(); fixture; fixture = fixture->GetNext()) {
            count += fixture->GetUserData().material;
        }
    }
    b2Log("%d\n", count);
    return count;
}
