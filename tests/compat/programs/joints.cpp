// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Programs about joints: each kind in a scene as the testbed of Box2D has it.

#include <string>

#include "program.h"

void Revolute() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* pendulum = MakeBox(world, 2.0f, 10.0f, 2.0f, 0.2f, 5.0f);
    b2RevoluteJointDef def;
    def.Initialize(ground, pendulum, b2Vec2(0.0f, 10.0f));
    auto* hinge = static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
    b2Body* wheel = MakeDisk(world, 20.0f, 10.0f, 1.0f);
    def.Initialize(ground, wheel, b2Vec2(20.0f, 10.0f));
    def.enableMotor = true;
    def.motorSpeed = 8.0f * b2_pi;
    def.maxMotorTorque = 100.0f;
    auto* motor = static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
    b2Body* flap = MakeBox(world, -10.0f, 10.0f, 1.0f, 0.1f);
    def.Initialize(ground, flap, b2Vec2(-11.0f, 10.0f));
    def.enableMotor = false;
    def.enableLimit = true;
    def.lowerAngle = -0.25f * b2_pi;
    def.upperAngle = 0.5f * b2_pi;
    auto* limited = static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
    for (int i = 0; i < 4; ++i) {
        Run(world, 15);
        Number("angle", hinge->GetJointAngle(), 2e-3);
        Number("speed", hinge->GetJointSpeed(), 5e-3);
        Number("force", hinge->GetReactionForce(60.0f), 0.01);
    }
    Run(world, 120);
    Number("turns", motor->GetJointAngle(), 5e-2);
    Number("motor speed", motor->GetJointSpeed(), 1e-3);
    Number("limit", limited->GetJointAngle(), 2e-3);
    Number("torque", limited->GetReactionTorque(60.0f), 0.01);
    motor->EnableMotor(false);
    limited->EnableLimit(false);
    limited->SetLimits(-1.0f, 1.0f);
    Say("%d %d %d", motor->IsMotorEnabled(), limited->IsLimitEnabled(), hinge->GetType());
    Number("lower", limited->GetLowerLimit());
    Number("anchor", limited->GetAnchorA());
    Number("local", limited->GetLocalAnchorB());
    Number("ref", limited->GetReferenceAngle());
    Run(world, 20);
    Number("falls", limited->GetJointAngle(), 5e-2);
}

void Prismatic() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* box = MakeBox(world, -5.0f, 10.0f, 0.5f, 2.0f, 5.0f);
    b2PrismaticJointDef def;
    b2Vec2 axis(1.0f, 0.5f);
    axis.Normalize();
    def.Initialize(ground, box, b2Vec2(-5.0f, 10.0f), axis);
    def.motorSpeed = 3.0f;
    def.maxMotorForce = 10000.0f;
    def.enableMotor = true;
    def.lowerTranslation = -2.0f;
    def.upperTranslation = 4.0f;
    def.enableLimit = true;
    auto* slider = static_cast<b2PrismaticJoint*>(world.CreateJoint(&def));
    for (int i = 0; i < 4; ++i) {
        Run(world, 30);
        Number("translation", slider->GetJointTranslation(), 2e-3);
        Number("speed", slider->GetJointSpeed(), 5e-3);
    }
    Number("force", slider->GetMotorForce(60.0f), 0.01);
    slider->SetMotorSpeed(-1.0f);
    Run(world, 60);
    Number("back", slider->GetJointTranslation(), 3e-3);
    Number("axis", slider->GetLocalAxisA(), 1e-6);
    Pose("box", box, 3e-3);
}

