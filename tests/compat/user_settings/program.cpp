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

/// A wheel of twelve corners: its mass against the closed form, a ray, a box, and how it rests.
void TryLargePolygon(b2World& world) {
    static_assert(sizeof(b2PolygonShape::m_vertices) == 12 * sizeof(b2Vec2));
    b2Vec2 ring[12];
    for (int i = 0; i < 12; ++i) {
        const float angle = 2.0f * b2_pi * (static_cast<float>(i) + 0.5f) / 12.0f;
        ring[i].Set(cosf(angle), sinf(angle));
    }
    b2PolygonShape polygon;
    polygon.Set(ring, 12);
    Expect(polygon.m_count == 12 && polygon.Validate(), "12 vertices are taken");
    b2MassData mass;
    polygon.ComputeMass(&mass, 2.0f);
    Expect(b2Abs(mass.mass - 6.0f) < 1e-4f, "area of a regular 12-gon: 3");
    Expect(b2Distance(mass.center, b2Vec2_zero) < 1e-5f &&
               b2Abs(mass.I - 6.0f * (2.0f + cosf(b2_pi / 6.0f)) / 6.0f) < 1e-3f,
           "and its inertia: m(2 + cos(2π/12))/6");
    b2Transform xf;
    xf.SetIdentity();
    b2RayCastInput ray{b2Vec2(-3.0f, 0.0f), b2Vec2(3.0f, 0.0f), 1.0f};
    b2RayCastOutput hit{};
    Expect(polygon.RayCast(&hit, ray, xf, 0) && b2Abs(hit.fraction - (3.0f - cosf(b2_pi / 12.0f)) / 6.0f) < 1e-5f,
           "a ray hits its side");
    Expect(polygon.TestPoint(xf, b2Vec2(0.9f, 0.0f)) && !polygon.TestPoint(xf, b2Vec2(0.99f, 0.0f)), "points");
    b2Body* wheel = MakePlayer(world, "wheel", 3, -6.0f);
    wheel->DestroyFixture(wheel->GetFixtureList());
    wheel->CreateFixture(&polygon, 1.0f);
    for (int i = 0; i < 180; ++i) world.Step(1.0f / 60.0f, 8, 3);
    Expect(b2Abs(wheel->GetPosition().y - cosf(b2_pi / 12.0f)) < 0.03f, "it rests on a side");
    b2ContactEdge* edge = wheel->GetContactList();
    Expect(edge && edge->contact->GetManifold()->pointCount == 2, "with two points");
    b2Manifold again;
    edge->contact->Evaluate(&again, edge->contact->GetFixtureA()->GetBody()->GetTransform(), wheel->GetTransform());
    Expect(again.pointCount == 2, "evaluated anew too");
    Expect(static_cast<b2PolygonShape*>(wheel->GetFixtureList()->GetShape())->m_count == 12,
           "the fixture's copy has 12");
    polygon.SetAsBox(1.0f, 1.0f);
    ring[3].Set(NAN, 0.0f);
    polygon.Set(ring, 12);
    Expect(polygon.m_count == 4, "bad points change nothing");
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
    TryLargePolygon(world);
    b2Log("%d failures\n", failures);
    return failures;
}
