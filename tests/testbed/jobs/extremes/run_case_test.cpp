// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The watcher on worlds whose measurements are known, the outline of a moment, and the list of cases.

#include "testbed/jobs/extremes/run_case.h"

#include <gtest/gtest.h>

#include <set>

#include "scenes/build.h"
#include "testbed/jobs/extremes/outline.h"

namespace testbed {
namespace {

/// A disk thrown in free space, or under gravity.
scenes::Scene MakeThrown(double g) {
    scenes::Scene scene;
    scene.gravity = scenes::Point(0.0, -g);
    scenes::AddBody(scene, scenes::BodyType::dynamic, scenes::Point(0.0, 0.0)).linearVelocity = scenes::Point(3.0, 0.0);
    scenes::AddFixture(scene, scenes::Circle(0.5), 1.0);
    return scene;
}

ExtremeCase MakeCase(double g) {
    ExtremeCase one;
    one.name = "thrown";
    one.make = [g] { return MakeThrown(g); };
    one.seconds = 1.0;
    return one;
}

TEST(RunCase, MeasuresAFreeFlightInBothEngines) {
    for (const char* engine : {"scree", "box2d"}) {
        ExtremeCase one = MakeCase(0.0);
        one.demands.bounds = Bounds{{-1.0, -1.0}, {2.9, 1.0}};  // left after 58 of 60 steps
        one.measure = [](const LabWorld& lab, double seconds) { return lab.Read(0).centre.x / seconds; };
        const CaseRun run = RunCase(one, MakeSpec(engine), {});
        EXPECT_EQ(run.outcome.steps, 60) << engine;
        EXPECT_EQ(run.outcome.escapes, 1) << engine;
        EXPECT_GE(run.outcome.worstStep, 58) << engine;
        EXPECT_NEAR(run.outcome.maxSpeed, 3.0, 1e-6) << engine;
        EXPECT_NEAR(run.outcome.accuracy, 3.0, 1e-4) << engine;  // 60 additions of floats
        EXPECT_LT(run.outcome.gain, 1e-5) << engine;
        EXPECT_EQ(run.outcome.repeated, 1) << engine;
        EXPECT_TRUE(run.outcome.finite && run.outcome.refusal.empty() && !run.outcome.shortened) << engine;
        EXPECT_NE(run.picture.find("<circle"), std::string::npos) << engine;
    }
}

TEST(RunCase, SeesEnergyThatIsPutIn) {
    ExtremeCase one = MakeCase(0.0);
    one.disturb = [](LabWorld& lab, int step) {
        if (step == 10) lab.SetVelocity(0, {6.0, 0.0}, 0.0);  // four times the energy
    };
    // The scale is the energy of the start and, without gravity, only that of a motion of 1 cm/s besides.
    EXPECT_NEAR(RunCase(one, MakeSpec("scree"), {}).outcome.gain, 3.0 * 9.0 / (9.0 + 1e-4), 1e-6);
}

TEST(RunCase, SeesAStateThatIsNotFinite) {
    ExtremeCase one = MakeCase(0.0);
    one.disturb = [](LabWorld& lab, int step) {
        if (step == 5) lab.SetVelocity(0, {9e17, 9e17}, 0.0);  // its square is finite, its way is soon out of bounds
        if (step > 5) lab.ApplyForce(0, {3e38, 0.0});
    };
    const Outcome box2d = RunCase(one, MakeSpec("box2d"), {}).outcome;
    const Outcome ours = RunCase(one, MakeSpec("scree"), {}).outcome;
    // Either engine ends in one of the two ways that are seen; ours reports the bodies it stops.
    EXPECT_TRUE(!box2d.finite || box2d.maxSpeed > 1.0);
    EXPECT_TRUE(ours.finite);
    EXPECT_GT(ours.stopped, 0);
}

TEST(RunCase, StopsWhereTheBudgetEnds) {
    ExtremeCase one = MakeCase(10.0);
    one.seconds = 1e9;
    const Outcome outcome = RunCase(one, MakeSpec("scree"), {.cpuSeconds = 0.02}).outcome;
    EXPECT_TRUE(outcome.shortened);
    EXPECT_EQ(outcome.repeated, -1);
}

TEST(RunCase, RefusedScenesAreAnOutcome) {
    ExtremeCase one = MakeCase(0.0);
    one.make = [] {
        scenes::Scene scene = MakeThrown(0.0);
        scene.fixtures[0].density = -1.0f;
        return scene;
    };
    const Outcome outcome = RunCase(one, MakeSpec("scree"), {}).outcome;
    EXPECT_NE(outcome.refusal.find("density"), std::string::npos) << outcome.refusal;
}

TEST(RunCase, EnergyAndExtentsAreThoseOfTheShapes) {
    scenes::Scene scene = MakeThrown(10.0);
    scenes::AddFixture(scene, scenes::Box(0.2, 0.4), 1.0);
    EXPECT_NEAR(SmallestExtent(scene, 0), 0.4, 1e-7);
    BodyReading body;
    body.mass = 2.0;
    body.inertia = 3.0;
    body.velocity = {1.0, 2.0};
    body.spin = 4.0;
    body.centre = {0.0, 5.0};
    EXPECT_DOUBLE_EQ(SumEnergy(scene, std::span(&body, 1), {0.0, -10.0}), 5.0 + 24.0 + 100.0);
}

TEST(Outline, LeavesOutWhatIsNotFinite) {
    scenes::Scene scene = MakeThrown(0.0);
    scenes::AddBody(scene, scenes::BodyType::dynamic, {});
    scenes::AddFixture(scene, scenes::Box(0.5, 0.5), 1.0);
    std::vector<BodyReading> bodies(2);
    bodies[1].origin = {std::nan(""), 0.0};
    const std::string svg = DrawOutline(scene, bodies);
    EXPECT_NE(svg.find("<circle"), std::string::npos);
    EXPECT_EQ(svg.find("<polygon"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    bodies[1].origin = {};
    EXPECT_NE(DrawOutline(scene, bodies).find("<polygon"), std::string::npos);
}

TEST(ExtremeCases, AreComplete) {
    std::set<std::string> names;
    int visible = 0;
    for (const ExtremeCase& one : GetExtremeCases()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_FALSE(one.group.empty() || one.what.empty()) << one.name;
        EXPECT_TRUE(one.make || one.abuse) << one.name;
        visible += !one.hidden;
        if (!one.make) continue;
        const scenes::Scene scene = one.make();
        EXPECT_GT(scenes::Count(scene).dynamicBodies, 0) << one.name;
        if (!one.demands.bounds) continue;
        for (const scenes::Body& body : scene.bodies) {  // nobody has escaped before the start
            if (body.type != scenes::BodyType::dynamic || one.name == "offset-shape") continue;
            const double x = one.place.x + static_cast<double>(body.position.x);
            const double y = one.place.y + static_cast<double>(body.position.y);
            const Bounds& bounds = *one.demands.bounds;
            EXPECT_TRUE(x >= bounds.lower.x && x <= bounds.upper.x && y >= bounds.lower.y && y <= bounds.upper.y)
                << one.name;
        }
    }
    EXPECT_GE(visible, 115);
}

}  // namespace
}  // namespace testbed
