// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Longer programs in the style of games: what Box2D's users build from bodies, joints, listeners and queries.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "program.h"

namespace {

int IdOf(const b2Fixture* fixture) { return static_cast<int>(const_cast<b2Fixture*>(fixture)->GetUserData().pointer); }

b2Fixture* AddBox(b2Body* body, float hx, float hy, const b2Vec2& center, int id, bool sensor = false) {
    b2PolygonShape box;
    box.SetAsBox(hx, hy, center, 0.0f);
    b2FixtureDef def;
    def.shape = &box;
    def.density = sensor ? 0.0f : 1.0f;
    def.isSensor = sensor;
    def.userData.pointer = static_cast<uintptr_t>(id);
    return body->CreateFixture(&def);
}

b2Body* MakeStatic(b2World& world, float x, float y, float hx, float hy, int id) {
    b2BodyDef def;
    def.position.Set(x, y);
    b2Body* body = world.CreateBody(&def);
    AddBox(body, hx, hy, b2Vec2_zero, id);
    return body;
}

// --- A platformer: foot sensor, one-way shelves, coins, a moving lift ---

enum PlatformerId { solidId = 1, shelfId, coinId, footId, heroId, liftId };

class PlatformerRules : public b2ContactListener {
public:
    void BeginContact(b2Contact* contact) override { Count(contact, 1); }
    void EndContact(b2Contact* contact) override { Count(contact, -1); }
    void PreSolve(b2Contact* contact, const b2Manifold*) override {
        b2Fixture* shelf = contact->GetFixtureA();
        b2Fixture* other = contact->GetFixtureB();
        if (IdOf(other) == shelfId) std::swap(shelf, other);
        if (IdOf(shelf) != shelfId) return;
        const float bottom = other->GetBody()->GetPosition().y - 0.5f;
        const float top = shelf->GetBody()->GetPosition().y + 0.1f;
        if (bottom < top - 0.05f) contact->SetEnabled(false);
    }

    int ground = 0;
    std::set<b2Body*> coins;

private:
    void Count(b2Contact* contact, int change) {
        const b2Fixture* a = contact->GetFixtureA();
        const b2Fixture* b = contact->GetFixtureB();
        if (IdOf(b) == footId || IdOf(b) == coinId) std::swap(a, b);
        if (IdOf(a) == footId && !b->IsSensor() && IdOf(b) != heroId) ground += change;
        if (IdOf(a) == coinId && IdOf(b) == heroId && change > 0) coins.insert(const_cast<b2Body*>(a->GetBody()));
    }
};

}  // namespace

void Platformer() {
    b2World world(b2Vec2(0.0f, -20.0f));
    PlatformerRules rules;
    world.SetContactListener(&rules);
    MakeStatic(world, 0.0f, -0.5f, 20.0f, 0.5f, solidId);
    MakeStatic(world, 12.0f, 2.0f, 0.5f, 2.0f, solidId);
    for (int i = 0; i < 3; ++i) MakeStatic(world, 3.0f, 1.6f + 1.6f * static_cast<float>(i), 1.5f, 0.1f, shelfId);
    for (int i = 0; i < 4; ++i) {
        b2BodyDef def;
        def.position.Set(1.5f + static_cast<float>(i), i < 2 ? 0.7f : 2.4f);
        AddBox(world.CreateBody(&def), 0.2f, 0.2f, b2Vec2_zero, coinId, true);
    }
    b2BodyDef liftDef;
    liftDef.type = b2_kinematicBody;
    liftDef.position.Set(8.0f, 0.2f);
    b2Body* lift = world.CreateBody(&liftDef);
    AddBox(lift, 1.0f, 0.2f, b2Vec2_zero, liftId);
    lift->SetLinearVelocity(b2Vec2(0.0f, 1.0f));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 0.6f);
    def.fixedRotation = true;
    b2Body* hero = world.CreateBody(&def);
    AddBox(hero, 0.3f, 0.5f, b2Vec2_zero, heroId)->SetFriction(0.0f);
    AddBox(hero, 0.2f, 0.1f, b2Vec2(0.0f, -0.5f), footId, true);
    int collected = 0;
    int jumps = 0;
    for (int step = 0; step < 600; ++step) {
        const float wanted = step < 60 || step >= 240 ? 3.0f : 0.0f;
        const b2Vec2 v = hero->GetLinearVelocity();
        hero->ApplyLinearImpulseToCenter(b2Vec2(hero->GetMass() * (wanted - v.x), 0.0f), true);
        if (step >= 70 && step < 240 && rules.ground > 0 && v.y < 0.1f && step % 50 == 20) {
            hero->ApplyLinearImpulseToCenter(b2Vec2(0.0f, 9.0f * hero->GetMass()), true);
            ++jumps;
        }
        if (lift->GetPosition().y > 3.0f) lift->SetLinearVelocity(b2Vec2(0.0f, -1.0f));
        world.Step(1.0f / 60.0f, 8, 3);
        collected += static_cast<int>(rules.coins.size());
        for (b2Body* coin : rules.coins) world.DestroyBody(coin);
        rules.coins.clear();
        if (step % 60 == 59) {
            Number("hero", hero->GetPosition());
            Say("step %d ground %d coins %d", step, rules.ground, collected);
        }
    }
    Say("jumps %d", jumps);
    Number("lift", lift->GetPosition());
}

