// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs about bodies and fixtures: types, masses, filters, sleep, forces, lists, edits.

// Programs name classes before they include anything.
class b2World;
class b2Body;
struct b2Vec2;
class b2ContactListener;

#include "program.h"

// ... and after.
class b2World;
class b2Joint;

void HelloWorld() {
    b2Vec2 gravity(0.0f, -10.0f);
    b2World world(gravity);
    b2BodyDef groundBodyDef;
    groundBodyDef.position.Set(0.0f, -10.0f);
    b2Body* groundBody = world.CreateBody(&groundBodyDef);
    b2PolygonShape groundBox;
    groundBox.SetAsBox(50.0f, 10.0f);
    groundBody->CreateFixture(&groundBox, 0.0f);

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

    // A reference kept over steps shows the present value.
    const b2Vec2& position = body->GetPosition();
    for (int32 i = 0; i < 60; ++i) {
        world.Step(1.0f / 60.0f, 6, 2);
        if (i % 10 == 0) Number("y", position.y);
    }
    Pose("end", body);
    Say("version %d.%d.%d", b2_version.major, b2_version.minor, b2_version.revision);
}

void BodyTypes() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2BodyDef def;
    def.type = b2_kinematicBody;
    def.position.Set(0.0f, 2.0f);
    def.linearVelocity.Set(1.0f, 0.0f);
    b2Body* platform = world.CreateBody(&def);
    b2PolygonShape shape;
    shape.SetAsBox(4.0f, 0.5f);
    platform->CreateFixture(&shape, 2.0f);
    b2Body* rider = MakeBox(world, 0.0f, 3.01f, 0.5f, 0.5f);
    Run(world, 60);
    Pose("platform", platform);
    Number("rider", rider->GetPosition(), 5e-3);
    Number("mass", platform->GetMass());
    platform->SetType(b2_staticBody);
    Say("static %d awake %d", platform->GetType() == b2_staticBody, platform->IsAwake());
    Number("speed", platform->GetLinearVelocity());
    Run(world, 60);
    platform->SetType(b2_dynamicBody);
    Number("mass", platform->GetMass());
    Run(world, 180);
    Number("platform y", platform->GetPosition().y);
    Number("rider y", rider->GetPosition().y);
}

void UserData() {
    b2World world(b2Vec2(0.0f, -10.0f));
    int a = 1;
    int b = 2;
    b2BodyDef def;
    def.userData.pointer = reinterpret_cast<uintptr_t>(&a);
    b2Body* body = world.CreateBody(&def);
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &circle;
    fixtureDef.userData.pointer = reinterpret_cast<uintptr_t>(&b);
    b2Fixture* fixture = body->CreateFixture(&fixtureDef);
    b2Body* other = MakeBox(world, 3.0f, 0.0f, 1.0f, 1.0f);
    b2WeldJointDef weld;
    weld.Initialize(body, other, b2Vec2(1.0f, 0.0f));
    weld.userData.pointer = 77;
    b2Joint* joint = world.CreateJoint(&weld);
    Say("%d %d %d", *reinterpret_cast<int*>(body->GetUserData().pointer),
        *reinterpret_cast<int*>(fixture->GetUserData().pointer), static_cast<int>(joint->GetUserData().pointer));
    body->GetUserData().pointer = 5;
    fixture->GetUserData().pointer = 6;
    joint->GetUserData().pointer = 7;
    Say("%d %d %d", static_cast<int>(world.GetBodyList()->GetNext()->GetUserData().pointer),
        static_cast<int>(body->GetFixtureList()->GetUserData().pointer),
        static_cast<int>(world.GetJointList()->GetUserData().pointer));
    Say("%d %d", static_cast<int>(other->GetUserData().pointer), body->GetWorld() == &world);
}

