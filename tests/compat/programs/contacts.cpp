// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs about contacts: callbacks, sensors, platforms, manifolds, chains, destruction, bounces, continuous
// collision.

#include <set>
#include <string>
#include <vector>

#include "program.h"

namespace {

/// Counts and writes down what it hears, as Box2D users do.
class Recorder : public b2ContactListener {
public:
    void BeginContact(b2Contact* contact) override {
        touching.insert(contact);
        if (talk) Say("step %d begin %s", step, Names(contact).c_str());
    }
    void EndContact(b2Contact* contact) override {
        if (touching.erase(contact) == 0) Say("end of an unknown contact");
        if (talk) Say("step %d end %s", step, Names(contact).c_str());
    }
    void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) override {
        ++preSolves;
        b2PointState before[b2_maxManifoldPoints];
        b2PointState after[b2_maxManifoldPoints];
        b2GetPointStates(before, after, oldManifold, contact->GetManifold());
        for (int i = 0; i < contact->GetManifold()->pointCount; ++i) added += after[i] == b2_addState;
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        ++postSolves;
        if (impulse->count != contact->GetManifold()->pointCount) Say("impulses of other points");
        for (int i = 0; i < impulse->count; ++i) largest = b2Max(largest, impulse->normalImpulses[i]);
    }
    static std::string Names(b2Contact* contact) {
        return std::to_string(contact->GetFixtureA()->GetBody()->GetUserData().pointer) + ":" +
               std::to_string(contact->GetChildIndexA()) + " " +
               std::to_string(contact->GetFixtureB()->GetBody()->GetUserData().pointer) + ":" +
               std::to_string(contact->GetChildIndexB());
    }

    std::set<b2Contact*> touching;
    bool talk = true;
    int step = 0, preSolves = 0, postSolves = 0, added = 0;
    float largest = 0.0f;
};

void RunWith(b2World& world, Recorder& recorder, int steps) {
    for (int i = 0; i < steps; ++i, ++recorder.step) world.Step(1.0f / 60.0f, 8, 3);
}

}  // namespace

void ListenerSequence() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Recorder recorder;
    world.SetContactListener(&recorder);
    MakeGround(world)->GetUserData().pointer = 1;
    b2Body* box = MakeBox(world, 0.0f, 2.0f, 0.5f, 0.5f);
    box->GetUserData().pointer = 2;
    b2Body* disk = MakeDisk(world, 5.0f, 3.0f, 0.5f);
    disk->GetUserData().pointer = 3;
    RunWith(world, recorder, 120);
    Say("pre %d post %d points %d", recorder.preSolves, recorder.postSolves, recorder.added);
    Number("largest", recorder.largest);
    Say("touching %d", static_cast<int>(recorder.touching.size()));
    disk->SetLinearVelocity(b2Vec2(0.0f, 5.0f));
    RunWith(world, recorder, 30);
    box->SetTransform(b2Vec2(0.0f, 6.0f), 0.0f);
    box->SetAwake(true);
    RunWith(world, recorder, 3);
    Say("touching %d", static_cast<int>(recorder.touching.size()));
    world.SetContactListener(nullptr);
    Run(world, 10);
}

void Sensors() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Recorder recorder;
    world.SetContactListener(&recorder);
    MakeGround(world, -20.0f)->GetUserData().pointer = 1;
    b2BodyDef def;
    b2Body* zone = world.CreateBody(&def);
    zone->GetUserData().pointer = 2;
    b2CircleShape circle;
    circle.m_radius = 2.0f;
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &circle;
    fixtureDef.isSensor = true;
    zone->CreateFixture(&fixtureDef);
    b2Body* box = MakeBox(world, 0.0f, 5.0f, 0.25f, 0.25f);
    box->GetUserData().pointer = 3;
    RunWith(world, recorder, 100);
    Say("pre %d post %d", recorder.preSolves, recorder.postSolves);
    Number("y", box->GetPosition().y);
}