namespace {

// --- Breakable crates: PostSolve notes what broke, the step's end breaks it ---

class Breaker : public b2ContactListener {
public:
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        float strongest = 0.0f;
        for (int i = 0; i < impulse->count; ++i) strongest = b2Max(strongest, impulse->normalImpulses[i]);
        if (strongest < 12.0f) return;
        for (b2Fixture* fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) {
            if (IdOf(fixture) > 100 && std::find(broken.begin(), broken.end(), fixture->GetBody()) == broken.end())
                broken.push_back(fixture->GetBody());
        }
    }
    void EndContact(b2Contact*) override { ++ends; }
    std::vector<b2Body*> broken;
    int ends = 0;
};

void Break(b2World& world, b2Body* crate, int step) {
    Say("crate %d breaks in step %d", IdOf(crate->GetFixtureList()), step);
    const b2Vec2 at = crate->GetPosition();
    const b2Vec2 v = crate->GetLinearVelocity();
    const b2Vec2 corners[] = {crate->GetWorldPoint(b2Vec2(-0.25f, 0.0f)), crate->GetWorldPoint(b2Vec2(0.25f, 0.0f))};
    const float angle = crate->GetAngle();
    world.DestroyBody(crate);
    for (const b2Vec2& corner : corners) {
        b2Body* shard = MakeBox(world, corner.x, corner.y, 0.2f, 0.4f);
        shard->SetTransform(corner, angle);
        shard->SetLinearVelocity(v + 0.5f * (corner - at));
    }
}

}  // namespace

void BreakableCrates() {
    b2World world(b2Vec2(0.0f, -10.0f));
    Breaker breaker;
    world.SetContactListener(&breaker);
    MakeGround(world);
    for (int i = 0; i < 5; ++i) {
        b2Body* crate =
            MakeBox(world, 4.0f * static_cast<float>(i), 2.0f + 3.0f * static_cast<float>(i), 0.5f, 0.5f, 2.0f);
        crate->GetFixtureList()->GetUserData().pointer = static_cast<uintptr_t>(101 + i);
    }
    b2Body* ball = MakeDisk(world, -8.0f, 0.5f, 0.5f, 8.0f);
    ball->SetLinearVelocity(b2Vec2(12.0f, 0.0f));
    for (int step = 0; step < 240; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        std::vector<b2Body*> broken;
        broken.swap(breaker.broken);
        for (b2Body* crate : broken) Break(world, crate, step);
        if (step == 100) Number("ball", ball->GetPosition());
    }
    Say("bodies %d", world.GetBodyCount());
}