void Distance() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* bob = MakeBox(world, 3.0f, 8.0f, 0.3f, 0.3f, 2.0f);
    b2DistanceJointDef def;
    def.Initialize(ground, bob, b2Vec2(0.0f, 12.0f), b2Vec2(3.0f, 8.0f));
    auto* rod = static_cast<b2DistanceJoint*>(world.CreateJoint(&def));
    b2Body* spring = MakeBox(world, 10.0f, 8.0f, 0.3f, 0.3f, 2.0f);
    def.Initialize(ground, spring, b2Vec2(10.0f, 12.0f), b2Vec2(10.0f, 8.0f));
    def.minLength = 1.0f;
    def.maxLength = 6.0f;
    b2LinearStiffness(def.stiffness, def.damping, 1.0f, 0.3f, ground, spring);
    auto* soft = static_cast<b2DistanceJoint*>(world.CreateJoint(&def));
    Number("k", soft->GetStiffness(), 1e-3);
    Number("c", soft->GetDamping(), 1e-3);
    b2Body* roped = MakeBox(world, -10.0f, 11.0f, 0.3f, 0.3f, 2.0f);
    def.Initialize(ground, roped, b2Vec2(-10.0f, 12.0f), b2Vec2(-10.0f, 11.0f));
    def.stiffness = 0.0f;
    def.damping = 0.0f;
    def.minLength = 0.0f;
    def.maxLength = 4.0f;
    auto* rope = static_cast<b2DistanceJoint*>(world.CreateJoint(&def));
    for (int i = 0; i < 4; ++i) {
        Run(world, 30);
        Number("rod", rod->GetCurrentLength());
        Number("spring", soft->GetCurrentLength(), 2e-3);
        Number("rope", rope->GetCurrentLength(), 5e-3);
        Pose("bob", bob, 5e-3);
    }
    Run(world, 300);
    Number("hangs", soft->GetCurrentLength(), 2e-3);
    Number("holds", soft->GetReactionForce(60.0f), 0.01);
    Number("set", soft->SetLength(2.0f));
    Number("set", soft->SetMinLength(7.0f));
    Number("set", soft->SetMaxLength(0.5f));
}

void Pulley() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world, -20.0f);
    b2Body* left = MakeBox(world, -10.0f, 4.0f, 1.0f, 2.0f, 5.0f);
    b2Body* right = MakeBox(world, 10.0f, 4.0f, 1.0f, 2.0f, 4.0f);
    b2PulleyJointDef def;
    def.Initialize(left, right, b2Vec2(-10.0f, 16.0f), b2Vec2(10.0f, 16.0f), b2Vec2(-10.0f, 6.0f), b2Vec2(10.0f, 6.0f),
                   1.5f);
    auto* pulley = static_cast<b2PulleyJoint*>(world.CreateJoint(&def));
    Number("a", pulley->GetLengthA());
    Number("b", pulley->GetLengthB());
    Run(world, 60);
    Number("sum", pulley->GetCurrentLengthA() + pulley->GetRatio() * pulley->GetCurrentLengthB(), 5e-3);
    Pose("left", left, 3e-3);
    Pose("right", right, 3e-3);
    Number("ground", pulley->GetGroundAnchorA());
    Say("collide %d", pulley->GetCollideConnected());
}

