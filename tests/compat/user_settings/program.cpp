// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Uses what its b2_user_settings.h defines: typed user data of all three kinds, larger polygon arrays, memory and log.
// Exit code 0 if all of it came through.

#include <box2d/box2d.h>

namespace {

int failures = 0;

void Expect(bool holds, const char* what) {
    if (holds) return;
    ++failures;
    b2Log("not true: %s\n", what);
}

int CountTeam(b2World& world, int team) {
    int count = 0;
    for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) count += body->GetUserData().team == team;
    return count;
}

b2Body* MakePlayer(b2World& world, const char* name, int team, float x) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(x, 3.0f);
    def.userData.name = name;
    def.userData.team = team;
    b2Body* body = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 1.0f;
    fixture.userData.material = 10 + team;
    body->CreateFixture(&fixture);
    return body;
}

void TryLargePolygon() {
    static_assert(sizeof(b2PolygonShape::m_vertices) == 12 * sizeof(b2Vec2));
    b2Vec2 ring[12];
    for (int i = 0; i < 12; ++i) {
        const float angle = 2.0f * b2_pi * static_cast<float>(i) / 12.0f;
        ring[i].Set(cosf(angle), sinf(angle));
    }
    b2PolygonShape polygon;
    polygon.SetAsBox(1.0f, 1.0f);
    polygon.Set(ring, 12);
    Expect(polygon.m_count == 4, "more vertices than the engine has are refused and change nothing");
    polygon.Set(ring, 8);
    Expect(polygon.m_count == 8, "8 vertices are taken");
}

}  // namespace

int main() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef groundDef;
    b2EdgeShape edge;
    edge.SetTwoSided(b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    world.CreateBody(&groundDef)->CreateFixture(&edge, 0.0f);
    b2Body* a = MakePlayer(world, "a", 1, 0.0f);
    b2Body* b = MakePlayer(world, "b", 2, 2.0f);
    b2DistanceJointDef rope;
    rope.Initialize(a, b, a->GetPosition(), b->GetPosition());
    rope.userData.strength = 7;
    b2Joint* joint = world.CreateJoint(&rope);
    for (int i = 0; i < 120; ++i) world.Step(1.0f / 60.0f, 8, 3);
    Expect(CountTeam(world, 1) == 1 && CountTeam(world, 2) == 1, "bodies keep their teams");
    Expect(b->GetUserData().name[0] == 'b', "bodies keep their names");
    Expect(a->GetFixtureList()->GetUserData().material == 11, "fixtures keep their material");
    Expect(joint->GetUserData().strength == 7, "joints keep their strength");
    Expect(b2Abs(a->GetPosition().y - 0.5f) < 0.03f, "boxes rest on the ground");
    TryLargePolygon();
    b2Log("%d failures\n", failures);
    return failures;
}