namespace {

// --- A car seen from above: no gravity, tyres that kill sideways motion, steered by a motorised hinge ---

void DriveTyre(b2Body* tyre, float wantedSpeed, float maxForce) {
    const b2Vec2 side = tyre->GetWorldVector(b2Vec2(1.0f, 0.0f));
    b2Vec2 impulse = tyre->GetMass() * -b2Dot(side, tyre->GetLinearVelocity()) * side;
    if (impulse.Length() > 0.3f) impulse *= 0.3f / impulse.Length();
    tyre->ApplyLinearImpulse(impulse, tyre->GetWorldCenter(), true);
    tyre->ApplyAngularImpulse(0.1f * tyre->GetInertia() * -tyre->GetAngularVelocity(), true);
    const b2Vec2 ahead = tyre->GetWorldVector(b2Vec2(0.0f, 1.0f));
    const float speed = b2Dot(ahead, tyre->GetLinearVelocity());
    if (wantedSpeed != speed)
        tyre->ApplyForce((wantedSpeed > speed ? maxForce : -maxForce) * ahead, tyre->GetWorldCenter(), true);
}

}  // namespace

void TopDownCar() {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    b2Body* table = world.CreateBody(&def);
    def.type = b2_dynamicBody;
    b2Body* car = world.CreateBody(&def);
    AddBox(car, 1.0f, 2.0f, b2Vec2_zero, 1)->SetDensity(0.2f);
    car->ResetMassData();
    b2Body* tyres[4];
    b2RevoluteJoint* hinges[4];
    for (int i = 0; i < 4; ++i) {
        const b2Vec2 at(i % 2 == 0 ? -1.1f : 1.1f, i < 2 ? 1.5f : -1.5f);
        tyres[i] = MakeBox(world, at.x, at.y, 0.2f, 0.4f);
        b2RevoluteJointDef joint;
        joint.Initialize(car, tyres[i], at);
        joint.enableLimit = true;
        joint.lowerAngle = joint.upperAngle = 0.0f;
        hinges[i] = static_cast<b2RevoluteJoint*>(world.CreateJoint(&joint));
    }
    b2Body* cone = MakeDisk(world, 0.0f, 14.0f, 0.4f, 0.5f);
    b2FrictionJointDef rub;
    rub.Initialize(table, cone, cone->GetPosition());
    rub.maxForce = 2.0f;
    rub.maxTorque = 0.5f;
    world.CreateJoint(&rub);
    for (int step = 0; step < 300; ++step) {
        for (int i = 0; i < 4; ++i) DriveTyre(tyres[i], step < 240 ? 8.0f : 0.0f, i < 2 ? 3.0f : 2.0f);
        const float wanted = step < 90 ? 0.0f : 0.35f;
        const float now = hinges[0]->GetJointAngle();
        const float turn = b2Clamp(wanted - now, -0.05f, 0.05f);
        for (int i = 0; i < 2; ++i) hinges[i]->SetLimits(now + turn, now + turn);
        world.Step(1.0f / 60.0f, 8, 3);
        if (step % 60 == 59) Pose("car", car);
    }
    Number("cone", cone->GetPosition());
    Number("steered", hinges[0]->GetJointAngle());
}

