// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D 3 as an engine of the testbed, where the build found it; where not, each test says that it asked nothing.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

#include "scenes/build.h"
#include "scenes/catalog.h"
#include "testbed/base/errors.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/lab.h"
#include "testbed/engines/pair_count.h"
#include "tests/testbed/engines/run_checks.h"

namespace testbed {
namespace {

/// False, and a line that says so, in a build without Box2D 3.
bool HasBox2d3() {
    const bool has = std::ranges::find(GetEngines(), "box2d3", &EngineInfo::name) != GetEngines().end();
    if (!has) std::cout << "left out: this build has no Box2D 3 (box2d3_ROOT names where it is installed)\n";
    return has;
}

bool CanSay(const scenes::Scene& scene) {
    return std::ranges::none_of(scene.joints, [](const scenes::Joint& joint) {
        return joint.type == scenes::JointType::gear || joint.type == scenes::JointType::pulley ||
               joint.type == scenes::JointType::motor;
    });
}

Snapshot RunFor(const scenes::Scene& scene, int steps, RunSpec spec = MakeSpec("box2d3")) {
    const auto run = MakeRun(scene, spec);
    for (int i = 0; i < steps; ++i) run->Step();
    Snapshot snapshot;
    run->Capture(snapshot);
    return snapshot;
}

TEST(Box2d3, ABuildWithoutItKnowsItAndSaysWhatToDo) {
    EXPECT_EQ(FindEngine("box2d3").name, "box2d3");
    if (HasBox2d3()) return;
    try {
        (void)MakeRun(scenes::Build("pyramid", 3), MakeSpec("box2d3"));
        FAIL() << "it ran";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("box2d3_ROOT"), std::string::npos) << error.what();
    }
}

TEST(Box2d3, StepsBySubstepsOnly) {
    if (!HasBox2d3()) return;
    EXPECT_EQ(MakeSpec("box2d3").solver, Solver(SoftStep{4}));
    const scenes::Scene scene = scenes::Build("pyramid", 3);
    RunSpec spec = MakeSpec("box2d3");
    spec.solver = SequentialImpulses{};
    EXPECT_THROW((void)MakeRun(scene, spec), std::invalid_argument);
    spec.solver = Accuracy::fine;
    EXPECT_THROW((void)MakeRun(scene, spec), std::invalid_argument);
}

TEST(Box2d3, RunsEveryBuiltInSceneThatItCanSay) {
    if (!HasBox2d3()) return;
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        SCOPED_TRACE(info.name);
        const scenes::Scene scene = scenes::Build(info.name, checks::SmallSize(info));
        if (!CanSay(scene)) {
            EXPECT_THROW((void)MakeRun(scene, MakeSpec("box2d3")), std::invalid_argument);
            continue;
        }
        const Snapshot snapshot = RunFor(scene, 10);
        ASSERT_EQ(static_cast<int>(snapshot.bodies.size()), checks::BodiesAfter(scene, 10));
        for (const BodyState& body : snapshot.bodies) ASSERT_TRUE(checks::IsFinite(body));
        ASSERT_EQ(snapshot.joints.size(), scene.joints.size());
        checks::ExpectTreeHoldsFixtures(snapshot);
        EXPECT_GE(snapshot.pairsReported, CountPairs(TightBoxes(snapshot)));
        EXPECT_EQ(static_cast<int>(snapshot.contacts.size()), snapshot.touchingCount);
        for (const ContactState& contact : snapshot.contacts) {
            ASSERT_GE(std::min(contact.fixtureA, contact.fixtureB), 0);
            ASSERT_LT(std::max(contact.fixtureA, contact.fixtureB), static_cast<int>(snapshot.fixtures.size()));
        }
    }
}

TEST(Box2d3, FreeFlightFollowsTheParabola) {
    if (!HasBox2d3()) return;
    EXPECT_TRUE(rc::check("free flight", [] {
        const auto unit = [] { return 0.01f * static_cast<float>(*rc::gen::inRange(-500, 500)); };
        scenes::Scene scene;
        scene.name = "flight";
        scenes::Body body;
        body.type = scenes::BodyType::dynamic;
        body.position = {unit(), unit()};
        body.linearVelocity = {unit(), unit()};
        body.angularVelocity = unit();
        body.fixtureCount = 1;
        scenes::Fixture fixture;
        fixture.shape.type = scenes::ShapeType::circle;
        fixture.shape.radius = 0.5f;
        fixture.shape.center = {0.1f * unit(), 0.1f * unit()};
        fixture.density = 1.0f;
        scene.bodies.push_back(body);
        scene.fixtures.push_back(fixture);
        constexpr int steps = 60;
        const Snapshot snapshot = RunFor(scene, steps);
        const BodyState& end = snapshot.bodies[0];
        const double t = steps * double{scene.timeStep};
        const double turned = body.angularVelocity * t;
        // The centre of mass flies; the origin turns about it.
        const Vec2 c = fixture.shape.center;
        const double x = body.position.x + double{c.x} + body.linearVelocity.x * t;
        const double y = body.position.y + double{c.y} + body.linearVelocity.y * t - 5.0 * t * t;
        const double originX = x - (c.x * std::cos(turned) - c.y * std::sin(turned));
        const double originY = y - (c.x * std::sin(turned) + c.y * std::cos(turned));
        // Four sub-steps of the symplectic rule end g·t·h/2 lower, h the sub-step.
        const double lower = 10.0 * t * double{scene.timeStep} / 4.0 / 2.0;
        RC_ASSERT(std::abs(end.position.x - originX) < 5e-3);
        RC_ASSERT(std::abs(end.position.y - (originY - lower)) < 5e-3);
    }));
}