void Gears() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world, -20.0f);
    b2Body* small = MakeDisk(world, -3.0f, 12.0f, 1.0f, 5.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(ground, small, small->GetPosition());
    b2Joint* joint1 = world.CreateJoint(&hinge);
    b2Body* large = MakeDisk(world, 0.0f, 12.0f, 2.0f, 5.0f);
    hinge.Initialize(ground, large, large->GetPosition());
    b2Joint* joint2 = world.CreateJoint(&hinge);
    b2Body* bar = MakeBox(world, 2.5f, 12.0f, 0.5f, 5.0f, 1.0f);
    b2PrismaticJointDef slider;
    slider.Initialize(ground, bar, bar->GetPosition(), b2Vec2(0.0f, 1.0f));
    slider.lowerTranslation = -5.0f;
    slider.upperTranslation = 5.0f;
    slider.enableLimit = true;
    b2Joint* joint3 = world.CreateJoint(&slider);
    b2GearJointDef def;
    def.bodyA = small;
    def.bodyB = large;
    def.joint1 = joint1;
    def.joint2 = joint2;
    def.ratio = 2.0f;
    auto* gear = static_cast<b2GearJoint*>(world.CreateJoint(&def));
    def.bodyA = large;
    def.bodyB = bar;
    def.joint1 = joint2;
    def.joint2 = joint3;
    def.ratio = -1.0f / 2.0f;
    auto* rack = static_cast<b2GearJoint*>(world.CreateJoint(&def));
    Say("bodies %d %d, joints %d %d", gear->GetBodyA() == small, gear->GetBodyB() == large, gear->GetJoint1() == joint1,
        rack->GetJoint2() == joint3);
    Run(world, 45);
    Number("small", static_cast<b2RevoluteJoint*>(joint1)->GetJointAngle(), 5e-3);
    Number("large", static_cast<b2RevoluteJoint*>(joint2)->GetJointAngle(), 5e-3);
    Number("bar", static_cast<b2PrismaticJoint*>(joint3)->GetJointTranslation(), 5e-3);
    Number("ratio", gear->GetRatio());
    rack->SetRatio(-1.0f);
    Number("ratio", rack->GetRatio());
    world.DestroyJoint(rack);
    world.DestroyJoint(gear);
    world.DestroyJoint(joint1);
    Say("left %d", world.GetJointCount());
}

void Mouse() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* box = MakeBox(world, 0.0f, 5.0f, 0.5f, 0.5f, 1.0f);
    b2MouseJointDef def;
    def.bodyA = ground;
    def.bodyB = box;
    def.target = b2Vec2(0.3f, 5.3f);
    def.maxForce = 1000.0f * box->GetMass();
    b2LinearStiffness(def.stiffness, def.damping, 5.0f, 0.7f, ground, box);
    auto* mouse = static_cast<b2MouseJoint*>(world.CreateJoint(&def));
    mouse->SetTarget(b2Vec2(3.0f, 7.0f));
    for (int i = 0; i < 3; ++i) {
        Run(world, 20);
        Pose("dragged", box, 5e-3);
    }
    Run(world, 200);
    Number("held", mouse->GetAnchorB(), 2e-3);
    Number("target", mouse->GetTarget());
    Number("max", mouse->GetMaxForce(), 1e-2);
    world.ShiftOrigin(b2Vec2(10.0f, 0.0f));
    Number("shifted", mouse->GetTarget());
    world.DestroyJoint(mouse);
    Run(world, 60);
    Say("falls %d", box->GetPosition().y < 6.0f);
}