namespace {

// --- Buoyancy: the part of each polygon under water, by clipping against the surface ---

struct Submerged {
    float area = 0.0f;
    b2Vec2 center = b2Vec2_zero;
};

Submerged Clip(const b2PolygonShape& polygon, const b2Transform& xf, float surface) {
    std::vector<b2Vec2> under;
    for (int i = 0; i < polygon.m_count; ++i) {
        const b2Vec2 a = b2Mul(xf, polygon.m_vertices[i]);
        const b2Vec2 b = b2Mul(xf, polygon.m_vertices[i + 1 < polygon.m_count ? i + 1 : 0]);
        if (a.y <= surface) under.push_back(a);
        if ((a.y < surface) != (b.y < surface)) under.push_back(a + ((surface - a.y) / (b.y - a.y)) * (b - a));
    }
    Submerged result;
    for (size_t i = 1; i + 1 < under.size(); ++i) {
        const float area = 0.5f * b2Cross(under[i] - under[0], under[i + 1] - under[0]);
        result.area += area;
        result.center += area * (1.0f / 3.0f) * (under[0] + under[i] + under[i + 1]);
    }
    if (result.area > 0.0f) result.center *= 1.0f / result.area;
    return result;
}

void Float(b2Fixture* fixture, float surface) {
    if (fixture->GetType() != b2Shape::e_polygon) return;
    b2Body* body = fixture->GetBody();
    const Submerged part = Clip(*static_cast<b2PolygonShape*>(fixture->GetShape()), body->GetTransform(), surface);
    if (part.area <= 0.0f) return;
    body->ApplyForce(b2Vec2(0.0f, 10.0f * 2.0f * part.area), part.center, true);
    const b2Vec2 drag = -1.5f * part.area * body->GetLinearVelocityFromWorldPoint(part.center);
    body->ApplyForce(drag, part.center, true);
    body->ApplyTorque(-0.5f * part.area * body->GetAngularVelocity(), true);
}

}  // namespace

void Buoyancy() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body* basin = world.CreateBody(&def);
    AddBox(basin, 10.0f, 0.5f, b2Vec2(0.0f, -5.5f), 1);
    b2Fixture* water = AddBox(basin, 10.0f, 2.5f, b2Vec2(0.0f, -2.5f), 2, true);
    b2Body* floats[4];
    for (int i = 0; i < 4; ++i) {
        floats[i] = MakeBox(world, -6.0f + 4.0f * static_cast<float>(i), 1.0f + 0.5f * static_cast<float>(i), 0.8f,
                            0.4f, 0.6f + 0.5f * static_cast<float>(i));
        floats[i]->SetTransform(floats[i]->GetPosition(), 0.2f * static_cast<float>(i));
    }
    int wet = 0;
    for (int step = 0; step < 420; ++step) {
        for (b2ContactEdge* edge = basin->GetContactList(); edge; edge = edge->next) {
            b2Contact* contact = edge->contact;
            if (!contact->IsTouching()) continue;
            if (contact->GetFixtureA() == water) Float(contact->GetFixtureB(), 0.0f), ++wet;
            if (contact->GetFixtureB() == water) Float(contact->GetFixtureA(), 0.0f), ++wet;
        }
        world.Step(1.0f / 60.0f, 8, 3);
        if (step % 140 == 139) {
            for (b2Body* body : floats) Pose("float", body);
        }
    }
    Say("wet %d", wet);
}

namespace {

// --- A door on a slider that opens while someone stands in its zone ---

class DoorZone : public b2ContactListener {
public:
    explicit DoorZone(b2Fixture* zone) : m_zone(zone) {}
    void BeginContact(b2Contact* contact) override { Change(contact, 1); }
    void EndContact(b2Contact* contact) override { Change(contact, -1); }
    int inside = 0;

private:
    void Change(b2Contact* contact, int change) {
        b2Fixture* other = contact->GetFixtureA() == m_zone   ? contact->GetFixtureB()
                           : contact->GetFixtureB() == m_zone ? contact->GetFixtureA()
                                                              : nullptr;
        if (other != nullptr && IdOf(other) == heroId) inside += change;
    }
    b2Fixture* m_zone;
};

}  // namespace

