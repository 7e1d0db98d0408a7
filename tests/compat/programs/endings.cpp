// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs that create and destroy in callbacks that come outside of Step: of destruction, disabling, queries.

#include <string>
#include <vector>

#include "program.h"

namespace {

int IdOf(b2Body* body) { return static_cast<int>(body->GetUserData().pointer); }

int TouchingOf(b2Body* body) {
    int count = 0;
    for (b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next) count += edge->contact->IsTouching();
    return count;
}

/// Leaves a spark where a contact ends, and takes the fuse away when its own one does.
class Spawner : public b2ContactListener, public b2DestructionListener {
public:
    explicit Spawner(b2World& world) : m_world(world) {}
    void EndContact(b2Contact* contact) override {
        b2Body* a = contact->GetFixtureA()->GetBody();
        b2Body* b = contact->GetFixtureB()->GetBody();
        const int other = IdOf(a) == subject ? IdOf(b) : IdOf(a);
        Say("end %d, touching %d, locked %d, points %d, others %d", other, contact->IsTouching(), m_world.IsLocked(),
            contact->GetManifold()->pointCount, TouchingOf(a) + TouchingOf(b));
        if (m_world.IsLocked()) return;
        b2Body* spark = MakeDisk(m_world, static_cast<float>(other), 20.0f, 0.2f);
        spark->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
        sparks.push_back(spark);
        if (fuse != nullptr) {
            m_world.DestroyBody(fuse);
            fuse = nullptr;
        }
    }
    void SayGoodbye(b2Joint* joint) override {
        Say("joint goes, locked %d", m_world.IsLocked());
        // What held one now holds the spark and the ground.
        b2RevoluteJointDef def;
        def.Initialize(joint->GetBodyB(), MakeDisk(m_world, 30.0f, 20.0f, 0.2f), b2Vec2(30.0f, 20.0f));
        m_world.CreateJoint(&def);
    }
    void SayGoodbye(b2Fixture* fixture) override {
        Say("fixture goes, enabled %d contacts %d", fixture->GetBody()->IsEnabled(), TouchingOf(fixture->GetBody()));
        sparks.push_back(MakeBox(m_world, 10.0f + static_cast<float>(sparks.size()), 25.0f, 0.1f, 0.1f));
    }

    int subject = 0;
    b2Body* fuse = nullptr;
    std::vector<b2Body*> sparks;

private:
    b2World& m_world;
};

}  // namespace

void CallbackEdits() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Spawner spawner(world);
    MakeGround(world)->GetUserData().pointer = 1;
    b2Body* below = MakeBox(world, 0.0f, 0.5f, 0.5f, 0.5f);
    below->GetUserData().pointer = 2;
    b2Body* middle = MakeBox(world, 0.0f, 1.5f, 0.5f, 0.5f);
    middle->GetUserData().pointer = 3;
    b2Body* above = MakeBox(world, 0.0f, 2.5f, 0.5f, 0.5f);
    above->GetUserData().pointer = 4;
    b2Body* far = MakeBox(world, 8.0f, 0.5f, 0.5f, 0.5f);
    far->GetUserData().pointer = 5;
    b2Body* fuse = MakeBox(world, -8.0f, 3.0f, 0.5f, 0.5f);
    fuse->GetUserData().pointer = 6;
    b2DistanceJointDef rope;
    rope.Initialize(middle, far, middle->GetPosition(), far->GetPosition());
    world.CreateJoint(&rope);
    world.SetContactListener(&spawner);
    world.SetDestructionListener(&spawner);
    Run(world, 20);
    spawner.subject = 3;
    spawner.fuse = fuse;
    world.DestroyBody(middle);
    Say("bodies %d joints %d contacts touching %d %d", world.GetBodyCount(), world.GetJointCount(), TouchingOf(below),
        TouchingOf(above));
    Run(world, 10);
    Pose("first spark", spawner.sparks[0]);
    spawner.subject = 2;
    below->SetEnabled(false);
    Say("bodies %d", world.GetBodyCount());
    below->SetEnabled(true);
    Run(world, 5);
    spawner.subject = 5;
    far->SetType(b2_staticBody);
    Say("bodies %d", world.GetBodyCount());
    Run(world, 5);
    far->DestroyFixture(far->GetFixtureList());
    Say("bodies %d fixtures %d", world.GetBodyCount(), far->GetFixtureList() != nullptr);
    Run(world, 60);
    for (b2Body* spark : spawner.sparks) Number("spark", spark->GetPosition());
    Number("above", above->GetPosition());
}

namespace {

/// A blast: destroys what lies in a box and leaves a fragment for each.
class Blast : public b2QueryCallback, public b2RayCastCallback {
public:
    explicit Blast(b2World& world) : m_world(world) {}
    bool ReportFixture(b2Fixture* fixture) override {
        if (fixture->GetBody()->GetType() != b2_dynamicBody) return true;
        ++found;
        const b2Vec2 at = fixture->GetBody()->GetPosition();
        m_world.DestroyBody(fixture->GetBody());
        MakeDisk(m_world, at.x, at.y + 20.0f, 0.1f);
        return true;
    }
    float ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2&, float fraction) override {
        Number("struck", point);
        fixture->GetBody()->CreateFixture(fixture->GetShape(), 2.0f);
        return fraction;
    }
    int found = 0;

private:
    b2World& m_world;
};

}  // namespace

