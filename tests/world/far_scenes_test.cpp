// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The same scenes near the origin and 14,000 km away from it: seen from their place they must do the same. How exactly
// is told by the scenes themselves. Far away they may differ from the origin by little more than they do at places near
// it, where positions are rounded differently, too.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scree/far_position.h"
#include "tests/world/fixtures.h"

namespace scree::test {
namespace {

struct Place {
    double x = 0.0, y = 0.0;
};

/// Where a scene is built.
class Site {
public:
    Site(World& world, Place place, bool rests = true) : m_world(world), m_place(place), m_rests(rests) {}

    Body* Add(BodyType type, double x, double y, float angle = 0.0f) {
        BodyDef def;
        def.type = type;
        def.angle = angle;
        const FarPosition at = ToFarPosition(m_place.x + x, m_place.y + y);
        def.position = at.position;
        if (m_rests) def.positionRest = at.positionRest;
        m_bodies.push_back(m_world.CreateBody(&def));
        return m_bodies.back();
    }
    Body* AddLink(double x, double y, float hx, float hy) {
        Body* body = Add(dynamicBody, x, y);
        AddBox(body, hx, hy);
        return body;
    }
    Body* AddSlab(double x, double y, float hx, float hy, float friction = 0.6f) {
        Body* body = Add(staticBody, x, y);
        AddBox(body, hx, hy)->SetFriction(friction);
        return body;
    }
    template <typename Def>
    Joint* Join(Def def, Body* a, Body* b) {
        def.bodyA = a, def.bodyB = b;
        return m_world.CreateJoint(&def);
    }
    /// A point of the world, as exactly as a float can tell.
    [[nodiscard]] Vec2 Point(double x, double y) const {
        return {static_cast<float>(m_place.x + x), static_cast<float>(m_place.y + y)};
    }
    /// Centres and angles seen from the place.
    void Read(std::vector<double>& out) const {
        for (const Body* b : m_bodies) {
            if (b->GetType() == staticBody) continue;
            out.push_back(double{b->GetWorldCenter().x} - m_place.x + double{b->GetWorldCenterRest().x});
            out.push_back(double{b->GetWorldCenter().y} - m_place.y + double{b->GetWorldCenterRest().y});
            out.push_back(double{b->GetAngle()});
        }
    }

private:
    World& m_world;
    Place m_place;
    bool m_rests;
    std::vector<Body*> m_bodies;
};

void BuildStack(Site& site) {
    site.AddSlab(0, -1, 20, 1);
    for (int i = 0; i < 6; ++i) site.AddLink(0.02 * (i % 2), 0.515 + 1.015 * i, 0.5f, 0.5f);
}

/// Bodies enough for the solver of large islands.
void BuildWall(Site& site) {
    site.AddSlab(0, -1, 40, 1);
    for (int row = 0; row < 8; ++row) {
        for (int i = 0; i < 12; ++i) site.AddLink(1.05 * i + 0.5 * (row % 2), 0.515 + 1.015 * row, 0.5f, 0.5f);
    }
}

void BuildSlider(Site& site) {
    site.AddSlab(0, -1, 20, 1, 0.0f);
    Body* box = site.AddLink(0.123, 0.515, 0.5f, 0.5f);
    box->SetLinearVelocity({0.01f, 0});
    box->SetSleepingAllowed(false);
}

void BuildFlight(Site& site) {
    Body* body = site.AddLink(0.3, 0.7, 0.5f, 0.5f);
    body->SetGravityScale(0.0f);
    body->SetLinearVelocity({1e-4f, -3e-4f});
    body->SetAngularVelocity(1.5f);
}

/// A pendulum and a chain of boxes whose shapes are off their origins.
void BuildChain(Site& site) {
    Body* before = site.Add(staticBody, 0.37, 0.21);
    Vec2 end{0, 0};
    for (int i = 0; i < 5; ++i) {
        Body* link = site.Add(dynamicBody, 0.37 + 0.8 * i, 0.21);
        PolygonShape box;
        box.SetAsBox(0.4f, 0.1f, {0.4f, 0}, 0);
        link->CreateFixture(&box, 1.0f);
        RevoluteJointDef def;
        def.localAnchorA = end;
        site.Join(def, before, link);
        before = link;
        end = {0.8f, 0};
    }
}

/// Every joint that compares the places of two bodies, or of a body and a point of the world.
void BuildJoints(Site& site) {
    Body* ground = site.Add(staticBody, 0.5, 0.25);
    const auto hang = [&](double x) { return site.AddLink(x, -1.3, 0.4f, 0.2f); };
    PrismaticJointDef slide;
    slide.localAnchorA = {1.1f, -1.5f};
    slide.localAxisA = {0.6f, 0.8f};
    slide.enableLimit = true;
    slide.lowerTranslation = -0.5f, slide.upperTranslation = 0.5f;
    Joint* slider = site.Join(slide, ground, hang(1.6));
    DistanceJointDef rope;
    rope.localAnchorA = {3.1f, 0};
    rope.length = rope.minLength = rope.maxLength = 1.55f;
    site.Join(rope, ground, hang(3.8));
    WheelJointDef wheel;
    wheel.localAnchorA = {5.5f, -1.55f};
    wheel.localAxisA = {0, 1};
    wheel.stiffness = 30.0f, wheel.damping = 1.0f;
    site.Join(wheel, ground, hang(6.0));
    WeldJointDef weld;
    weld.localAnchorA = {7.5f, -1.55f};
    weld.stiffness = 20.0f, weld.damping = 0.5f;
    site.Join(weld, ground, hang(8.0));
    FrictionJointDef friction;
    friction.localAnchorA = {9.5f, -1.55f};
    friction.maxForce = 2.0f, friction.maxTorque = 0.2f;
    site.Join(friction, ground, hang(10.0));
    MotorJointDef motor;
    motor.linearOffset = {11.7f, -1.2f};
    motor.maxForce = 20.0f, motor.maxTorque = 10.0f;
    site.Join(motor, ground, hang(12.0));
    RevoluteJointDef hinge;
    hinge.localAnchorA = {13.5f, -1.55f};
    hinge.localAnchorB = {-0.3f, 0};
    Joint* turner = site.Join(hinge, ground, hang(14.3));
    GearJointDef gear;
    gear.joint1 = slider, gear.joint2 = turner;
    gear.ratio = 0.7f;
    site.Join(gear, slider->GetBodyB(), turner->GetBodyB());
}

/// Points of the world are whole metres far away: where they hang from.
void BuildRopes(Site& site) {
    MouseJointDef mouse;
    Body* ground = site.Add(staticBody, 0, 0);
    Body* held = site.AddLink(1.25, -0.5, 0.4f, 0.2f);
    mouse.target = site.Point(2, 0);
    mouse.maxForce = 100.0f, mouse.stiffness = 20.0f, mouse.damping = 2.0f;
    Joint* joint = site.Join(mouse, ground, held);
    static_cast<MouseJoint*>(joint)->SetTarget(site.Point(3, 1));
    PulleyJointDef pulley;
    pulley.groundAnchorA = site.Point(6, 5), pulley.groundAnchorB = site.Point(9, 5);
    pulley.lengthA = 4.25f, pulley.lengthB = 4.0f;
    Body* left = site.AddLink(6.125, 0.75, 0.5f, 0.5f);
    site.Join(pulley, left, site.AddLink(9, 1, 0.5f, 0.25f));
}

/// Bullets at a thin wall, hit at fractions of a metre and of a step.
void BuildShots(Site& site) {
    site.AddSlab(10.4, 0, 0.01f, 30);
    for (int i = 0; i < 12; ++i) {
        Body* shot = site.Add(dynamicBody, 0.1 * i, 1.3 * i - 8.0, 0.2f * static_cast<float>(i));
        shot->SetBullet(true);
        AddBox(shot, 0.2f, 0.1f);
        shot->SetLinearVelocity({300.0f + 37.0f * static_cast<float>(i), 0});
        shot->SetAngularVelocity(static_cast<float>(3 * i));
    }
}

struct Case {
    std::string name;
    void (*build)(Site&);
    int steps;
    /// What no place may differ by, m and rad: the scene must not be so sensitive that nothing is shown.
    double most;
    bool gravity = true;
};

std::vector<double> Trace(const Case& one, bool soft, Place place, bool rests = true) {
    WorldDef def;
    def.gravity = {0, one.gravity ? -10.0f : 0.0f};
    if (!rests) def.farDistance = INFINITY;
    World world(def);
    Site site(world, place, rests);
    one.build(site);
    std::vector<double> trace;
    for (int step = 0; step < one.steps; ++step) {
        StepWith(world, soft ? 4 : 0);
        site.Read(trace);
    }
    return trace;
}

double Differ(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double worst = 0.0;
    for (size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
}

const Case cases[] = {
    {"stack", BuildStack, 240, 0.02},  {"wall", BuildWall, 60, 0.05},         {"slider", BuildSlider, 600, 2e-3},
    {"flight", BuildFlight, 60, 1e-4}, {"chain", BuildChain, 90, 5e-3},       {"joints", BuildJoints, 90, 0.02},
    {"ropes", BuildRopes, 120, 5e-3},  {"shots", BuildShots, 4, 0.05, false},
};

class FarScenes : public testing::TestWithParam<bool> {};

TEST_P(FarScenes, DoAsNearTheOrigin) {
    const bool soft = GetParam();
    for (const Case& one : cases) {
        const std::vector<double> origin = Trace(one, soft, {});
        double near = 0.0;
        for (Place place : {Place{3.3, -1.7}, Place{-5.9, 4.1}, Place{10.0, 7.0}}) {
            // Its points of the world are the same at whole metres only.
            if (one.build == BuildRopes) place = {std::floor(place.x), std::floor(place.y)};
            near = std::max(near, Differ(origin, Trace(one, soft, place)));
        }
        for (const Place place : {Place{1e7, -1e7}, Place{-4194304.0, 99999.0}, Place{0.0, 1e7}, Place{2048.0, 5.0}}) {
            const double far = Differ(origin, Trace(one, soft, place));
            EXPECT_LE(far, std::max(4.0 * near, 1e-5)) << one.name << " at " << place.x << ", " << place.y;
            EXPECT_LE(far, one.most) << one.name << " at " << place.x << ", " << place.y;
            RecordProperty(one.name, std::to_string(far));
        }
    }
}

/// Where floats are exact enough, worlds with and without rests do the same.
TEST_P(FarScenes, DoAsWithoutRestsNearTheOrigin) {
    const bool soft = GetParam();
    for (const Case& one : cases) {
        const std::vector<double> origin = Trace(one, soft, {}, false);
        double floats = 0.0;
        for (Place place : {Place{3.0, -2.0}, Place{-6.0, 4.0}, Place{10.0, 7.0}}) {
            floats = std::max(floats, Differ(origin, Trace(one, soft, place, false)));
        }
        const double rests = Differ(origin, Trace(one, soft, {}));
        EXPECT_LE(rests, std::max(4.0 * floats, 1e-5)) << one.name;
        EXPECT_LE(rests, one.most) << one.name;
    }
}

TEST_P(FarScenes, NeedTheRests) {
    for (const Case& one : cases) {
        const std::vector<double> origin = Trace(one, GetParam(), {});
        const double plain = Differ(origin, Trace(one, GetParam(), {1e7, -1e7}, false));
        EXPECT_GT(plain, one.most) << one.name;
    }
}

TEST_P(FarScenes, DoNotDisturbEachOther) {
    const bool soft = GetParam();
    const Place places[] = {{1e7, 0.0}, {-1e7, 3e6}};
    World world({0, -10});
    std::vector<Site> sites;
    for (const Place place : places) BuildStack(sites.emplace_back(world, place));
    std::vector<std::vector<double>> traces(2);
    for (int step = 0; step < cases[0].steps; ++step) {
        StepWith(world, soft ? 4 : 0);
        for (size_t i = 0; i < 2; ++i) sites[i].Read(traces[i]);
    }
    for (size_t i = 0; i < 2; ++i) EXPECT_LE(Differ(Trace(cases[0], soft, places[i]), traces[i]), 1e-5) << i;
}

INSTANTIATE_TEST_SUITE_P(Solvers, FarScenes, testing::Bool(),
                         [](const auto& one) { return one.param ? "softStep" : "sequentialImpulses"; });

}  // namespace
}  // namespace scree::test