void SensorDoor() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Fixture* zone = AddBox(ground, 3.0f, 1.5f, b2Vec2(0.0f, 1.5f), 9, true);
    DoorZone listener(zone);
    world.SetContactListener(&listener);
    b2Body* door = MakeBox(world, 0.0f, 1.3f, 0.15f, 1.2f, 2.0f);
    b2PrismaticJointDef rail;
    rail.Initialize(ground, door, door->GetPosition(), b2Vec2(0.0f, 1.0f));
    rail.enableLimit = rail.enableMotor = true;
    rail.lowerTranslation = 0.0f;
    rail.upperTranslation = 2.6f;
    rail.maxMotorForce = 100.0f;
    auto* slider = static_cast<b2PrismaticJoint*>(world.CreateJoint(&rail));
    b2Body* walker = MakeBox(world, -8.0f, 0.5f, 0.4f, 0.5f);
    walker->SetFixedRotation(true);
    walker->GetFixtureList()->SetFriction(0.0f);
    walker->GetFixtureList()->GetUserData().pointer = heroId;
    int opened = -1;
    int closed = -1;
    for (int step = 0; step < 540; ++step) {
        slider->SetMotorSpeed(listener.inside > 0 ? 4.0f : -2.0f);
        walker->SetLinearVelocity(b2Vec2(2.0f, walker->GetLinearVelocity().y));
        world.Step(1.0f / 60.0f, 8, 3);
        if (opened < 0 && listener.inside > 0) opened = step;
        if (opened >= 0 && closed < 0 && listener.inside == 0) closed = step;
        if (step % 90 == 89) Number("door", slider->GetJointTranslation());
    }
    Say("opened %d closed %d", opened, closed);
    Number("walker", walker->GetPosition());
}

void JointBreak() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world, -200.0f);  // what falls lands after the end
    b2Body* previous = ground;
    std::vector<b2Joint*> joints;
    for (int i = 0; i < 6; ++i) {
        b2Body* link = MakeBox(world, 0.0f, 11.5f - static_cast<float>(i), 0.15f, 0.5f, 4.0f);
        b2RevoluteJointDef def;
        def.Initialize(previous, link, b2Vec2(0.0f, 12.0f - static_cast<float>(i)));
        def.userData.pointer = static_cast<uintptr_t>(i + 1);
        joints.push_back(world.CreateJoint(&def));
        previous = link;
    }
    b2Body* load = MakeDisk(world, 0.0f, 5.0f, 0.5f, 1.0f);
    b2WeldJointDef weld;
    weld.Initialize(previous, load, b2Vec2(0.0f, 5.5f));
    weld.userData.pointer = 7;
    joints.push_back(world.CreateJoint(&weld));
    for (int step = 0; step < 200; ++step) {
        if (step > 20) load->ApplyForceToCenter(b2Vec2(0.0f, -2.0f * static_cast<float>(step)), true);
        world.Step(1.0f / 60.0f, 8, 3);
        if (step == 20) {
            for (b2Joint* joint : joints) Number("holds", joint->GetReactionForce(60.0f), 0.05);
        }
        for (size_t i = 0; i < joints.size(); ++i) {
            if (joints[i]->GetReactionForce(60.0f).Length() < 260.0f) continue;
            Say("joint %d breaks in step %d", static_cast<int>(joints[i]->GetUserData().pointer), step);
            world.DestroyJoint(joints[i]);
            joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    }
    Say("joints left %d", world.GetJointCount());
    Number("top link", world.GetBodyList()->GetPosition());
}

namespace {

// --- A tool that looks at a level with rays and boxes ---

class NearestHit : public b2RayCastCallback {
public:
    float ReportFixture(b2Fixture* fixture, const b2Vec2& at, const b2Vec2& n, float fraction) override {
        if (fixture->IsSensor() || (fixture->GetFilterData().categoryBits & mask) == 0) return -1.0f;
        hit = fixture;
        point = at;
        normal = n;
        return fraction;
    }
    uint16 mask = 0xFFFF;
    b2Fixture* hit = nullptr;
    b2Vec2 point, normal;
};

class PointCollector : public b2QueryCallback {
public:
    bool ReportFixture(b2Fixture* fixture) override {
        if (fixture->TestPoint(at)) ids.insert(IdOf(fixture));
        return true;
    }
    b2Vec2 at;
    std::set<int> ids;
};

}  // namespace

