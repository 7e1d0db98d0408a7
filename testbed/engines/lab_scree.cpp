// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The laboratory over our engine.

#include <algorithm>

#include "scree/contact.h"
#include "scree/far_position.h"
#include "scree/inspect.h"
#include "scree/world.h"
#include "testbed/engines/capture_scree.h"
#include "testbed/engines/lab_world.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/scree_step.h"

namespace testbed {
namespace {

/// A refused call means a scene that cannot be loaded as described: nothing to go on with.
void ThrowError(const scree::Error& error, void*) {
    throw std::invalid_argument(std::string(error.function) + ": " + error.field + ": " + scree::GetName(error.code) +
                                "; " + error.cure);
}

struct ScreeNames {
    using World = scree::World;
    using Body = scree::Body;
    using Joint = scree::Joint;
    using WorldManifold = scree::WorldManifold;
    using Contact = scree::Contact;
    using ContactListener = scree::ContactListener;

    static Point ToPoint(scree::Vec2 v) { return {double{v.x}, double{v.y}}; }
    static scree::Vec2 ToVec(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

    static std::unique_ptr<World> MakeWorld(const RunSpec& spec) {
        auto world = std::make_unique<World>(MakeScreeWorldDef(spec));
        world->SetErrorHandler(ThrowError, nullptr);
        scree::inspect::SetDirectJoints(*world, spec.directJoints);
        return world;
    }

    static scree::BodyDef MakeBodyDef(const scenes::Body& body, Point at) {
        scree::BodyDef def;
        def.type = body.type == scenes::BodyType::dynamic     ? scree::dynamicBody
                   : body.type == scenes::BodyType::kinematic ? scree::kinematicBody
                                                              : scree::staticBody;
        const scree::FarPosition split = scree::ToFarPosition(at.x, at.y);
        def.position = split.position;
        def.positionRest = split.positionRest;
        def.linearVelocity = ToScree(body.linearVelocity);
        FillBodyDef(def, body);
        return def;
    }

    static BodyState Capture(const Body& body, int index) { return CaptureBody(body, index); }
    static Point GetOrigin(const Body& body) { return ToPoint(body.GetPosition()) + ToPoint(body.GetPositionRest()); }
    static Point GetCentre(const Body& body) {
        return ToPoint(body.GetWorldCenter()) + ToPoint(body.GetWorldCenterRest());
    }

    static void AddFixture(Body& body, const scenes::Scene& scene, int index, float restitutionThreshold) {
        const scenes::Fixture& fixture = scene.fixtures[static_cast<size_t>(index)];
        scree::FixtureDef def;
        FillMaterial(def, fixture, restitutionThreshold);
        if (fixture.shape.type == scenes::ShapeType::chain) {
            const scree::ChainShape chain = MakeScreeChain(scene, fixture.shape);
            def.shape = &chain;
            body.CreateFixture(&def);
            return;
        }
        const ScreeShape shape = MakeScreeShape(scene, fixture.shape);
        def.shape = &AsShape(shape);
        body.CreateFixture(&def);
    }

    static Joint* MakeJoint(World& world, const scenes::Joint& joint, const ScreeBodies& bodies,
                            const ScreeJoints& joints) {
        return CreateScreeJoint(world, joint, bodies, joints);
    }

    static StepFacts Step(World& world, const RunSpec& spec, float dt) {
        const scree::StepReport report = StepScree(world, spec.solver, dt);
        StepFacts facts;
        facts.capped = report.cappedCount;
        facts.nonFinite = report.nonFiniteCount;
        facts.pairs = report.pairCount;
        return facts;
    }

    static double CastRay(const World& world, scree::Vec2 from, scree::Vec2 to) {
        const auto hit = world.RayCastClosest(from, to);
        return hit ? double{hit->fraction} : 1.0;
    }
    static int CountInBox(const World& world, scree::Vec2 low, scree::Vec2 high) {
        int number = 0;
        world.QueryAABB({low, high}, [&number](scree::Fixture*) { return ++number > 0; });
        return number;
    }

    /// What both shapes have around their outlines, m.
    static double GetSkins(scree::Contact& contact, const RunSpec& spec) {
        const auto skinOf = [&](const scree::Fixture& fixture) {
            const scree::Shape& shape = *fixture.GetShape();
            if (shape.GetType() == scree::Shape::e_circle) return 0.0f;
            if (shape.GetType() == scree::Shape::e_convex) {
                return shape.m_radius - static_cast<const scree::ConvexShape&>(shape).m_solidRadius;
            }
            return std::min(shape.m_radius, scree::polygonRadius * static_cast<float>(spec.lengthScale));
        };
        return double{skinOf(*contact.GetFixtureA())} + double{skinOf(*contact.GetFixtureB())};
    }
    static double GetStepImpulse(scree::Contact& contact, int point) {
        return double{contact.GetManifold().points[point].normalImpulse};
    }
};

}  // namespace

std::unique_ptr<LabWorld> MakeScreeLab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs) {
    return std::make_unique<LabWorldOf<ScreeNames>>(scene, spec, needs);
}

}  // namespace testbed
