// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a user does to a run, in both engines: dragging, shooting, changing the solver's settings.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"
#include "tests/testbed/engines/run_checks.h"
#include "tests/testbed/engines/scene_builder.h"

namespace testbed {
namespace {

class InteractiveRunOf : public testing::TestWithParam<const char*> {
protected:
    static std::unique_ptr<InteractiveRun> Make(const scenes::Scene& scene) {
        return MakeRun(scene, MakeSpec(GetParam(), likeBox2dPreset));
    }
    static Snapshot CaptureOf(InteractiveRun& run) {
        Snapshot snapshot;
        run.Capture(snapshot);
        return snapshot;
    }
    static void Step(InteractiveRun& run, int count) {
        for (int i = 0; i < count; ++i) run.Step();
    }
};

TEST_P(InteractiveRunOf, ADraggedBodyHangsAtTheTarget) {
    const auto run = Make(checks::RestingBox());
    run->BeginDrag(1, {0, 0});
    run->MoveDrag({4, 6});
    Step(*run, 240);  // four seconds: twenty periods of the spring
    const BodyState body = CaptureOf(*run).bodies[1];
    // A spring of 5 Hz hangs g/(2πf)² = 1 cm lower under gravity; the rest is what is left of the swing.
    EXPECT_NEAR(body.position.x, 4, 0.02);
    EXPECT_NEAR(body.position.y, 6 - 10 / std::pow(2 * 3.14159265 * 5, 2), 0.02);
    run->EndDrag();
    run->MoveDrag({0, 100});  // nothing without a drag
    Step(*run, 240);
    EXPECT_NEAR(CaptureOf(*run).bodies[1].position.y, 1.5, 0.02) << "back on the ground, within the contact's slop";
}

TEST_P(InteractiveRunOf, APointOfABodyIsPulledAndTurnsIt) {
    scenes::Scene scene = checks::RestingBox();
    scene.gravity = {0, 0};
    const auto run = Make(scene);
    run->BeginDrag(1, {0.5f, 0});
    run->MoveDrag({0, 6});
    Step(*run, 600);
    const BodyState body = CaptureOf(*run).bodies[1];
    const double x = body.position.x + body.cos * 0.5, y = body.position.y + body.sin * 0.5;
    EXPECT_NEAR(std::hypot(x, y - 6), 0, 0.05) << "the point, not the centre, is at the target";
    EXPECT_GT(std::abs(body.angle), 0.1);
}

TEST_P(InteractiveRunOf, OnlyDynamicBodiesCanBeDragged) {
    const auto run = Make(checks::RestingBox());
    EXPECT_THROW(run->BeginDrag(0, {0, 0}), std::invalid_argument);
    EXPECT_THROW(run->BeginDrag(2, {0, 0}), std::invalid_argument);
    EXPECT_THROW(run->BeginDrag(-1, {0, 0}), std::invalid_argument);
}

TEST_P(InteractiveRunOf, ABulletFliesAndLaterSpawnsStillCome) {
    const scenes::Scene scene = scenes::Build("tumbler", 20);
    const auto run = Make(scene);
    Step(*run, 5);
    const int index = run->ShootBullet({0, 500}, {10, 0});
    EXPECT_EQ(index, checks::BodiesAfter(scene, 5));
    Step(*run, 10);
    const Snapshot s = CaptureOf(*run);
    ASSERT_EQ(static_cast<int>(s.bodies.size()), checks::BodiesAfter(scene, 15) + 1);
    EXPECT_TRUE(s.bodies[static_cast<size_t>(index)].bullet);
    // Ten steps of 1/60 s at 10 m/s; floats near 1 m.
    EXPECT_NEAR(s.bodies[static_cast<size_t>(index)].position.x, 10 * 10.0 / 60, 1e-4);
    const auto last = s.bodies.size() - 1;  // created after the last step: where the scene puts it
    EXPECT_EQ(s.bodies[last].position, scene.bodies[last - 1].position);
    EXPECT_EQ(s.fixtures.back().body, static_cast<int>(last));
}

TEST_P(InteractiveRunOf, SettingsActFromTheNextStep) {
    const auto run = Make(checks::FreeFlight());
    RunSpec settings = run->GetSpec();
    settings.gravity = Vec2{3, 0};
    settings.timeStep = 1.0 / 120;
    run->Apply(settings);
    const BodyState before = CaptureOf(*run).bodies[2];  // neither damped nor of another gravity scale
    run->Step();
    const BodyState after = CaptureOf(*run).bodies[2];
    EXPECT_NEAR(after.linearVelocity.x - before.linearVelocity.x, 3.0 / 120, 1e-5);
    EXPECT_NEAR(after.linearVelocity.y - before.linearVelocity.y, 0, 1e-6);
    EXPECT_EQ(run->GetSpec(), settings);
}

TEST_P(InteractiveRunOf, TurningSleepOffWakesABox) {
    const auto run = Make(checks::RestingBox());
    Step(*run, 120);  // two seconds at rest: four times what sleeping takes
    ASSERT_FALSE(CaptureOf(*run).bodies[1].awake);
    RunSpec settings = run->GetSpec();
    settings.sleeping = false;
    run->Apply(settings);
    Step(*run, 120);
    EXPECT_TRUE(CaptureOf(*run).bodies[1].awake);
}

TEST_P(InteractiveRunOf, TheSettingsItHasChangeNothing) {
    const scenes::Scene scene = scenes::Build("box-stack");
    const auto plain = Make(scene), applied = Make(scene);
    applied->Apply(applied->GetSpec());
    Step(*plain, 40);
    Step(*applied, 40);
    EXPECT_EQ(CaptureOf(*plain).stateHash, CaptureOf(*applied).stateHash);
}

TEST_P(InteractiveRunOf, IllegalSettingsAreRefusedWhole) {
    const auto run = Make(checks::RestingBox());
    const RunSpec before = run->GetSpec();
    for (const auto& spoil : {+[](RunSpec& s) { s.timeStep = 0; }, +[](RunSpec& s) { s.timeStep = 1; },
                              +[](RunSpec& s) {
                                  s.solver = SequentialImpulses{Iterations{0, 3}};
                              },
                              +[](RunSpec& s) {
                                  s.solver = SequentialImpulses{Iterations{8, -1}};
                              },
                              +[](RunSpec& s) { s.gravity->y = NAN; }}) {
        RunSpec bad = before;
        bad.sleeping = false;
        spoil(bad);
        EXPECT_THROW(run->Apply(bad), std::invalid_argument);
        EXPECT_EQ(run->GetSpec(), before);
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, InteractiveRunOf, testing::Values("scree", "box2d"),
                         [](const auto& i) { return std::string(i.param); });

}  // namespace
}  // namespace testbed
