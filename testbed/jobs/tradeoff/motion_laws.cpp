// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Free flight and spin, what isolated systems keep, and the order of convergence.

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/tradeoff/law.h"

namespace testbed {
namespace {

// --- Projectile: thrown with (10, 20) m/s, after 4 s at (40, 0) with the energy of the start.

scenes::Scene MakeProjectile() {
    scenes::Scene scene = MakeEmptyScene();
    Throw(scene, AddDynamic(scene, {}, scenes::Circle(0.1)), {10.0, 20.0});
    return scene;
}

std::vector<double> MeasureProjectile(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakeProjectile(), setting);
    Run(*lab, setting, 4.0);
    const BodyReading ball = lab->Read(0);
    const double energy = 0.5 * Dot(ball.velocity, ball.velocity) + gravity * ball.centre.y;
    return {Length(ball.centre - Point{40.0, 0.0}), RelativeError(energy, 250.0)};
}

// --- Free spin: θ = ωt after 10 s.

scenes::Scene MakeSpin(double rate) {
    scenes::Scene scene = MakeEmptyScene(0.0);
    Throw(scene, AddDynamic(scene, {}, scenes::Box(0.5, 0.2)), {}, rate);
    return scene;
}

std::vector<double> MeasureSpin(const RunSpec& setting, Effort) {
    double relative = 0.0, absolute = 0.0;
    for (const double rate : {5.0, 20.0, 40.0}) {
        const auto lab = MakeLab(MakeSpin(rate), setting);
        // The readings in between count the turns, should the engine's own angle lose one.
        Run(*lab, setting, 10.0);
        const double miss = std::abs(lab->Read(0).angle - 10.0 * rate);
        absolute = std::max(absolute, miss);
        relative = std::max(relative, miss / (10.0 * rate));
    }
    return {absolute, relative};
}

// --- Free chain: a thrown, turning chain in zero gravity keeps energy, momentum and angular momentum.

constexpr int freeLinks = 20;

scenes::Scene MakeFreeChain() {
    scenes::Scene scene = MakeEmptyScene(0.0);
    for (int i = 0; i < freeLinks; ++i) {
        const double x = i - 0.5 * (freeLinks - 1);
        const int link = AddDynamic(scene, {x, 0.0}, scenes::Box(0.5, 0.125));
        Throw(scene, link, {2.0, 1.0 + x}, 1.0);  // moves as one rigid body: consistent with its joints
        if (i > 0) Hinge(scene, link - 1, link, {x - 0.5, 0.0});
    }
    return scene;
}

std::vector<double> MeasureFreeChain(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakeFreeChain(), setting);
    const Invariants start = SumInvariants(ReadMoving(*lab));
    DriftWatch drift(start, Length(start.momentum), std::abs(start.angular));
    double gap = 0.0;
    for (int i = 0; i < 10 * GetRate(setting); ++i) {
        lab->Step();
        drift.Add(SumInvariants(ReadMoving(*lab)));
        gap = std::max(gap, WorstJointGap(*lab));
    }
    return {drift.GetAngular(), drift.GetGain(), drift.GetMomentum(), gap};
}

// --- Elastic gas: 64 disks of restitution 1 thrown at each other in free space.

scenes::Scene MakeGas(unsigned seed) {
    scenes::Scene scene = MakeEmptyScene(0.0);
    scenes::Random random(seed);
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            const double x = 2.0 * i - 7.0 + random.Uniform(-0.3, 0.3), y = 2.0 * j - 7.0 + random.Uniform(-0.3, 0.3);
            const int disk = AddDynamic(scene, {x, y}, scenes::Circle(0.4), {1.0, 0.0, 1.0});
            const double vx = random.Uniform(-3.0, 3.0) - 0.5 * x, vy = random.Uniform(-3.0, 3.0) - 0.5 * y;
            Throw(scene, disk, {vx, vy});
        }
    }
    return scene;
}
scenes::Scene MakeGasCost() { return MakeGas(1); }

std::vector<double> MeasureGas(const RunSpec& setting, Effort effort) {
    const int runs = effort == Effort::quick ? 2 : 8;
    double change = 0.0, gain = 0.0, momentum = 0.0, angular = 0.0;
    for (int seed = 1; seed <= runs; ++seed) {
        const auto lab = MakeLab(MakeGas(static_cast<unsigned>(seed)), setting, {.restitutionThreshold = 0.0});
        const std::vector<BodyReading> bodies = ReadMoving(*lab);
        double momentumScale = 0.0, angularScale = 0.0;
        for (const BodyReading& b : bodies) {
            momentumScale += b.mass * Length(b.velocity);
            angularScale += b.mass * std::abs(Cross(b.centre, b.velocity));
        }
        DriftWatch drift(SumInvariants(bodies), momentumScale, angularScale);
        for (int i = 0; i < 5 * GetRate(setting); ++i) {
            lab->Step();
            drift.Add(SumInvariants(ReadMoving(*lab)));
        }
        change += std::abs(drift.GetEnergy() - 1.0) / runs;
        gain = std::max(gain, drift.GetGain());
        momentum = std::max(momentum, drift.GetMomentum());
        angular = std::max(angular, drift.GetAngular());
    }
    return {change, gain, momentum, angular};
}

// --- Order of convergence. A chain of three rods swings from the horizontal. Its reference is the same engine and
// solver at a 64th of the step. They are compared in windows of 0.1 s, each of which starts from the reference. The
// reference has an error of its own, by the rounding of its many small steps. Its distance from a run at a 32nd of the
// step tells how large that error is.

