// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One story told in the length unit of b2_user_settings.h, printed in metres. It has a pile that falls asleep, a joint
// of every kind, a bullet and a thin wall, a chain, and the free functions. With every length times the unit, all that
// is printed must be the same.

#include <box2d/box2d.h>

#include <cstdio>
#include <initializer_list>
#include <string>

namespace {

constexpr float unit = b2_lengthUnitsPerMeter;

b2Vec2 At(float x, float y) { return {unit * x, unit * y}; }

void Number(const std::string& name, float value, float tolerance) {
    std::printf("~ %s %.9g %g\n", name.c_str(), double{value}, double{tolerance});
}

void Pose(const std::string& name, const b2Body* body) {
    Number(name + ".x", body->GetPosition().x / unit, 1e-3f);
    Number(name + ".y", body->GetPosition().y / unit, 1e-3f);
    Number(name + ".angle", body->GetAngle(), 1e-3f);
    std::printf("%s %s\n", name.c_str(), body->IsAwake() ? "awake" : "asleep");
}

b2Body* Make(b2World& world, b2BodyType type, const b2Vec2& at, const b2Shape& shape) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    b2Body* body = world.CreateBody(&def);
    body->CreateFixture(&shape, 1.0f / (unit * unit));
    return body;
}

b2PolygonShape Box(float hx, float hy) {
    b2PolygonShape box;
    box.SetAsBox(unit * hx, unit * hy);
    return box;
}

b2CircleShape Disk(float radius) {
    b2CircleShape disk;
    disk.m_radius = unit * radius;
    return disk;
}

b2World MakeWorld() { return b2World(At(0.0f, -10.0f)); }

b2Body* MakeGround(b2World& world) {
    b2ChainShape chain;
    const b2Vec2 ends[3] = {At(40.0f, 0.0f), At(0.0f, 0.0f), At(-40.0f, 0.0f)};
    chain.CreateChain(ends, 3, At(41.0f, 0.0f), At(-41.0f, 0.0f));
    return Make(world, b2_staticBody, At(0.0f, 0.0f), chain);
}

void Run(b2World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.Step(1.0f / 60.0f, 8, 3);
}

void TellPile() {
    b2World world = MakeWorld();
    MakeGround(world);
    b2Body* boxes[5];
    b2Body* disks[3];
    for (int i = 0; i < 5; ++i) {
        boxes[i] = Make(world, b2_dynamicBody, At(3.0f, 0.6f + 1.1f * static_cast<float>(i)), Box(0.5f, 0.5f));
    }
    for (int i = 0; i < 3; ++i) {
        disks[i] = Make(world, b2_dynamicBody, At(-3.0f * static_cast<float>(i), 2.0f), Disk(0.25f));
    }
    Run(world, 240);
    for (int i = 0; i < 5; ++i) Pose("box" + std::to_string(i), boxes[i]);
    for (int i = 0; i < 3; ++i) Pose("disk" + std::to_string(i), disks[i]);
}

/// Two bodies a metre apart, the first of them static.
void TellJoint(const char* name, void (*connect)(b2World& world, b2Body* a, b2Body* b)) {
    b2World world = MakeWorld();
    b2Body* a = Make(world, b2_staticBody, At(0.0f, 5.0f), Box(0.2f, 0.2f));
    b2Body* b = Make(world, b2_dynamicBody, At(1.0f, 5.0f), Box(0.3f, 0.2f));
    connect(world, a, b);
    for (int i = 0; i < 4; ++i) {
        Run(world, 30);
        Pose(std::string(name) + std::to_string(i), b);
    }
}