namespace {

class PlatformListener : public b2ContactListener {
public:
    void PreSolve(b2Contact* contact, const b2Manifold*) override {
        b2WorldManifold worldManifold;
        contact->GetWorldManifold(&worldManifold);
        b2Fixture* a = contact->GetFixtureA();
        const float up = a->GetBody()->GetType() == b2_staticBody ? worldManifold.normal.y : -worldManifold.normal.y;
        if (up < 0.5f || Rising(contact)) contact->SetEnabled(false);
    }

private:
    static bool Rising(b2Contact* contact) {
        b2Body* a = contact->GetFixtureA()->GetBody();
        b2Body* b = contact->GetFixtureB()->GetBody();
        return (a->GetType() == b2_dynamicBody ? a : b)->GetLinearVelocity().y > 0.5f;
    }
};

class BeltListener : public b2ContactListener {
public:
    explicit BeltListener(b2Fixture* belt) : m_belt(belt) {}
    void PreSolve(b2Contact* contact, const b2Manifold*) override {
        if (contact->GetFixtureA() == m_belt) contact->SetTangentSpeed(5.0f);
        if (contact->GetFixtureB() == m_belt) contact->SetTangentSpeed(-5.0f);
        if (contact->GetFriction() < 0.5f) {
            contact->SetFriction(0.8f);
            Number("mixed restitution", contact->GetRestitution());
        }
    }

private:
    b2Fixture* m_belt;
};

b2Body* MakeShelf(b2World& world, float y) {
    b2BodyDef def;
    def.position.Set(0.0f, y);
    b2Body* shelf = world.CreateBody(&def);
    b2PolygonShape box;
    box.SetAsBox(5.0f, 0.25f);
    shelf->CreateFixture(&box, 0.0f);
    return shelf;
}

}  // namespace

void OneWayPlatform() {
    b2World world(b2Vec2(0.0f, -10.0f));
    PlatformListener listener;
    world.SetContactListener(&listener);
    MakeShelf(world, 3.0f);
    b2Body* jumper = MakeBox(world, 0.0f, 1.0f, 0.4f, 0.4f);
    jumper->SetLinearVelocity(b2Vec2(0.0f, 9.0f));
    bool above = false;
    for (int i = 0; i < 180; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        above = above || jumper->GetPosition().y > 4.0f;
    }
    Say("passed from below: %d", above);
    Number("stands", jumper->GetPosition().y);
}

void ConveyorBelt() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* shelf = MakeShelf(world, 0.0f);
    BeltListener listener(shelf->GetFixtureList());
    world.SetContactListener(&listener);
    b2Body* box = MakeBox(world, -4.0f, 0.76f, 0.5f, 0.5f);
    Run(world, 90);
    Number("carried", box->GetPosition().x);
    Number("speed", box->GetLinearVelocity().x);
}

void WorldManifolds() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeShelf(world, 0.0f);
    b2Body* box = MakeBox(world, 0.3f, 0.75f, 0.5f, 0.5f);
    b2Body* disk = MakeDisk(world, 3.0f, 0.7f, 0.45f);
    MakeBox(world, -4.8f, 0.75f, 0.5f, 0.5f);  // over the corner
    Run(world, 60);
    for (b2Body* body : {box, disk}) {
        for (b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next) {
            const b2Manifold* manifold = edge->contact->GetManifold();
            b2WorldManifold points;
            edge->contact->GetWorldManifold(&points);
            Say("type %d points %d", manifold->type, manifold->pointCount);
            Number("normal", points.normal, 1e-4);
            Number("local normal", manifold->localNormal, 1e-4);
            Number("local point", manifold->localPoint, 1e-4);
            for (int i = 0; i < manifold->pointCount; ++i) {
                const b2ContactFeature& cf = manifold->points[i].id.cf;
                Say("id %d %d %d %d", cf.indexA, cf.indexB, cf.typeA, cf.typeB);
                Number("at", points.points[i]);
                Number("separation", points.separations[i]);
                Number("impulse", manifold->points[i].normalImpulse);
            }
        }
    }
}