void QueryEdits() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    for (int i = 0; i < 6; ++i) MakeBox(world, 3.0f * static_cast<float>(i), 0.5f, 0.5f, 0.5f);
    Run(world, 10);
    Blast blast(world);
    b2AABB box;
    box.lowerBound.Set(5.0f, 0.2f);
    box.upperBound.Set(6.5f, 2.0f);
    world.QueryAABB(&blast, box);
    Say("found %d bodies %d", blast.found, world.GetBodyCount());
    world.RayCast(&blast, b2Vec2(14.0f, 8.0f), b2Vec2(15.0f, -1.0f));
    Run(world, 10);
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) {
        Number("mass", b->GetMass(), 1e-4);
        Number("at", b->GetPosition());
    }
}

namespace {

/// Says what the bodies of an ending contact are at that moment.
class StateTeller : public b2ContactListener {
public:
    explicit StateTeller(b2World& world) : m_world(world) {}
    void EndContact(b2Contact* contact) override {
        b2Body* bodies[] = {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()};
        for (b2Body* b : bodies) {
            int fixtures = 0;
            for (b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext()) ++fixtures;
            Say("end at %d: enabled %d type %d bullet %d fixtures %d touching %d", IdOf(b), b->IsEnabled(),
                b->GetType(), b->IsBullet(), fixtures, TouchingOf(b));
            if (b->GetType() != b2_staticBody) Say("awake %d", b->IsAwake());
            Number("mass", b->GetMass(), 1e-4);
            Number("inertia", b->GetInertia(), 1e-4);
            Number("velocity", b->GetLinearVelocity());
        }
        int listed = 0;
        for (b2Contact* c = m_world.GetContactList(); c; c = c->GetNext()) listed += c->IsTouching();
        Say("points %d enabled %d listed %d", contact->GetManifold()->pointCount, contact->IsEnabled(), listed);
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        Number("up", manifold.normal.y);
        Number("friction", contact->GetFriction(), 1e-6);
        Number("restitution", contact->GetRestitution(), 1e-6);
        Number("tangent speed", contact->GetTangentSpeed(), 1e-6);
        if (victim == nullptr) return;
        b2Body* gone = victim;
        victim = nullptr;
        m_world.DestroyBody(gone);
    }

    b2Body* victim = nullptr;

private:
    b2World& m_world;
};

}  // namespace

namespace {

/// Three boxes on each other, and one beside them, after ten steps.
struct Stack {
    explicit Stack(b2BodyType middleType) {
        MakeGround(world)->GetUserData().pointer = 1;
        for (int i = 0; i < 3; ++i) bodies[i] = MakeBox(world, 0.0f, 0.5f + static_cast<float>(i), 0.5f, 0.5f);
        bodies[3] = MakeBox(world, 5.0f, 0.5f, 0.5f, 0.5f);
        for (int i = 0; i < 4; ++i) bodies[i]->GetUserData().pointer = static_cast<uintptr_t>(2 + i);
        bodies[1]->SetType(middleType);
        world.SetContactListener(&teller);
        Run(world, 10);
    }

    b2World world{b2Vec2(0.0f, -10.0f)};
    StateTeller teller{world};
    b2Body* bodies[4];
};

}  // namespace

/// A body of two touching neighbours is disabled, gets other types, loses a fixture: what do the callbacks see?
void EditedBodies() {
    {
        Say("disable");
        Stack stack(b2_dynamicBody);
        stack.bodies[1]->SetEnabled(false);
        stack.bodies[1]->SetEnabled(false);
        stack.bodies[1]->SetEnabled(true);
        Run(stack.world, 2);
        Say("contacts %d", TouchingOf(stack.bodies[1]));
    }
    const b2BodyType types[][2] = {{b2_dynamicBody, b2_kinematicBody}, {b2_dynamicBody, b2_staticBody},
                                   {b2_kinematicBody, b2_dynamicBody}, {b2_staticBody, b2_dynamicBody},
                                   {b2_staticBody, b2_kinematicBody},  {b2_dynamicBody, b2_dynamicBody}};
    for (const auto& [from, to] : types) {
        Say("type %d to %d", from, to);
        Stack stack(from);
        if (from == b2_dynamicBody) stack.bodies[1]->SetLinearVelocity(b2Vec2(0.5f, -0.25f));
        stack.bodies[1]->ApplyForceToCenter(b2Vec2(1000.0f, 0.0f), true);
        stack.bodies[1]->SetType(to);
        Run(stack.world, 3);
        Say("contacts %d", TouchingOf(stack.bodies[1]));
    }
    {
        Say("fixture");
        Stack stack(b2_dynamicBody);
        b2PolygonShape second;
        second.SetAsBox(0.5f, 0.5f);
        b2Body* middle = stack.bodies[1];
        middle->CreateFixture(&second, 1.0f);
        middle->DestroyFixture(middle->GetFixtureList()->GetNext());
        Run(stack.world, 2);
    }
    {
        Say("destroy another body meanwhile");
        Stack stack(b2_dynamicBody);
        stack.teller.victim = stack.bodies[3];
        stack.bodies[0]->SetEnabled(false);
        Say("bodies %d contacts %d", stack.world.GetBodyCount(), TouchingOf(stack.bodies[1]));
        Run(stack.world, 5);
        Number("above", stack.bodies[2]->GetPosition());
    }
}
