// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The laboratory over Box2D 2.4.1.

#include <box2d/box2d.h>

#include "testbed/engines/box2d_joint.h"
#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/capture_box2d.h"
#include "testbed/engines/lab_world.h"

namespace testbed {
namespace {

struct Box2dNames {
    using World = b2World;
    using Body = b2Body;
    using Joint = b2Joint;
    using WorldManifold = b2WorldManifold;
    using Contact = b2Contact;
    using ContactListener = b2ContactListener;

    static Point ToPoint(b2Vec2 v) { return {double{v.x}, double{v.y}}; }
    static b2Vec2 ToVec(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

    static std::unique_ptr<World> MakeWorld(const RunSpec& spec) {
        auto world = std::make_unique<World>(ToB2(*spec.gravity));
        world->SetAllowSleeping(spec.sleeping);
        world->SetWarmStarting(spec.warmStarting);
        world->SetContinuousPhysics(spec.continuous);
        return world;
    }

    static b2BodyDef MakeBodyDef(const scenes::Body& body, Point at) {
        b2BodyDef def;
        def.type = body.type == scenes::BodyType::dynamic     ? b2_dynamicBody
                   : body.type == scenes::BodyType::kinematic ? b2_kinematicBody
                                                              : b2_staticBody;
        def.position = ToVec(at);
        def.linearVelocity = ToB2(body.linearVelocity);
        FillBodyDef(def, body);
        return def;
    }

    static BodyState Capture(const Body& body, int index) { return CaptureBody(body, index); }
    static Point GetOrigin(const Body& body) { return ToPoint(body.GetPosition()); }
    static Point GetCentre(const Body& body) { return ToPoint(body.GetWorldCenter()); }

    static void AddFixture(Body& body, const scenes::Scene& scene, int index, float restitutionThreshold) {
        const scenes::Fixture& fixture = scene.fixtures[static_cast<size_t>(index)];
        b2FixtureDef def;
        FillMaterial(def, fixture, restitutionThreshold);
        if (fixture.shape.type == scenes::ShapeType::chain) {
            b2ChainShape chain;
            MakeBox2dChain(scene, fixture.shape, chain);
            def.shape = &chain;
            body.CreateFixture(&def);
            return;
        }
        const Box2dShape shape = MakeBox2dShape(Box2dShapeOf(scene, fixture.shape));
        def.shape = &AsB2Shape(shape);
        body.CreateFixture(&def);
    }

    static Joint* MakeJoint(World& world, const scenes::Joint& joint, const Box2dBodies& bodies,
                            const Box2dJoints& joints) {
        return CreateBox2dJoint(world, joint, bodies, joints);
    }

    static StepFacts Step(World& world, const RunSpec& spec, float dt) {
        const Iterations iterations = *std::get<SequentialImpulses>(spec.solver).iterations;
        world.Step(dt, iterations.velocity, iterations.position);
        return {};
    }

    static double CastRay(const World& world, b2Vec2 from, b2Vec2 to) {
        struct Nearest final : b2RayCastCallback {
            float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float part) override {
                return fraction = part;
            }
            float fraction = 1.0f;
        } nearest;
        world.RayCast(&nearest, from, to);
        return double{nearest.fraction};
    }
    static int CountInBox(const World& world, b2Vec2 low, b2Vec2 high) {
        struct Count final : b2QueryCallback {
            bool ReportFixture(b2Fixture*) override { return ++number > 0; }
            int number = 0;
        } count;
        b2AABB box;
        box.lowerBound = low;
        box.upperBound = high;
        world.QueryAABB(&count, box);
        return count.number;
    }

    static double GetSkins(const b2Contact&, const RunSpec&) { return 0.0; }  // it has no soft step
    static double GetStepImpulse(b2Contact& contact, int point) {
        return double{contact.GetManifold()->points[point].normalImpulse};
    }
};

}  // namespace

std::unique_ptr<LabWorld> MakeBox2dLab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs) {
    return std::make_unique<LabWorldOf<Box2dNames>>(scene, spec, needs);
}

}  // namespace testbed