void LevelTool() {
    b2World world(b2Vec2(0.0f, -10.0f));
    int id = 0;
    for (int i = 0; i < 5; ++i) {
        for (int k = 0; k < 5; ++k) {
            b2Body* body =
                MakeStatic(world, 3.0f * static_cast<float>(i), 3.0f * static_cast<float>(k), 0.5f, 0.3f, ++id);
            body->SetTransform(body->GetPosition(), 0.3f * static_cast<float>(id));
            b2Filter filter;
            filter.categoryBits = static_cast<uint16>(1 << (id % 3));
            body->GetFixtureList()->SetFilterData(filter);
            if (id % 7 == 0) body->GetFixtureList()->SetSensor(true);
        }
    }
    for (int ray = 0; ray < 24; ++ray) {
        const float angle = 2.0f * b2_pi * static_cast<float>(ray) / 24.0f;
        NearestHit nearest;
        nearest.mask = ray % 2 == 0 ? 0xFFFF : 0x0006;
        const b2Vec2 from(4.4f, 4.7f);
        world.RayCast(&nearest, from, from + 20.0f * b2Vec2(cosf(angle), sinf(angle)));
        Say("ray %d hits %d", ray, nearest.hit != nullptr ? IdOf(nearest.hit) : 0);
        if (nearest.hit == nullptr) continue;
        Number("point", nearest.point, 1e-4);
        Number("normal", nearest.normal, 1e-4);
    }
    for (int i = 0; i < 20; ++i) {
        PointCollector collector;
        collector.at.Set(0.7f * static_cast<float>(i), 0.61f * static_cast<float>(i));
        b2AABB box;
        box.lowerBound = collector.at - b2Vec2(0.001f, 0.001f);
        box.upperBound = collector.at + b2Vec2(0.001f, 0.001f);
        world.QueryAABB(&collector, box);
        Say("point %d in %d", i, collector.ids.empty() ? 0 : *collector.ids.begin());
    }
}

void TerrainDrive() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body* terrain = world.CreateBody(&def);
    std::vector<b2Vec2> line;
    for (int i = 0; i <= 60; ++i) {
        const float x = 50.0f - static_cast<float>(i);  // from right to left: solid below
        line.push_back(b2Vec2(x, 0.5f * sinf(0.6f * x) + 0.02f * x));
    }
    b2ChainShape chain;
    chain.CreateChain(line.data(), static_cast<int32>(line.size()), b2Vec2(51.0f, 1.0f), b2Vec2(-11.0f, 0.0f));
    b2FixtureDef ground;
    ground.shape = &chain;
    ground.friction = 0.9f;
    terrain->CreateFixture(&ground);
    b2Body* car = MakeBox(world, 0.0f, 2.0f, 1.2f, 0.3f);
    b2WheelJoint* drive = nullptr;
    b2Body* wheels[2];
    for (int i = 0; i < 2; ++i) {
        wheels[i] = MakeDisk(world, i == 0 ? -0.9f : 0.9f, 1.5f, 0.4f);
        wheels[i]->GetFixtureList()->SetFriction(1.2f);
        b2WheelJointDef jd;
        jd.Initialize(car, wheels[i], wheels[i]->GetPosition(), b2Vec2(0.0f, 1.0f));
        b2LinearStiffness(jd.stiffness, jd.damping, 5.0f, 0.7f, car, wheels[i]);
        jd.enableLimit = true;
        jd.lowerTranslation = -0.3f;
        jd.upperTranslation = 0.3f;
        jd.enableMotor = true;
        jd.maxMotorTorque = i == 0 ? 8.0f : 2.0f;
        jd.motorSpeed = -10.0f;
        drive = static_cast<b2WheelJoint*>(world.CreateJoint(&jd));
    }
    std::set<int> segments;
    for (int step = 0; step < 480; ++step) {
        world.Step(1.0f / 60.0f, 8, 3);
        for (b2ContactEdge* edge = wheels[1]->GetContactList(); edge; edge = edge->next) {
            if (edge->contact->IsTouching() && edge->other == terrain) segments.insert(edge->contact->GetChildIndexA());
        }
        if (step == 360) drive->EnableMotor(false);
        if (step % 60 == 59)
            Pose("car", car, 5e-3);  // the wheels leave the ground on crests: landing amplifies rounding
    }
    std::string text;
    for (const int segment : segments) text += std::to_string(segment) + " ";
    Say("wheel touched %s", text.c_str());
}
