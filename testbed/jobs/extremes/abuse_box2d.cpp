// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The bad calls to Box2D 2.4.1. It reports nothing: it asserts, or goes on.

#include <box2d/box2d.h>

#include <stdexcept>

#include "testbed/jobs/extremes/abuse_world.h"

namespace testbed {
namespace {

struct Box2dAbuse {
    using World = b2World;
    using Body = b2Body;
    using BodyDef = b2BodyDef;
    using FixtureDef = b2FixtureDef;
    using Circle = b2CircleShape;
    using Edge = b2EdgeShape;
    using Polygon = b2PolygonShape;
    using Vec = b2Vec2;
    using RevoluteDef = b2RevoluteJointDef;
    using PrismaticDef = b2PrismaticJointDef;
    using DistanceDef = b2DistanceJointDef;
    using PulleyDef = b2PulleyJointDef;
    using MouseDef = b2MouseJointDef;
    using GearDef = b2GearJointDef;
    using WheelDef = b2WheelJointDef;
    using WeldDef = b2WeldJointDef;
    using FrictionDef = b2FrictionJointDef;
    using MotorDef = b2MotorJointDef;
    using Aabb = b2AABB;
    using Contact = b2Contact;
    using ContactListener = b2ContactListener;
    static constexpr auto isDynamic = b2_dynamicBody;

    static std::unique_ptr<World> MakeWorld(AbuseErrors&) { return std::make_unique<World>(b2Vec2(0.0f, -10.0f)); }
    static bool SetPolygon(Polygon& polygon, const std::vector<Vec>& points) {
        polygon.Set(points.data(), static_cast<int32>(points.size()));
        return true;
    }
    struct Reporter final : b2QueryCallback, b2RayCastCallback {
        bool ReportFixture(b2Fixture*) override { return true; }
        float ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float) override { return 1.0f; }
    };
    static void Step(World& world, float dt, bool, int iterations) { world.Step(dt, iterations, 3); }
    static const Body* GetId(World&, const Body& body) { return &body; }
    /// Its handles are pointers and cannot tell.
    static bool IsAlive(World&, const Body*) { return false; }
};

}  // namespace

AbuseResult AbuseBox2d(Abuse abuse) { return Abuser<Box2dAbuse>(false).Run(abuse); }

bool CanAbuse(std::string_view engine) { return engine == "box2d" || engine == "scree"; }

AbuseResult RunAbuse(const RunSpec& setting, Abuse abuse) {
    if (setting.engine == "box2d") return AbuseBox2d(abuse);
    if (setting.engine == "scree") return AbuseScree(!IsSequential(setting), abuse);
    throw std::invalid_argument("unknown engine '" + setting.engine + "': use scree or box2d");
}

}  // namespace testbed
