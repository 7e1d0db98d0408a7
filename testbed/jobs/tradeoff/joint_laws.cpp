// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws of jointed bodies: the pendulum's period and pull, a spring's amplitude, the catenary of a bridge, the pull and
// the stretch of loaded chains.

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/tradeoff/law.h"

namespace testbed {
namespace {

// --- Rod pendulum 1 × 0.1 m on its end, released at 90°.

scenes::Scene MakePendulum() {
    scenes::Scene scene = MakeEmptyScene();
    const int anchor = AddAnchor(scene, {});
    const int rod = AddDynamic(scene, {0.5, 0.0}, scenes::Box(0.5, 0.05));
    Hinge(scene, anchor, rod, {});
    return scene;
}

std::vector<double> MeasurePendulum(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakePendulum(), setting);
    const BodyReading rod = lab->Read(1);
    const double pinInertia = rod.inertia + rod.mass * 0.25;
    const double exact = PendulumPeriod(pinInertia, rod.mass, 0.5, 0.5 * scenes::pi);
    // Half m v² of the fall turns into the pull that bends the way: m g (1 + 2 d² m / I).
    const double exactPull = rod.mass * gravity * (1.0 + 2.0 * 0.25 * rod.mass / pinInertia);
    FallingPasses passes;
    double pull = 0.0, gap = 0.0;
    for (int i = 0; passes.GetTimes().size() < 2 && i < 10 * GetRate(setting); ++i) {
        lab->Step();
        passes.Add((i + 1) * GetTimeStep(setting), lab->Read(1).angle + 0.5 * scenes::pi);
        pull = std::max(pull, Length(lab->GetJointForce(0)));
        gap = std::max(gap, JointGap(*lab, 0));
    }
    const auto& times = passes.GetTimes();
    return {times.size() < 2 ? 1.0 : RelativeError(times[1] - times[0], exact), gap, RelativeError(pull, exactPull)};
}

// --- Spring of 2 Hz without damping.

constexpr double springLength = 2.0, springStretch = 0.5, springHertz = 2.0;

scenes::Scene MakeSpringScene() {
    scenes::Scene scene = MakeEmptyScene(0.0);
    const int anchor = AddAnchor(scene, {});
    const int mass = AddDynamic(scene, {springLength + springStretch, 0.0}, scenes::Circle(0.2));
    scenes::Joint& spring =
        scenes::AddSpring(scene, anchor, mass, {}, scenes::Point(springLength + springStretch, 0.0));
    spring.length = static_cast<float>(springLength);
    spring.stiffness = scenes::MakeSpring(scenes::pi * 0.04, springHertz, 0.0).stiffness;
    return scene;
}

std::vector<double> MeasureSpring(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakeSpringScene(), setting);
    Run(*lab, setting, 1.0 / springHertz);
    const BodyReading mass = lab->Read(1);
    const double omega = 2.0 * scenes::pi * springHertz;
    return {RelativeError(std::hypot(mass.centre.x - springLength, mass.velocity.x / omega), springStretch)};
}

// --- Bridge of 40 links over 32 m.

constexpr int bridgeLinks = 40;
constexpr double bridgeSpan = 32.0;

scenes::Scene MakeBridge() {
    const Catenary exact = SolveCatenary(bridgeLinks, bridgeSpan);
    scenes::Scene scene = MakeEmptyScene();
    int before = AddAnchor(scene, {});
    Point end;
    for (const double angle : exact.angle) {
        const Point next = end + Point{std::cos(angle), std::sin(angle)};
        const int link = AddDynamic(scene, 0.5 * (end + next), scenes::Box(0.5, 0.0625), {}, angle);
        Hinge(scene, before, link, end);
        before = link;
        end = next;
    }
    Hinge(scene, before, AddAnchor(scene, {bridgeSpan, 0.0}), {bridgeSpan, 0.0});
    return scene;
}

std::vector<double> MeasureBridge(const RunSpec& setting, Effort) {
    const Catenary exact = SolveCatenary(bridgeLinks, bridgeSpan);
    const auto lab = MakeLab(MakeBridge(), setting);
    const auto damp = [&lab](double damping) {
        for (int i = 1; i <= bridgeLinks; ++i) lab->SetDamping(i, damping, damping);
    };
    damp(1.0);  // so that it comes to rest …
    Run(*lab, setting, 8.0);
    damp(0.0);  // … and then without: implicit damping takes its share of each step's gravity
    Run(*lab, setting, 2.0);
    const double weight = lab->Read(1).mass * gravity;
    const int steps = GetRate(setting) / 2;
    double pull = 0.0, sag = 0.0;
    for (int i = 0; i < steps; ++i) {
        lab->Step();
        pull += 0.5 * (Length(lab->GetJointForce(0)) + Length(lab->GetJointForce(bridgeLinks))) / weight / steps;
    }
    for (int i = 1; i <= bridgeLinks; ++i) sag = std::max(sag, -lab->Read(i).ToWorld({0.5, 0.0}).y);
    return {RelativeError(sag, exact.sag), RelativeError(pull, exact.endPull), WorstJointGap(*lab)};
}

// --- Chains of links of length 1 with `load` times a link's mass at the end, hanging or swung from the horizontal.