void Masses() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* body = MakeBox(world, 1.0f, 2.0f, 0.5f, 1.0f, 3.0f);
    b2CircleShape circle;
    circle.m_p.Set(1.0f, 0.5f);
    circle.m_radius = 0.7f;
    b2Fixture* extra = body->CreateFixture(&circle, 2.0f);
    const b2Vec2 triangle[] = {b2Vec2(-1.0f, 0.0f), b2Vec2(2.0f, 0.0f), b2Vec2(0.0f, 1.5f)};
    b2PolygonShape polygon;
    polygon.Set(triangle, 3);
    body->CreateFixture(&polygon, 1.0f);
    const auto report = [&](const char* when) {
        b2MassData data;
        body->GetMassData(&data);
        Number(std::string(when) + " mass", data.mass, 1e-5);
        Number(std::string(when) + " center", data.center, 1e-5);
        Number(std::string(when) + " I", data.I, 1e-4);
        Number(std::string(when) + " inertia", body->GetInertia(), 1e-4);
        Number(std::string(when) + " world", body->GetWorldCenter(), 1e-5);
    };
    report("three");
    b2MassData part;
    extra->GetMassData(&part);
    Number("part", part.mass, 1e-5);
    Number("part I", part.I, 1e-5);
    extra->SetDensity(5.0f);
    report("unchanged");
    body->ResetMassData();
    report("denser");
    body->DestroyFixture(extra);
    report("two");
    b2MassData own;
    own.mass = 10.0f;
    own.center.Set(0.2f, 0.1f);
    own.I = 20.0f;
    body->SetAngularVelocity(1.0f);
    body->SetMassData(&own);
    report("own");
    Number("velocity", body->GetLinearVelocity(), 1e-5);
    body->SetFixedRotation(true);
    report("fixed");
    Number("turning", body->GetAngularVelocity());
}

namespace {

class OddFilter : public b2ContactFilter {
public:
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override {
        ++asked;
        const auto sum = fixtureA->GetUserData().pointer + fixtureB->GetUserData().pointer;
        return sum % 2 == 0 && b2ContactFilter::ShouldCollide(fixtureA, fixtureB);
    }
    int asked = 0;
};

void DropThree(b2World& world, b2Body* (&boxes)[3]) {
    for (int i = 0; i < 3; ++i) boxes[i] = MakeBox(world, 3.0f * static_cast<float>(i), 2.0f, 0.5f, 0.5f);
}

}  // namespace

void Filters() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* boxes[3];
    DropThree(world, boxes);
    b2Filter filter;
    filter.categoryBits = 0x0002;
    filter.maskBits = 0x0004;
    boxes[0]->GetFixtureList()->SetFilterData(filter);
    filter.maskBits = 0xFFFF;
    filter.groupIndex = -3;
    boxes[1]->GetFixtureList()->SetFilterData(filter);
    ground->GetFixtureList()->SetFilterData(filter);
    Run(world, 90);
    for (const b2Body* box : boxes) Say("fell through: %d", box->GetPosition().y < 0.0f);

    b2World second(b2Vec2(0.0f, -10.0f));
    MakeGround(second);
    DropThree(second, boxes);
    for (int i = 0; i < 3; ++i) boxes[i]->GetFixtureList()->GetUserData().pointer = static_cast<uintptr_t>(i);
    OddFilter odd;
    second.SetContactFilter(&odd);
    Run(second, 90);
    for (const b2Body* box : boxes) Say("fell through: %d", box->GetPosition().y < 0.0f);
    Say("asked: %d", odd.asked > 0);

    // A filter that changes while they touch takes the floor away.
    filter = b2Filter();
    filter.maskBits = 0;
    boxes[2]->GetFixtureList()->SetFilterData(filter);
    boxes[2]->SetAwake(true);
    Run(second, 60);
    Say("fell through: %d", boxes[2]->GetPosition().y < 0.0f);
}