constexpr int orderLinks = 3;

scenes::Scene MakeTriplePendulum() {
    scenes::Scene scene = MakeEmptyScene();
    int before = AddAnchor(scene, {});
    for (int i = 0; i < orderLinks; ++i) {
        const int rod = AddDynamic(scene, {i + 0.5, 0.0}, scenes::Box(0.5, 0.05));
        Hinge(scene, before, rod, {1.0 * i, 0.0});
        before = rod;
    }
    return scene;
}

/// The scene with bodies where and as fast as a run left them.
void TakeOver(scenes::Scene& scene, const LabWorld& lab) {
    for (size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyReading b = lab.Read(static_cast<int>(i));
        scene.bodies[i].position = scenes::Point(b.origin.x, b.origin.y);
        scene.bodies[i].angle = static_cast<float>(b.angle);
        Throw(scene, static_cast<int>(i), b.velocity, b.spin);
    }
}

/// Steps a window of 0.1 s.
std::unique_ptr<LabWorld> RunWindow(const scenes::Scene& scene, const RunSpec& setting, int finer) {
    auto lab = MakeLab(scene, setting);
    const int steps = static_cast<int>(std::lround(0.1 * GetRate(setting))) * finer;
    for (int i = 0; i < steps; ++i) lab->Step(GetTimeStep(setting) / finer);
    return lab;
}

double Distance(const LabWorld& a, const LabWorld& b) {
    double sum = 0.0;
    for (int i = 0; i < a.GetBodyCount(); ++i) {
        const Point apart = a.Read(i).centre - b.Read(i).centre;
        sum += Dot(apart, apart);
    }
    return std::sqrt(sum);
}

/// The shortfall of the order from 1. An error near what the reference itself is uncertain by has no order to measure.
double Shortfall(double coarse, double fine, double uncertainty) {
    constexpr double resolved = 4.0;
    return coarse < resolved * uncertainty ? 0.0 : std::max(0.0, 1.0 - GetOrder(coarse, fine));
}

std::vector<double> MeasureOrder(const RunSpec& setting, Effort effort) {
    scenes::Scene scene = MakeTriplePendulum();
    double coarse = 0.0, fine = 0.0, uncertainty = 0.0;
    const int windows = effort == Effort::quick ? 5 : 15;
    for (int i = 0; i < windows; ++i) {
        const auto reference = RunWindow(scene, setting, 64);
        coarse += Distance(*RunWindow(scene, setting, 1), *reference);
        fine += Distance(*RunWindow(scene, setting, 2), *reference);
        uncertainty += Distance(*RunWindow(scene, setting, 32), *reference);
        TakeOver(scene, *reference);
    }
    return {coarse / windows, Shortfall(coarse, fine, uncertainty)};
}

}  // namespace

std::vector<Law> MakeMotionLaws() {
    return {
        {.name = "projectile",
         .title = "A projectile thrown with (10, 20) m/s, after 4 s",
         .exact = "at (40, 0) m with the energy of the start",
         .errors = {{.name = "miss", .unit = "m", .game = 0.34, .precise = 1e-3, .rounding = 1e-4},
                    {.name = "energy", .rounding = 1e-5}},
         .measure = MeasureProjectile,
         .costScene = MakeProjectile,
         .pitch = {10.0, 10.0}},
        {.name = "free-spin",
         .title = "A box spinning at 5, 20 and 40 rad/s, after 10 s",
         .exact = "turned by ωt",
         .errors = {{.name = "angle", .unit = "rad", .precise = 1e-3, .rounding = 1e-4},
                    {.name = "angle, relative", .game = 0.01}},
         .measure = MeasureSpin,
         .costScene = [] { return MakeSpin(20.0); },
         .pitch = {2.0, 2.0}},
        {.name = "free-chain",
         .title = "A chain of 20 links thrown and turning in zero gravity, 10 s",
         .exact = "energy, momentum and angular momentum of the start",
         .errors = {{.name = "angular momentum", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5},
                    {.name = "gain of energy", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5, .failed = exploded},
                    {.name = "momentum", .rounding = 1e-5},
                    {.name = "worst joint gap", .unit = "m", .rounding = 1e-5, .failed = tornGap}},
         .measure = MeasureFreeChain,
         .costScene = MakeFreeChain,
         .pitch = {50.0, 50.0}},
        {.name = "elastic-gas",
         .title = "64 disks of restitution 1 collide in free space, 5 s",
         .exact = "energy, momentum and angular momentum of the start",
         .errors =
             {{.name = "energy, mean", .rounding = 1e-5},
              {.name = "gain of energy, worst", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5, .failed = exploded},
              {.name = "momentum", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5},
              {.name = "angular momentum", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5}},
         .measure = MeasureGas,
         .costScene = MakeGasCost,
         .pitch = {200.0, 200.0}},
        {.name = "order",
         .title = "Three rods swing from the horizontal: windows of 0.1 s against the same solver at h/64",
         .exact = "the distance halves with the step: order 1",
         .errors = {{.name = "distance", .unit = "m", .rounding = 1e-6},
                    {.name = "shortfall of the order from 1", .game = 0.3, .precise = 0.1, .rounding = 1e-2}},
         .measure = MeasureOrder,
         .costScene = MakeTriplePendulum,
         .pitch = {10.0, 10.0}},
    };
}

}  // namespace testbed