scenes::Scene MakeChain(int links, double load, bool swung) {
    scenes::Scene scene = MakeEmptyScene();
    const Point way = swung ? Point{1.0, 0.0} : Point{0.0, -1.0};
    int before = AddAnchor(scene, {});
    for (int i = 0; i < links; ++i) {
        const int link =
            AddDynamic(scene, (i + 0.5) * way, scenes::Box(0.5, 0.125), {}, swung ? 0.0 : -0.5 * scenes::pi);
        Hinge(scene, before, link, static_cast<double>(i) * way);
        before = link;
    }
    const double radius = 0.5, linkMass = 0.25;
    const Point end = static_cast<double>(links) * way;
    const int ball = AddDynamic(scene, end, scenes::Circle(radius), {load * linkMass / (scenes::pi * radius * radius)});
    Hinge(scene, before, ball, end);
    return scene;
}

/// Worst relative error of the joints' pulls and worst gap over the last second.
std::vector<double> MeasureHanging(const RunSpec& setting, int links, double load, double seconds) {
    const auto lab = MakeLab(MakeChain(links, load, false), setting);
    Run(*lab, setting, seconds - 1.0);
    const double weight = lab->Read(1).mass * gravity;
    double pull = 0.0, gap = 0.0;
    for (int i = 0; i < GetRate(setting); ++i) {
        lab->Step();
        gap = std::max(gap, WorstJointGap(*lab));
        for (int j = 0; j <= links; ++j) {  // joint j carries the links below it and the load
            pull = std::max(pull, RelativeError(Length(lab->GetJointForce(j)), (links - j + load) * weight));
        }
    }
    return {gap, pull};
}

double MeasureSwung(const RunSpec& setting, int links, double load) {
    const auto lab = MakeLab(MakeChain(links, load, true), setting);
    double gap = 0.0;
    for (int i = 0; i < 3 * GetRate(setting); ++i) {
        lab->Step();
        gap = std::max(gap, WorstJointGap(*lab));
    }
    return gap;
}

std::vector<double> MeasureChain100(const RunSpec& setting, Effort) {
    const std::vector<double> hanging = MeasureHanging(setting, 10, 100.0, 10.0);
    return {MeasureSwung(setting, 10, 100.0), hanging[0], hanging[1]};
}

std::vector<double> MeasureChain1000(const RunSpec& setting, Effort) {
    const std::vector<double> hanging = MeasureHanging(setting, 20, 1000.0, 10.0);
    return {MeasureSwung(setting, 20, 1000.0), hanging[0], hanging[1]};
}

}  // namespace

std::vector<Law> MakeJointLaws() {
    return {
        {.name = "pendulum",
         .title = "A rod of 1 × 0.1 m swings on its end from 90°",
         .exact = "period 4√(I/(mgd))·K(sin 45°) = 1.91727 s, pull at the bottom 2.49626 weights",
         .errors = {{.name = "first period, relative", .game = 1e-2, .precise = 1e-3, .rounding = 1e-5},
                    {.name = "gap of the pin",
                     .unit = "m",
                     .game = 1e-3,
                     .precise = 1e-4,
                     .rounding = 1e-6,
                     .failed = tornGap},
                    {.name = "pull at the bottom, relative", .rounding = 1e-4}},
         .measure = MeasurePendulum,
         .costScene = MakePendulum,
         .pitch = {4.0, 4.0}},
        {.name = "spring",
         .title = "A spring of 2 Hz without damping, one period",
         .exact = "the amplitude of the start",
         .errors = {{.name = "amplitude, relative", .game = 0.5, .precise = 0.02, .rounding = 1e-5}},
         .measure = MeasureSpring,
         .costScene = MakeSpringScene,
         .pitch = {5.0, 2.0}},
        {.name = "bridge",
         .title = "A bridge of 40 links hangs over 32 m",
         .exact = "discrete catenary: sag 10.6210 m, pull at the ends 24.1443 weights of a link",
         .errors = {{.name = "sag, relative", .game = 1e-2, .precise = 1e-3, .rounding = 1e-6},
                    {.name = "pull at the ends, relative", .game = 5e-2, .precise = 1e-2, .rounding = 1e-4},
                    {.name = "worst joint gap", .unit = "m", .rounding = 1e-5, .failed = tornGap}},
         .measure = MeasureBridge,
         .costScene = MakeBridge,
         .pitch = {60.0, 30.0}},
        {.name = "chain-100",
         .title = "A chain of 10 links with 100 times a link's mass at its end, swung from the horizontal and hanging",
         .exact = "no joint opens; joint j carries (N + 1 − j + R) weights",
         .errors = {{.name = "peak gap, swung",
                     .unit = "m",
                     .game = 1e-2,
                     .precise = 1e-3,
                     .rounding = 1e-5,
                     .failed = tornGap},
                    {.name = "gap, hanging 10 s",
                     .unit = "m",
                     .game = 1e-2,
                     .precise = 1e-3,
                     .rounding = 1e-5,
                     .failed = tornGap},
                    {.name = "worst pull, hanging 10 s, relative", .rounding = 1e-4}},
         .measure = MeasureChain100,
         .costScene = [] { return MakeChain(10, 100.0, true); },
         .pitch = {40.0, 40.0}},
        {.name = "chain-1000",
         .title = "A chain of 20 links with 1000 times a link's mass at its end, swung from the horizontal and hanging",
         .exact = "no joint opens; joint j carries (N + 1 − j + R) weights",
         .errors = {{.name = "peak gap, swung", .unit = "m", .precise = 1e-3, .rounding = 1e-5, .failed = tornGap},
                    {.name = "gap, hanging 10 s", .unit = "m", .precise = 1e-3, .rounding = 1e-5, .failed = tornGap},
                    {.name = "worst pull, hanging 10 s, relative", .rounding = 1e-4}},
         .measure = MeasureChain1000,
         .costScene = [] { return MakeChain(20, 1000.0, true); },
         .pitch = {60.0, 60.0}},
    };
}

}  // namespace testbed