void TellJoints() {
    TellJoint("revolute", [](b2World& world, b2Body* a, b2Body* b) {
        b2RevoluteJointDef def;
        def.Initialize(a, b, At(0.0f, 5.0f));
        def.enableLimit = true;
        def.lowerAngle = -1.0f;
        def.upperAngle = 0.5f;
        world.CreateJoint(&def);
    });
    TellJoint("prismatic", [](b2World& world, b2Body* a, b2Body* b) {
        b2PrismaticJointDef def;
        def.Initialize(a, b, At(1.0f, 5.0f), b2Vec2(0.6f, 0.8f));
        def.enableLimit = true;
        def.lowerTranslation = -unit * 0.75f;
        def.upperTranslation = unit * 2.0f;
        world.CreateJoint(&def);
    });
    TellJoint("rod", [](b2World& world, b2Body* a, b2Body* b) {
        b2DistanceJointDef def;
        def.Initialize(a, b, At(0.0f, 5.0f), At(1.0f, 5.0f));
        world.CreateJoint(&def);
    });
    TellJoint("wheel", [](b2World& world, b2Body* a, b2Body* b) {
        b2WheelJointDef def;
        def.Initialize(a, b, At(1.0f, 5.0f), b2Vec2(0.0f, 1.0f));
        b2LinearStiffness(def.stiffness, def.damping, 2.0f, 0.7f, a, b);
        def.enableLimit = true;
        def.lowerTranslation = -unit * 0.05f;
        def.upperTranslation = unit * 0.05f;
        world.CreateJoint(&def);
    });
    TellJoint("pulley", [](b2World& world, b2Body*, b2Body* b) {
        b2Body* other = Make(world, b2_dynamicBody, At(3.0f, 5.0f), Box(0.3f, 0.3f));
        b2PulleyJointDef def;
        def.Initialize(b, other, At(1.0f, 8.0f), At(3.0f, 8.0f), At(1.0f, 5.0f), At(3.0f, 5.0f), 1.0f);
        world.CreateJoint(&def);
    });
    TellJoint("weld", [](b2World& world, b2Body* a, b2Body* b) {
        b2WeldJointDef def;
        def.Initialize(a, b, At(0.5f, 5.0f));
        world.CreateJoint(&def);
    });
}

/// A rod between two points in one place is as short as rods are.
void TellShortestRod() {
    b2World world = MakeWorld();
    b2DistanceJointDef def;
    def.Initialize(MakeGround(world), Make(world, b2_dynamicBody, At(1.0f, 5.0f), Disk(0.5f)), At(1.0f, 5.0f),
                   At(1.0f, 5.0f));
    Number("shortest rod", static_cast<b2DistanceJoint*>(world.CreateJoint(&def))->GetLength() / unit, 1e-6f);
}

void TellBullet() {
    b2World world = MakeWorld();
    Make(world, b2_staticBody, At(4.0f, 3.0f), Box(0.01f, 3.0f));
    b2Body* ball = Make(world, b2_dynamicBody, At(0.0f, 3.0f), Disk(0.1f));
    ball->SetBullet(true);
    ball->SetLinearVelocity(At(110.0f, 0.0f));
    for (int i = 0; i < 5; ++i) {
        Run(world, 1);
        Pose("ball" + std::to_string(i), ball);
    }
}

void TellFunctions() {
    const b2PolygonShape box = Box(1.0f, 0.5f);
    b2ShapeCastInput cast;
    cast.proxyA.Set(&box, 0);
    cast.proxyB.Set(&box, 0);
    cast.transformA.SetIdentity();
    cast.transformB.Set(At(8.0f, 0.25f), 0.3f);
    cast.translationB = At(-9.0f, 0.0f);
    b2ShapeCastOutput hit{};
    std::printf("cast %d\n", b2ShapeCast(&hit, &cast));
    Number("cast.lambda", hit.lambda, 1e-6f);
    Number("cast.x", hit.point.x / unit, 1e-5f);

    b2TOIInput toi;
    toi.proxyA = cast.proxyA;
    toi.proxyB = cast.proxyB;
    toi.sweepA = {};
    toi.sweepA.localCenter = toi.sweepA.c0 = toi.sweepA.c = At(0.0f, 0.0f);
    toi.sweepA.a0 = toi.sweepA.a = toi.sweepA.alpha0 = 0.0f;
    toi.sweepB = toi.sweepA;
    toi.sweepB.c0 = At(8.0f, 0.0f);
    toi.sweepB.c = At(0.0f, 0.0f);
    toi.tMax = 1.0f;
    b2TOIOutput impact{};
    b2TimeOfImpact(&impact, &toi);
    Number("impact", impact.t, 1e-6f);

    const b2Vec2 corners[6] = {At(0, 0), At(1, 0), At(1.001f, 0.001f), At(1, 1), At(0.001f, 1), At(0, 1)};
    b2PolygonShape hull;
    hull.Set(corners, 6);  // two corners are as good as others
    std::printf("hull %d\n", hull.m_count);
    Number("skin", hull.m_radius / unit, 1e-7f);

    b2DynamicTree tree;
    const int32 proxy = tree.CreateProxy(b2AABB{At(0, 0), At(1, 1)}, nullptr);
    Number("margin", -tree.GetFatAABB(proxy).lowerBound.x / unit, 1e-6f);
}

}  // namespace

int main() {
    TellPile();
    TellJoints();
    TellShortestRod();
    TellBullet();
    TellFunctions();
    return 0;
}