void Car() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef groundDef;
    b2Body* ground = world.CreateBody(&groundDef);
    b2FixtureDef fd;
    b2EdgeShape edge;
    fd.shape = &edge;
    fd.friction = 0.6f;
    edge.SetTwoSided(b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    ground->CreateFixture(&fd);
    const float heights[] = {0.25f, 1.0f, 1.0f, 0.0f, 0.0f};
    float x = 20.0f;
    float y = 0.0f;
    for (const float next : heights) {
        edge.SetTwoSided(b2Vec2(x, y), b2Vec2(x + 5.0f, next));
        ground->CreateFixture(&fd);
        x += 5.0f;
        y = next;
    }
    const b2Vec2 outline[] = {b2Vec2(-1.5f, -0.5f), b2Vec2(1.5f, -0.5f),  b2Vec2(1.5f, 0.0f),
                              b2Vec2(0.0f, 0.9f),   b2Vec2(-1.15f, 0.9f), b2Vec2(-1.5f, 0.2f)};
    b2PolygonShape chassis;
    chassis.Set(outline, 6);
    b2BodyDef bd;
    bd.type = b2_dynamicBody;
    bd.position.Set(0.0f, 1.0f);
    b2Body* car = world.CreateBody(&bd);
    car->CreateFixture(&chassis, 1.0f);
    b2CircleShape circle;
    circle.m_radius = 0.4f;
    b2Body* wheels[2];
    b2WheelJoint* springs[2];
    for (int i = 0; i < 2; ++i) {
        fd.shape = &circle;
        fd.density = 1.0f;
        fd.friction = 0.9f;
        bd.position.Set(i == 0 ? -1.0f : 1.0f, i == 0 ? 0.35f : 0.4f);
        wheels[i] = world.CreateBody(&bd);
        wheels[i]->CreateFixture(&fd);
        b2WheelJointDef jd;
        jd.Initialize(car, wheels[i], wheels[i]->GetPosition(), b2Vec2(0.0f, 1.0f));
        jd.motorSpeed = 0.0f;
        jd.maxMotorTorque = i == 0 ? 20.0f : 10.0f;
        jd.enableMotor = i == 0;
        b2LinearStiffness(jd.stiffness, jd.damping, 4.0f, 0.7f, car, wheels[i]);
        jd.lowerTranslation = -0.25f;
        jd.upperTranslation = 0.25f;
        jd.enableLimit = true;
        springs[i] = static_cast<b2WheelJoint*>(world.CreateJoint(&jd));
    }
    Run(world, 120);
    Number("parked", car->GetPosition());
    Number("spring", springs[0]->GetJointTranslation());
    springs[0]->SetMotorSpeed(-20.0f);
    Run(world, 120);
    Number("driven", car->GetPosition());
    Number("wheel speed", springs[0]->GetJointAngularSpeed(), 0.01);
    Number("torque", springs[0]->GetMotorTorque(60.0f), 0.01);
    Run(world, 120);
    Number("uphill", car->GetPosition().x);
    Say("%d %d", springs[1]->IsMotorEnabled(), springs[0]->IsLimitEnabled());
    Number("axis", springs[0]->GetLocalAxisA());
    Number("stiffness", springs[0]->GetStiffness(), 1e-2);
}

void Weld() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world);
    b2Body* previous = ground;
    b2Body* soft = ground;
    for (int i = 0; i < 4; ++i) {
        const float x = 0.5f + static_cast<float>(i);
        b2Body* part = MakeBox(world, x, 10.0f, 0.5f, 0.125f, 20.0f);
        b2WeldJointDef def;
        def.Initialize(previous, part, b2Vec2(x - 0.5f, 10.0f));
        world.CreateJoint(&def);
        previous = part;
        b2Body* springy = MakeBox(world, x + 20.0f, 10.0f, 0.5f, 0.125f, 5.0f);
        def.Initialize(soft, springy, b2Vec2(x + 19.5f, 10.0f));
        b2AngularStiffness(def.stiffness, def.damping, 8.0f, 0.7f, soft, springy);
        world.CreateJoint(&def);
        soft = springy;
    }
    auto* last = static_cast<b2WeldJoint*>(world.GetJointList());
    Number("stiffness", last->GetStiffness(), 1e-2);
    Run(world, 60);
    Pose("stiff end", previous);
    Run(world, 400);
    Pose("soft end", soft);
    Number("reference", last->GetReferenceAngle());
}