void Sleeping() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* box = MakeBox(world, 0.0f, 1.0f, 0.5f, 0.5f);
    b2Body* restless = MakeBox(world, 5.0f, 0.5f, 0.5f, 0.5f);
    restless->SetSleepingAllowed(false);
    int asleepAt = -1;
    for (int i = 0; i < 240; ++i) {
        world.Step(1.0f / 60.0f, 8, 3);
        if (asleepAt < 0 && !box->IsAwake()) asleepAt = i;
    }
    Number("asleep at step", asleepAt, 3);
    Say("%d %d %d", box->IsAwake(), restless->IsAwake(), restless->IsSleepingAllowed());
    Number("rest", box->GetPosition().y);
    box->ApplyForceToCenter(b2Vec2(5.0f, 0.0f), false);
    Run(world, 1);
    Say("not woken: %d", !box->IsAwake());
    box->ApplyLinearImpulseToCenter(b2Vec2(1.0f, 0.0f), true);
    Say("woken: %d", box->IsAwake());
    box->SetAwake(false);
    Number("stopped", box->GetLinearVelocity());
    MakeBox(world, 0.0f, 3.0f, 0.5f, 0.5f);
    Run(world, 60);
    Say("woken by a hit: %d", box->IsAwake());
    world.SetAllowSleeping(false);
    Run(world, 120);
    Say("never asleep: %d %d", box->IsAwake(), world.GetAllowSleeping());
}

void Forces() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* body = MakeBox(world, 0.0f, 10.0f, 0.5f, 0.5f, 2.0f);
    body->SetLinearDamping(0.5f);
    body->SetAngularDamping(0.2f);
    body->SetGravityScale(0.5f);
    for (int i = 0; i < 30; ++i) {
        body->ApplyForce(b2Vec2(4.0f, 3.0f), body->GetWorldPoint(b2Vec2(0.3f, 0.2f)), true);
        body->ApplyTorque(0.3f, true);
        world.Step(1.0f / 60.0f, 8, 3);
    }
    Pose("pushed", body, 1e-4);
    Number("v", body->GetLinearVelocity(), 1e-4);
    Number("w", body->GetAngularVelocity(), 1e-4);
    body->ApplyLinearImpulse(b2Vec2(1.0f, 2.0f), body->GetWorldPoint(b2Vec2(-0.5f, 0.5f)), true);
    body->ApplyAngularImpulse(-0.4f, true);
    Number("v", body->GetLinearVelocity(), 1e-4);
    Number("w", body->GetAngularVelocity(), 1e-4);
    Number("point v", body->GetLinearVelocityFromWorldPoint(b2Vec2(1.0f, 1.0f)), 1e-3);
    Number("local v", body->GetLinearVelocityFromLocalPoint(b2Vec2(1.0f, 1.0f)), 1e-3);
    Number("local", body->GetLocalPoint(b2Vec2(3.0f, 4.0f)), 1e-3);
    Number("vector", body->GetWorldVector(body->GetLocalVector(b2Vec2(1.0f, 2.0f))), 1e-5);
    world.SetGravity(b2Vec2(3.0f, 0.0f));
    world.SetAutoClearForces(false);
    body->ApplyForceToCenter(b2Vec2(0.0f, 8.0f), true);
    Run(world, 20);
    world.ClearForces();
    Run(world, 20);
    Pose("after", body, 1e-3);
    Say("%d", world.GetAutoClearForces());
    body->SetTransform(b2Vec2(1.0f, 1.0f), 7.0f);
    Pose("placed", body, 1e-6);
    // Box2D 2.4 moves at most 2 m in a step.
    body->SetLinearVelocity(b2Vec2(1000.0f, 0.0f));
    body->SetLinearDamping(0.0f);
    Run(world, 1);
    Number("capped", body->GetPosition().x, 1e-3);
}

