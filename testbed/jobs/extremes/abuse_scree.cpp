// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The bad calls to our engine, which reports each with the name of the field.

#include "scree/scree.h"
#include "testbed/jobs/extremes/abuse_world.h"

namespace testbed {
namespace {

struct ScreeAbuse {
    using World = scree::World;
    using Body = scree::Body;
    using BodyDef = scree::BodyDef;
    using FixtureDef = scree::FixtureDef;
    using Circle = scree::CircleShape;
    using Edge = scree::EdgeShape;
    using Polygon = scree::PolygonShape;
    using Vec = scree::Vec2;
    using RevoluteDef = scree::RevoluteJointDef;
    using PrismaticDef = scree::PrismaticJointDef;
    using DistanceDef = scree::DistanceJointDef;
    using PulleyDef = scree::PulleyJointDef;
    using MouseDef = scree::MouseJointDef;
    using GearDef = scree::GearJointDef;
    using WheelDef = scree::WheelJointDef;
    using WeldDef = scree::WeldJointDef;
    using FrictionDef = scree::FrictionJointDef;
    using MotorDef = scree::MotorJointDef;
    using Aabb = scree::AABB;
    using Contact = scree::Contact;
    using ContactListener = scree::ContactListener;
    static constexpr auto isDynamic = scree::dynamicBody;

    static std::unique_ptr<World> MakeWorld(AbuseErrors& errors) {
        auto world = std::make_unique<World>(scree::Vec2{0.0f, -10.0f});
        world->SetErrorHandler(
            [](const scree::Error& error, void* context) {
                auto& count = *static_cast<AbuseErrors*>(context);
                ++count.count;
                count.named += error.field != nullptr && error.field[0] != '\0';
            },
            &errors);
        return world;
    }
    static bool SetPolygon(Polygon& polygon, const std::vector<Vec>& points) {
        return polygon.Set(points.data(), static_cast<int>(points.size()));
    }
    struct Reporter final : scree::QueryCallback, scree::RayCastCallback {
        bool ReportFixture(scree::Fixture*) override { return true; }
        float ReportFixture(scree::Fixture*, const scree::Vec2&, const scree::Vec2&, float) override { return 1.0f; }
    };
    static void Step(World& world, float dt, bool soft, int iterations) {
        soft ? world.Step(dt, iterations) : world.Step(dt, iterations, 3);
    }
    static scree::BodyId GetId(World& world, const Body& body) { return world.GetId(&body); }
    static bool IsAlive(World& world, scree::BodyId id) { return world.Find(id) != nullptr; }
};

}  // namespace

AbuseResult AbuseScree(bool soft, Abuse abuse) { return Abuser<ScreeAbuse>(soft).Run(abuse); }

}  // namespace testbed