void FrictionAndMotor() {
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body* ground = MakeGround(world, -50.0f);
    b2Body* crate = MakeBox(world, 0.0f, 0.0f, 0.5f, 0.5f, 1.0f);
    b2FrictionJointDef friction;
    friction.Initialize(ground, crate, crate->GetPosition());
    friction.maxForce = crate->GetMass() * 4.0f;
    friction.maxTorque = 0.5f;
    auto* brake = static_cast<b2FrictionJoint*>(world.CreateJoint(&friction));
    crate->SetLinearVelocity(b2Vec2(6.0f, 2.0f));
    crate->SetAngularVelocity(3.0f);
    b2Body* driven = MakeBox(world, 0.0f, 10.0f, 1.0f, 0.5f, 2.0f);
    b2MotorJointDef motor;
    motor.Initialize(ground, driven);
    motor.maxForce = 1000.0f;
    motor.maxTorque = 1000.0f;
    auto* drive = static_cast<b2MotorJoint*>(world.CreateJoint(&motor));
    for (int i = 1; i <= 60; ++i) {
        const float t = static_cast<float>(i) / 60.0f;
        drive->SetLinearOffset(b2Vec2(6.0f * sinf(2.0f * t), 60.0f + 4.0f * sinf(t)));
        drive->SetAngularOffset(4.0f * t);
        Run(world, 1);
    }
    Pose("crate", crate, 2e-3);
    Pose("driven", driven, 5e-3);
    Number("offset", drive->GetLinearOffset(), 1e-5);
    Number("angle", drive->GetAngularOffset(), 1e-5);
    Number("factor", drive->GetCorrectionFactor());
    Number("force", brake->GetReactionForce(60.0f), 0.01);
    Run(world, 120);
    Pose("stopped", crate, 2e-3);
    Number("still", crate->GetLinearVelocity());
}

void Ragdoll() {
    b2World world(b2Vec2(0.0f, -10.0f));
    MakeGround(world);
    b2Body* torso = MakeBox(world, 0.0f, 4.0f, 0.3f, 0.6f);
    b2Body* limbs[5];
    const b2Vec2 places[] = {b2Vec2(0.0f, 4.9f), b2Vec2(-0.6f, 4.4f), b2Vec2(0.6f, 4.4f), b2Vec2(-0.2f, 2.9f),
                             b2Vec2(0.2f, 2.9f)};
    const b2Vec2 anchors[] = {b2Vec2(0.0f, 4.6f), b2Vec2(-0.3f, 4.4f), b2Vec2(0.3f, 4.4f), b2Vec2(-0.2f, 3.4f),
                              b2Vec2(0.2f, 3.4f)};
    for (int i = 0; i < 5; ++i) {
        limbs[i] = i == 0 ? MakeDisk(world, places[i].x, places[i].y, 0.25f)
                          : MakeBox(world, places[i].x, places[i].y, i < 3 ? 0.3f : 0.15f, i < 3 ? 0.12f : 0.5f);
        b2RevoluteJointDef def;
        def.Initialize(torso, limbs[i], anchors[i]);
        def.lowerAngle = -0.4f;
        def.upperAngle = 0.6f;
        def.enableLimit = true;
        world.CreateJoint(&def);
    }
    Run(world, 30);
    Number("falling", torso->GetPosition());
    Run(world, 570);
    bool inside = true;
    for (b2Joint* joint = world.GetJointList(); joint; joint = joint->GetNext()) {
        const float angle = static_cast<b2RevoluteJoint*>(joint)->GetJointAngle();
        inside = inside && angle > -0.45f && angle < 0.65f;
    }
    Say("limits held: %d, on the ground: %d", inside, torso->GetPosition().y < 1.5f && torso->GetPosition().y > 0.0f);
}

void Bridge() {
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* ground = MakeGround(world, -10.0f);
    b2Body* previous = ground;
    b2Body* middle = nullptr;
    b2RevoluteJointDef def;
    for (int i = 0; i < 20; ++i) {
        const float x = -9.5f + static_cast<float>(i);
        b2Body* plank = MakeBox(world, x, 5.0f, 0.5f, 0.125f, 20.0f);
        plank->GetFixtureList()->SetFriction(0.2f);
        def.Initialize(previous, plank, b2Vec2(x - 0.5f, 5.0f));
        world.CreateJoint(&def);
        if (i == 10) middle = plank;
        previous = plank;
    }
    def.Initialize(previous, ground, b2Vec2(10.0f, 5.0f));
    world.CreateJoint(&def);
    Run(world, 30);
    Number("sags", middle->GetPosition().y);
    Run(world, 600);
    Number("hangs", middle->GetPosition().y);
    int joints = 0;
    for (b2JointEdge* edge = middle->GetJointList(); edge; edge = edge->next) ++joints;
    Say("joints of a plank: %d", joints);
}