TEST(Box2d3, ItsTreesFollowAnotherEngine) {
    if (!HasBox2d3()) return;
    for (const char* name : {"falling-squares", "tumbler", "add-pair"}) {
        SCOPED_TRACE(name);
        const scenes::Scene scene = scenes::Build(name, checks::SmallSize(*scenes::Find(name)));
        const RunSpec source = MakeSpec("scree", likeBox2dPreset);
        const auto follower = MakeFollower(scene, MakeSpec("box2d3"), source),
                   own = MakeFollower(scene, source, source);
        for (int i = 0; i < 30; ++i) follower->Step(), own->Step();
        Snapshot theirs, ours;
        follower->Capture(theirs);
        own->Capture(ours);
        EXPECT_EQ(theirs.engine, "box2d3");
        EXPECT_EQ(theirs.stateHash, ours.stateHash);
        checks::ExpectTreeHoldsFixtures(theirs);
        EXPECT_GE(theirs.pairsReported, CountPairs(TightBoxes(ours)));
    }
}

TEST(Box2d3, AJointKeepsWhatItJoins) {
    if (!HasBox2d3()) return;
    for (const char* name : {"bridge", "car", "ragdolls", "slider-crank"}) {
        SCOPED_TRACE(name);
        const scenes::Scene scene = scenes::Build(name, checks::SmallSize(*scenes::Find(name)));
        const Snapshot snapshot = RunFor(scene, 60);
        for (const JointState& joint : snapshot.joints) {
            const bool isPoint = joint.type == scenes::JointType::revolute || joint.type == scenes::JointType::weld;
            if (!isPoint) continue;
            EXPECT_LT(std::hypot(joint.anchorA.x - joint.anchorB.x, joint.anchorA.y - joint.anchorB.y), 0.1);
        }
    }
}

TEST(Box2d3, ItsLaboratoryIsTheSameWorld) {
    if (!HasBox2d3()) return;
    for (const char* name : {"pyramid", "bridge", "ragdolls", "falling-squares"}) {
        SCOPED_TRACE(name);
        const scenes::Scene scene = scenes::Build(name, checks::SmallSize(*scenes::Find(name)));
        RunSpec spec = MakeSpec("box2d3");
        spec.solver = SoftStep{6};
        const auto lab = MakeLab(scene, spec);
        for (int i = 0; i < 40; ++i) (void)lab->Step();
        const Snapshot snapshot = RunFor(scene, 40, spec);
        EXPECT_EQ(lab->GetStateHash(), snapshot.stateHash);
        std::vector<ContactReading> contacts;
        lab->GetContacts(contacts);
        EXPECT_EQ(contacts.size(), snapshot.contacts.size());
        for (int i = 0; i < lab->GetBodyCount(); ++i) {
            EXPECT_EQ(static_cast<float>(lab->Read(i).origin.x),
                      snapshot.bodies[static_cast<std::size_t>(i)].position.x);
        }
    }
}

TEST(Box2d3, ItsLaboratoryCountsTurnsAndForces) {
    if (!HasBox2d3()) return;
    scenes::Scene scene;
    scene.gravity = {0.0f, -10.0f};
    scenes::AddBody(scene, scenes::BodyType::isStatic, {0.0f, 0.0f});
    scenes::AddBody(scene, scenes::BodyType::dynamic, {0.0f, 0.5f});
    scenes::AddFixture(scene, scenes::Box(0.5, 0.5), 2.0);
    scenes::Joint hinge;
    hinge.type = scenes::JointType::revolute;
    hinge.bodyA = 0;
    hinge.bodyB = 1;
    hinge.localAnchorA = {0.0f, 0.5f};
    scene.joints.push_back(hinge);
    scene.bodies[1].angularVelocity = 9.0f;
    RunSpec spec = MakeSpec("box2d3");
    const auto lab = MakeLab(scene, spec);
    for (int i = 0; i < 180; ++i) (void)lab->Step();
    // The hinge is at the centre: nothing turns it.
    EXPECT_NEAR(lab->Read(1).angle, 27.0, 0.2);
    EXPECT_NEAR(Length(lab->GetJointForce(0)), 20.0, 0.5) << "the weight of 2 kg";
    EXPECT_NEAR(lab->Read(1).mass, 2.0, 1e-4);
    EXPECT_NEAR(lab->Read(1).inertia, 2.0 / 6.0, 1e-4);
    lab->DestroyBody(1);
    EXPECT_THROW((void)lab->Read(1), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