namespace {

class BreakListener : public b2ContactListener {
public:
    void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override {
        for (int i = 0; i < impulse->count; ++i) hardest = b2Max(hardest, impulse->normalImpulses[i]);
        if (hardest > 20.0f) broken = true;
    }
    bool broken = false;
    float hardest = 0.0f;
};

}  // namespace

void Breakable() {
    b2World world(b2Vec2(0.0f, -10.0f));
    BreakListener listener;
    world.SetContactListener(&listener);
    MakeGround(world);
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 8.0f);
    def.angle = 0.25f * b2_pi;
    b2Body* body = world.CreateBody(&def);
    b2PolygonShape left;
    left.SetAsBox(0.5f, 0.5f, b2Vec2(-0.5f, 0.0f), 0.0f);
    body->CreateFixture(&left, 1.0f);
    b2PolygonShape right;
    right.SetAsBox(0.5f, 0.5f, b2Vec2(0.5f, 0.0f), 0.0f);
    b2Fixture* piece = body->CreateFixture(&right, 1.0f);
    int brokenAt = -1;
    b2Body* second = nullptr;
    for (int i = 0; i < 240; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        if (!listener.broken || brokenAt >= 0) continue;
        brokenAt = i;
        body->DestroyFixture(piece);
        b2BodyDef pieceDef;
        pieceDef.type = b2_dynamicBody;
        pieceDef.position = body->GetPosition();
        pieceDef.angle = body->GetAngle();
        second = world.CreateBody(&pieceDef);
        second->CreateFixture(&right, 1.0f);
    }
    Number("broken at", brokenAt, 1);
    Say("two bodies: %d", second != nullptr && world.GetBodyCount() == 3);
    Number("mass", body->GetMass(), 1e-4);
}

namespace {

class Goodbyes : public b2DestructionListener {
public:
    void SayGoodbye(b2Joint* joint) override {
        Say("goodbye joint %d", static_cast<int>(joint->GetUserData().pointer));
    }
    void SayGoodbye(b2Fixture* fixture) override {
        Say("goodbye fixture %d of %d", static_cast<int>(fixture->GetUserData().pointer),
            static_cast<int>(fixture->GetBody()->GetUserData().pointer));
    }
};

}  // namespace

void DestructionOrder() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Recorder recorder;
    Goodbyes goodbyes;
    world.SetContactListener(&recorder);
    world.SetDestructionListener(&goodbyes);
    b2Body* ground = MakeGround(world);
    ground->GetUserData().pointer = 1;
    b2Body* box = MakeBox(world, 0.0f, 0.5f, 0.5f, 0.5f);
    box->GetUserData().pointer = 2;
    b2CircleShape circle;
    circle.m_radius = 0.2f;
    circle.m_p.Set(0.0f, 0.6f);
    box->CreateFixture(&circle, 1.0f)->GetUserData().pointer = 5;
    b2Body* friendly = MakeBox(world, 3.0f, 0.5f, 0.5f, 0.5f);
    friendly->GetUserData().pointer = 3;
    for (int i = 0; i < 2; ++i) {
        b2DistanceJointDef def;
        def.Initialize(box, friendly, box->GetPosition(), friendly->GetPosition());
        world.CreateJoint(&def)->GetUserData().pointer = static_cast<uintptr_t>(30 + i);
    }
    RunWith(world, recorder, 20);
    friendly->DestroyFixture(friendly->GetFixtureList());
    world.DestroyBody(box);
    Say("left: %d bodies %d joints %d touching", world.GetBodyCount(), world.GetJointCount(),
        static_cast<int>(recorder.touching.size()));
    RunWith(world, recorder, 5);
    world.DestroyBody(ground);
    Say("left: %d bodies %d contacts", world.GetBodyCount(), world.GetContactCount());
}