void Lists() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* bodies[5];
    for (int i = 0; i < 5; ++i) {
        bodies[i] =
            i % 2 == 0 ? MakeBox(world, 3.0f * static_cast<float>(i), 0.0f, 0.5f, 0.5f) : MakeGround(world, -5.0f);
        bodies[i]->GetUserData().pointer = static_cast<uintptr_t>(i);
    }
    b2CircleShape circle;
    circle.m_radius = 0.3f;
    for (int i = 0; i < 3; ++i)
        bodies[0]->CreateFixture(&circle, 1.0f)->GetUserData().pointer = static_cast<uintptr_t>(10 + i);
    for (int i = 0; i < 2; ++i) {
        b2DistanceJointDef def;
        def.Initialize(bodies[0], bodies[2 + 2 * i], bodies[0]->GetPosition(), bodies[2 + 2 * i]->GetPosition());
        world.CreateJoint(&def)->GetUserData().pointer = static_cast<uintptr_t>(20 + i);
    }
    const auto dump = [&] {
        std::string text;
        for (b2Body* b = world.GetBodyList(); b; b = b->GetNext())
            text += std::to_string(b->GetUserData().pointer) + " ";
        for (b2Joint* j = world.GetJointList(); j; j = j->GetNext())
            text += std::to_string(j->GetUserData().pointer) + " ";
        for (b2Fixture* f = bodies[0]->GetFixtureList(); f; f = f->GetNext())
            text += std::to_string(f->GetUserData().pointer) + " ";
        for (b2JointEdge* e = bodies[0]->GetJointList(); e; e = e->next) {
            text += std::to_string(e->joint->GetUserData().pointer) + ">" +
                    std::to_string(e->other->GetUserData().pointer) + " ";
        }
        Say("%s: %d bodies %d joints %d proxies", text.c_str(), world.GetBodyCount(), world.GetJointCount(),
            world.GetProxyCount());
    };
    dump();
    world.DestroyBody(bodies[3]);
    bodies[0]->DestroyFixture(bodies[0]->GetFixtureList()->GetNext());
    dump();
    world.DestroyBody(bodies[4]);
    dump();
}

void FixtureEdits() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* ball = MakeDisk(world, 0.0f, 3.0f, 0.5f);
    b2Fixture* fixture = ball->GetFixtureList();
    fixture->SetRestitution(0.5f);
    fixture->SetFriction(0.9f);
    fixture->SetRestitutionThreshold(2.0f);
    Number("r", fixture->GetRestitution());
    Number("f", fixture->GetFriction());
    Number("t", fixture->GetRestitutionThreshold());
    Run(world, 60);
    Number("bounce", ball->GetPosition().y, 5e-3);
    Run(world, 300);
    Number("rest", ball->GetPosition().y);
    // The shape of a fixture may be changed.
    static_cast<b2CircleShape*>(fixture->GetShape())->m_radius = 0.8f;
    ball->SetAwake(true);
    Run(world, 240);
    Number("larger", ball->GetPosition().y, 2e-3);
    fixture->SetSensor(true);
    Say("sensor %d type %d", fixture->IsSensor(), fixture->GetType());
    Run(world, 30);
    Say("through: %d", ball->GetPosition().y < 0.5f);
    b2AABB box = ground->GetFixtureList()->GetAABB(0);
    Number("box", box.GetCenter(), 0.2);
    Say("%d %d", fixture->TestPoint(ball->GetPosition()), fixture->TestPoint(b2Vec2(50.0f, 0.0f)));
}

void EnabledBodies() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* box = MakeBox(world, 0.0f, 0.5f, 0.5f, 0.5f);
    Run(world, 60);
    Say("%d proxies, contacts %d", world.GetProxyCount(), world.GetContactCount());
    ground->SetEnabled(false);
    Say("%d proxies, contacts %d, %d", world.GetProxyCount(), world.GetContactCount(), ground->IsEnabled());
    box->SetAwake(true);
    Run(world, 30);
    Say("falls: %d", box->GetPosition().y < 0.0f);
    box->SetEnabled(false);
    const float y = box->GetPosition().y;
    Run(world, 30);
    Say("frozen: %d", box->GetPosition().y == y);
    box->SetTransform(b2Vec2(0.0f, 2.0f), 0.0f);
    ground->SetEnabled(true);
    box->SetEnabled(true);
    box->SetAwake(true);
    Run(world, 180);
    Number("rest", box->GetPosition().y);
}

void StepZero() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* box = MakeBox(world, 0.0f, 0.5f, 0.5f, 0.5f);
    world.Step(0.0f, 8, 3);
    Say("contacts %d touching %d", world.GetContactCount(), world.GetContactList()->IsTouching());
    Pose("still", box, 1e-6);
    Say("locked %d", world.IsLocked());
    world.SetWarmStarting(false);
    world.SetContinuousPhysics(false);
    world.SetSubStepping(true);
    Say("%d %d %d", world.GetWarmStarting(), world.GetContinuousPhysics(), world.GetSubStepping());
    Number("gravity", world.GetGravity());
}