void ChainTerrain() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Recorder recorder;
    world.SetContactListener(&recorder);
    b2BodyDef def;
    b2Body* ground = world.CreateBody(&def);
    ground->GetUserData().pointer = 1;
    std::vector<b2Vec2> vertices;
    for (int i = 0; i <= 20; ++i) vertices.push_back(b2Vec2(20.0f - 2.0f * static_cast<float>(i), 0.0f));
    b2ChainShape chain;
    chain.CreateChain(vertices.data(), static_cast<int32>(vertices.size()), b2Vec2(22.0f, 0.0f), b2Vec2(-22.0f, 0.0f));
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &chain;
    fixtureDef.friction = 0.0f;
    b2Fixture* fixture = ground->CreateFixture(&fixtureDef);
    Say("type %d children %d fixtures %d", fixture->GetType(), fixture->GetShape()->GetChildCount(),
        ground->GetFixtureList()->GetNext() == nullptr);
    b2Body* slider = MakeBox(world, -3.3f, 0.6f, 0.5f, 0.5f);
    slider->GetUserData().pointer = 2;
    slider->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    RunWith(world, recorder, 120);
    // No ghost collisions: it slides over the seams without turning or slowing down.
    Number("slid", slider->GetPosition());
    Number("angle", slider->GetAngle());
    for (b2ContactEdge* edge = slider->GetContactList(); edge; edge = edge->next) {
        if (edge->contact->IsTouching() && edge->contact->GetFixtureA() != fixture) Say("another fixture");
    }
    // One-sided: nothing stops it from below.
    b2Body* riser = MakeBox(world, 10.0f, -2.0f, 0.4f, 0.4f);
    riser->SetLinearVelocity(b2Vec2(0.0f, 12.0f));
    recorder.talk = false;
    RunWith(world, recorder, 20);
    Say("passed from below: %d", riser->GetPosition().y > 0.5f);
    ground->DestroyFixture(fixture);
    Say("contacts %d proxies %d", world.GetContactCount(), world.GetProxyCount());
}

void ChainLoop() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body* island = world.CreateBody(&def);
    const b2Vec2 corners[] = {b2Vec2(-4.0f, -2.0f), b2Vec2(4.0f, -2.0f), b2Vec2(4.0f, 0.0f), b2Vec2(-4.0f, 0.0f)};
    b2ChainShape loop;
    loop.CreateLoop(corners, 4);
    Say("children %d vertices %d", loop.GetChildCount(), loop.m_count);
    for (int i = 0; i < loop.GetChildCount(); ++i) {
        b2EdgeShape edge;
        loop.GetChildEdge(&edge, i);
        Number("v0", edge.m_vertex0);
        Number("v3", edge.m_vertex3);
        Say("one-sided %d", edge.m_oneSided);
    }
    island->CreateFixture(&loop, 0.0f);
    b2Body* box = MakeBox(world, 1.0f, 0.6f, 0.5f, 0.5f);
    b2Body* disk = MakeDisk(world, -3.9f, 1.0f, 0.4f);
    disk->SetLinearVelocity(b2Vec2(-1.0f, 0.0f));
    Run(world, 60);
    Number("box", box->GetPosition());
    Run(world, 60);
    Say("rolled off: %d", disk->GetPosition().y < 0.0f);
    Number("mass", box->GetMass());
}

void ContactGraph() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    ground->GetUserData().pointer = 1;
    for (int i = 0; i < 4; ++i) {
        MakeBox(world, 0.0f, 0.5f + 1.0f * static_cast<float>(i), 0.5f, 0.5f)->GetUserData().pointer =
            static_cast<uintptr_t>(2 + i);
    }
    Run(world, 60);
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) {
        std::set<uintptr_t> others;
        for (b2ContactEdge* edge = b->GetContactList(); edge; edge = edge->next) {
            if (edge->contact->IsTouching()) others.insert(edge->other->GetUserData().pointer);
            b2Contact* c = edge->contact;
            if (c->GetFixtureA()->GetBody() != b && c->GetFixtureB()->GetBody() != b) Say("not mine");
        }
        std::string text;
        for (const uintptr_t other : others) text += std::to_string(other) + " ";
        Say("%d touches %s", static_cast<int>(b->GetUserData().pointer), text.c_str());
    }
    int count = 0;
    for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) {
        ++count;
        if (c->IsTouching()) Say("contact");
    }
    Say("all listed: %d", count == world.GetContactCount());
    const b2ContactManager& manager = world.GetContactManager();
    Say("manager %d %d", manager.m_contactCount == count, manager.m_broadPhase.GetProxyCount());
}

void Bounces() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    const float restitutions[] = {0.0f, 0.3f, 0.5f, 0.9f};
    b2Body* balls[4];
    for (int i = 0; i < 4; ++i) {
        balls[i] = MakeDisk(world, 3.0f * static_cast<float>(i), 5.0f, 0.5f);
        balls[i]->GetFixtureList()->SetRestitution(restitutions[i]);
    }
    float highest[4] = {};
    for (int step = 0; step < 130; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        for (int i = 0; i < 4; ++i) {
            if (step > 65) highest[i] = b2Max(highest[i], balls[i]->GetPosition().y);
        }
    }
    for (int i = 0; i < 4; ++i) Number("height", highest[i]);
}

void ThinWall() {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    b2Body* wall = world.CreateBody(&def);
    b2PolygonShape thin;
    thin.SetAsBox(0.05f, 5.0f);
    wall->CreateFixture(&thin, 0.0f);
    int stopped = 0;
    for (int i = 0; i < 10; ++i) {
        b2Body* shot =
            MakeBox(world, -5.0f - 0.17f * static_cast<float>(i), -4.0f + 0.9f * static_cast<float>(i), 0.1f, 0.1f);
        shot->SetLinearVelocity(b2Vec2(100.0f, 0.0f));
    }
    // A bullet hits a moving box, another passes it.
    b2Body* target = MakeBox(world, 50.0f, 0.0f, 0.05f, 1.0f);
    b2Body* bullet = MakeDisk(world, 45.0f, 0.0f, 0.1f, 20.0f);
    bullet->SetBullet(true);
    bullet->SetLinearVelocity(b2Vec2(110.0f, 0.0f));
    Run(world, 10);
    for (b2Body* b = world.GetBodyList(); b; b = b->GetNext()) {
        if (b != wall && b != target && b != bullet && b->GetPosition().x < 0.0f) ++stopped;
    }
    Say("stopped %d bullet %d", stopped, bullet->IsBullet());
    Say("target hit: %d", target->GetLinearVelocity().x > 1.0f);
}

void BeginOrder() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Recorder recorder;
    world.SetContactListener(&recorder);
    MakeGround(world)->GetUserData().pointer = 1;
    // Touching from the start, then landing together, then colliding in the air in pairs.
    for (int i = 0; i < 3; ++i) {
        MakeBox(world, 2.0f * static_cast<float>(i), 0.5f, 0.5f, 0.5f)->GetUserData().pointer =
            static_cast<uintptr_t>(10 + i);
    }
    for (int i = 0; i < 4; ++i) {
        MakeDisk(world, 8.0f + 2.0f * static_cast<float>(i), 3.0f, 0.5f)->GetUserData().pointer =
            static_cast<uintptr_t>(20 + i);
    }
    for (int i = 0; i < 3; ++i) {
        b2Body* left = MakeDisk(world, -10.0f, 20.0f + 3.0f * static_cast<float>(i), 0.5f);
        left->GetUserData().pointer = static_cast<uintptr_t>(30 + i);
        left->SetLinearVelocity(b2Vec2(2.0f, 0.0f));
        b2Body* right = MakeDisk(world, -7.0f, 20.0f + 3.0f * static_cast<float>(i), 0.5f);
        right->GetUserData().pointer = static_cast<uintptr_t>(40 + i);
        right->SetLinearVelocity(b2Vec2(-2.0f, 0.0f));
    }
    RunWith(world, recorder, 31);
    for (b2Contact* c = world.GetContactList(); c; c = c->GetNext()) {
        if (c->IsTouching()) Say("listed %s", Recorder::Names(c).c_str());
    }
    RunWith(world, recorder, 40);
}
