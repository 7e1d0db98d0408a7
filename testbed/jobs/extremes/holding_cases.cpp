// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What joints must hold, and what must keep its energy or momentum: loads on chains and bridges, changing time steps,
// nets, rings, figures, cars, cradles, gases and rows of dominoes.

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "testbed/engines/law_scenes.h"
#include "testbed/engines/measure.h"
#include "testbed/jobs/extremes/extreme_case.h"
#include "testbed/jobs/extremes/run_case.h"

namespace testbed {
namespace {

constexpr double linkLength = 0.5, linkWidth = 0.12;

/// Parts of one group never collide: this is about joints.
void Ungroup(scenes::Scene& scene) {
    for (scenes::Fixture& fixture : scene.fixtures) fixture.groupIndex = -1;
}

/// A chain in a direction, with a disk of `load` times a link's mass at its end.
scenes::Scene MakeChain(int links, double load, double angle) {
    scenes::Scene scene = MakeEmptyScene();
    const Point along{std::cos(angle), std::sin(angle)};
    int before = AddAnchor(scene, {});
    for (int i = 0; i < links; ++i) {
        const int link = AddDynamic(scene, (linkLength * (i + 0.5)) * along,
                                    scenes::Box(0.5 * linkLength, 0.5 * linkWidth), {}, angle);
        Hinge(scene, before, link, (linkLength * i) * along);
        before = link;
    }
    const Point end = (linkLength * links) * along;
    const double density = load * linkLength * linkWidth / (scenes::pi * 0.25);
    const int ball = AddDynamic(scene, end, scenes::Circle(0.5), {density});
    Hinge(scene, before, ball, end);
    Ungroup(scene);
    return scene;
}

/// A bridge without slack and a box of `load` times a plank's mass that falls on it.
scenes::Scene MakeBridge(int planks, double load) {
    scenes::Scene scene = MakeEmptyScene();
    int before = AddAnchor(scene, {});
    const Material wood{1.0, 0.6};
    for (int i = 0; i < planks; ++i) {
        const int plank = AddDynamic(scene, {0.5 * (i + 0.5), 0.0}, scenes::Box(0.25, 0.0625), wood);
        Hinge(scene, before, plank, {0.5 * i, 0.0});
        before = plank;
    }
    Hinge(scene, before, AddAnchor(scene, {0.5 * planks, 0.0}), {0.5 * planks, 0.0});
    AddDynamic(scene, {0.25 * planks, 1.0}, scenes::Box(0.75, 0.5), {load * 0.5 * 0.125 / 1.5, 0.6});
    return scene;
}

/// 1 if the load, the last body, is below a plank in its middle.
double HasGoneThrough(const LabWorld& lab, double /*seconds*/) {
    const int load = lab.GetBodyCount() - 1;
    const Point at = lab.Read(load).origin;
    for (int i = 1; i < load - 1; ++i) {
        const Point plank = lab.Read(i).origin;
        if (std::abs(plank.x - at.x) < 0.5 && plank.y > at.y) return 1.0;
    }
    return 0.0;
}

/// n × n balls hinged to their neighbours by rigid arms, hung on the top row: at rest as it is made.
scenes::Scene MakeNet(int n) {
    scenes::Scene scene = MakeEmptyScene();
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const Point at{1.0 * x, -1.0 * y};
            const int body = y == 0 ? AddAnchor(scene, at) : AddDynamic(scene, at, scenes::Circle(0.25));
            if (x > 0 && y > 0) Hinge(scene, body - 1, body, {x - 0.5, at.y});
            if (y > 0) Hinge(scene, body - n, body, {at.x, at.y + 0.5});
        }
    }
    Ungroup(scene);
    return scene;
}

constexpr double ringSpin = 8.0, ringRadius = 1.5;  ///< rad/s, m
constexpr int ringBars = 10;

/// A closed ring of bars that spins in free space.
scenes::Scene MakeRing() {
    scenes::Scene scene = MakeEmptyScene(0.0);
    const double half = ringRadius * std::sin(scenes::pi / ringBars),
                 inner = ringRadius * std::cos(scenes::pi / ringBars);
    for (int i = 0; i < ringBars; ++i) {
        const double at = 2.0 * scenes::pi * (i + 0.5) / ringBars;
        const Point c{inner * std::cos(at), inner * std::sin(at)};
        Throw(scene, AddDynamic(scene, c, scenes::Box(half, 0.08), {}, at + 0.5 * scenes::pi),
              {-ringSpin * c.y, ringSpin * c.x}, ringSpin);
    }
    for (int i = 0; i < ringBars; ++i) {
        const double at = 2.0 * scenes::pi * (i + 1) / ringBars;
        Hinge(scene, i, (i + 1) % ringBars, {ringRadius * std::cos(at), ringRadius * std::sin(at)});
    }
    Ungroup(scene);
    return scene;
}

/// Figures of nine limbs with limited hinges, let fall on a floor in all attitudes.
scenes::Scene MakeFigures(double height) {
    scenes::Scene scene = MakeEmptyScene();
    AddStatic(scene, {0.0, -1.0}, scenes::Box(60.0, 1.0), {0.0, 0.6});
    scenes::Random random(11);
    for (int figure = 0; figure < 12; ++figure) {
        const Point middle{6.0 * figure - 33.0, height + 1.2};
        const double turn = random.Uniform(0.0, 2.0 * scenes::pi);
        const auto place = [&](Point p) {
            return middle +
                   Point{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)};
        };
        const auto limb = [&](int parent, Point at, Point hinge, double hx, double hy) {
            const int part = AddDynamic(scene, place(at), scenes::Box(hx, hy), {1.0, 0.6}, turn);
            if (parent < 0) return part;
            Hinge(scene, parent, part, place(hinge));
            scenes::Joint& joint = scene.joints.back();
            joint.enableLimit = true;
            joint.lowerAngle = -0.7f, joint.upperAngle = 0.7f;
            return part;
        };
        const int torso = limb(-1, {}, {}, 0.18, 0.35);
        limb(torso, {0.0, 0.52}, {0.0, 0.36}, 0.14, 0.14);
        for (const double side : {-1.0, 1.0}) {
            const int arm = limb(torso, {0.4 * side, 0.27}, {0.18 * side, 0.27}, 0.2, 0.07);
            limb(arm, {0.78 * side, 0.27}, {0.59 * side, 0.27}, 0.18, 0.06);
            const int leg = limb(torso, {0.11 * side, -0.62}, {0.11 * side, -0.36}, 0.08, 0.25);
            limb(leg, {0.11 * side, -1.1}, {0.11 * side, -0.86}, 0.07, 0.23);
        }
        for (size_t i = scene.fixtures.size() - 10; i < scene.fixtures.size(); ++i) {
            scene.fixtures[i].groupIndex = static_cast<std::int16_t>(-1 - figure);
        }
    }
    return scene;
}

/// A car on sprung wheels, driven over bumps of 0.3 m.
scenes::Scene MakeCar() {
    scenes::Scene scene = MakeEmptyScene();
    std::vector<scenes::Vec2> surface;
    for (int i = 400; i >= -40; --i) {  // a chain collides on its right
        const double x = 0.25 * i;
        surface.push_back(scenes::Point(x, x > 2.0 ? 0.15 * (1.0 - std::cos(1.5 * (x - 2.0))) : 0.0));
    }
    scenes::AddBody(scene, scenes::BodyType::isStatic, {});
    AddPart(scene, scenes::Chain(scene, surface), {0.0, 0.9});
    const int chassis = AddDynamic(scene, {0.0, 0.9}, scenes::Box(1.3, 0.25), {1.0, 0.3});
    for (const double side : {-1.0, 1.0}) {
        const Point axle{0.9 * side, 0.4};
        const int wheel = AddDynamic(scene, axle, scenes::Circle(0.4), {1.0, 0.9});
        scenes::Joint& joint =
            scenes::AddWheel(scene, chassis, wheel, scenes::Point(axle.x, axle.y), scenes::Point(0.0, 1.0));
        const scenes::Spring spring = scenes::MakeSpring(1.3, 4.0, 0.7);
        joint.stiffness = spring.stiffness, joint.damping = spring.damping;
        joint.enableMotor = true;
        joint.motorSpeed = -20.0f, joint.maxMotorTorque = 10.0f;
    }
    return scene;
}

/// How far a wheel is off its line, m.
double FindAxleError(const LabWorld& lab) {
    double worst = 0.0;
    for (const scenes::Joint& j : lab.GetScene().joints) {
        const BodyReading a = lab.Read(j.bodyA), b = lab.Read(j.bodyB);
        const Point off = b.ToWorld({double{j.localAnchorB.x}, double{j.localAnchorB.y}}) -
                          a.ToWorld({double{j.localAnchorA.x}, double{j.localAnchorA.y}});
        worst = std::max(worst, std::abs(a.cos * off.x + a.sin * off.y));
    }
    return worst;
}

constexpr double cradleLength = 2.0, cradleLift = 0.5, cradleRadius = 0.25;
constexpr int cradleBalls = 5;

/// Balls on rods that just touch; the first is lifted.
scenes::Scene MakeCradle() {
    scenes::Scene scene = MakeEmptyScene();
    AddAnchor(scene, {});
    for (int i = 0; i < cradleBalls; ++i) {
        const double x = 2.0 * cradleRadius * i, angle = i == 0 ? -cradleLift : 0.0;
        const Point at{x + cradleLength * std::sin(angle), -cradleLength * std::cos(angle)};
        const int ball = AddDynamic(scene, at, scenes::Circle(cradleRadius), {1.0, 0.0, 1.0});
        scenes::AddDistance(scene, 0, ball, scenes::Point(x, 0.0), scenes::Point(at.x, at.y));
    }
    return scene;
}

/// 121 disks that fly about in a room without loss.
scenes::Scene MakeGas() {
    scenes::Scene scene = MakeEmptyScene(0.0);
    const Material elastic{1.0, 0.0, 1.0};
    for (const double side : {-1.0, 1.0}) {
        AddStatic(scene, {7.0 * side, 0.0}, scenes::Box(1.0, 8.0), elastic);
        AddStatic(scene, {0.0, 7.0 * side}, scenes::Box(8.0, 1.0), elastic);
    }
    scenes::Random random(3);
    for (int i = 0; i < 121; ++i) {
        const int disk =
            AddDynamic(scene, {i % 11 - 5.0, static_cast<double>(i / 11) - 5.0}, scenes::Circle(0.25), elastic);
        Throw(scene, disk, {random.Uniform(-5.0, 5.0), random.Uniform(-5.0, 5.0)});
    }
    return scene;
}

constexpr double dominoThickness = 0.12, dominoTilt = 0.1;  ///< m, rad
constexpr int dominoes = 40, waveFrom = 15, waveTo = 35;    ///< where the wave is timed: it has its final speed there

scenes::Scene MakeDominoes(double spacing) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 60.0, {0.0, 0.4});
    for (int i = 0; i < dominoes; ++i) {
        AddDynamic(scene, {spacing * i, 0.5}, scenes::Box(0.5 * dominoThickness, 0.5), {1.0, 0.4});
    }
    Throw(scene, 1, {0.75, 0.0}, -1.5);
    return scene;
}

/// What a case collects while it runs; it begins anew with each run.
template <class State>
struct Collector {
    std::shared_ptr<State> state = std::make_shared<State>();
    /// visit(lab, state, step) before each step.
    template <class Visit>
    std::function<void(LabWorld&, int)> Watch(Visit visit) const {
        return [kept = state, visit](LabWorld& lab, int step) {
            if (step == 0) *kept = State{};
            visit(lab, *kept, step);
        };
    }
    /// finish(lab, state) at the end.
    template <class Finish>
    std::function<double(const LabWorld&, double)> End(Finish finish) const {
        return [kept = state, finish](const LabWorld& lab, double) { return finish(lab, *kept); };
    }
};

/// A fixed scramble of a step's number: 1/240 … 1/20 s.
double JitteredStep(int step) {
    const double share = static_cast<double>((static_cast<std::uint32_t>(step) * 2654435761u) >> 16 & 0xffff) / 65535.0;
    return 1.0 / (20.0 + 220.0 * share);
}

void AddLoads(std::vector<ExtremeCase>& cases) {
    struct Load {
        const char* name;
        int links;
        double load, angle;
    };
    const double down = -0.5 * scenes::pi;
    for (const Load& one :
         {Load{"crane-500", 12, 500.0, down}, Load{"hang-12-1e3", 12, 1e3, down}, Load{"hang-12-1e4", 12, 1e4, down},
          Load{"swing-12-1e2", 12, 1e2, 0.0}, Load{"swing-12-1e3", 12, 1e3, 0.0}, Load{"swing-12-1e4", 12, 1e4, 0.0}}) {
        cases.push_back({.name = one.name,
                         .group = "loads",
                         .what = fmt::format("a chain of {} links with {:g} times a link's mass, let go {}", one.links,
                                             one.load, one.angle == 0.0 ? "from the horizontal" : "hanging"),
                         .make = [=] { return MakeChain(one.links, one.load, one.angle); },
                         .quickSeconds = 2.0,
                         .demands = {.jointGap = 1e-3}});
    }
    for (const auto& [planks, load] : {std::pair{60, 300.0}, {25, 300.0}, {25, 3000.0}}) {
        cases.push_back(
            {.name = fmt::format("bridge-{}-{:g}", planks, load),
             .group = "loads",
             .what = fmt::format("a taut bridge of {} planks under {:g} times a plank's mass: has gone through", planks,
                                 load),
             .make = [=] { return MakeBridge(planks, load); },
             .quickSeconds = 2.0,
             .demands = {.jointGap = 1e-3, .accuracy = 0.5},
             .measure = HasGoneThrough});
    }
    cases.push_back({.name = "jitter-chain-18-160",
                     .group = "loads",
                     .what = "a chain of 18 links with 160 times a link's mass, steps of 1/240 to 1/20 s",
                     .make = [] { return MakeChain(18, 160.0, -0.8); },
                     .quickSeconds = 2.0,
                     .demands = {.jointGap = 1e-3},
                     .stepLength = JitteredStep});
    cases.push_back({.name = "chain-8-heavy-gravity",
                     .group = "loads",
                     .what = "a chain of 8 links under 1000 m/s², swung from the horizontal",
                     .make =
                         [] {
                             scenes::Scene scene = MakeChain(8, 1.0, 0.0);
                             scene.gravity = scenes::Point(0.0, -1000.0);
                             return scene;
                         },
                     .quickSeconds = 2.0,
                     .demands = {.jointGap = 1e-2}});
}

void AddLoops(std::vector<ExtremeCase>& cases) {
    for (const int n : {5, 12, 25}) {
        cases.push_back({.name = fmt::format("net-{}", n),
                         .group = "loops",
                         .what = fmt::format("a net of {0} × {0} hinged balls hangs at rest", n),
                         .make = [=] { return MakeNet(n); },
                         .quickSeconds = n > 12 ? 0.5 : 5.0,
                         .demands = {.jointGap = 1e-3, .restSpeed = 0.05}});
    }
    const Collector<double> angular;
    cases.push_back({.name = "ring-10-spun",
                     .group = "loops",
                     .what = "a ring of ten bars spun at 8 rad/s for 10 s: loss of angular momentum",
                     .make = MakeRing,
                     .seconds = 10.0,
                     .quickSeconds = 10.0,
                     .settings = "sleeping=off",
                     .demands = {.jointGap = 0.01, .accuracy = 0.02},
                     .disturb = angular.Watch([](LabWorld& lab, double& start, int step) {
                         if (step == 0) start = SumInvariants(ReadAll(lab)).angular;
                     }),
                     .measure = angular.End([](const LabWorld& lab, double start) {
                         return RelativeError(SumInvariants(ReadAll(lab)).angular, start);
                     })});
}

void AddMachines(std::vector<ExtremeCase>& cases) {
    for (const auto& [height, gap] : {std::pair{1.0, 0.085}, {6.0, 0.148}, {25.0, 0.242}}) {
        cases.push_back({.name = fmt::format("figures-{:g}m", height),
                         .group = "machines",
                         .what = fmt::format("twelve figures fall by {:g} m", height),
                         .make = [height = height] { return MakeFigures(height); },
                         .quickSeconds = 3.0,
                         .demands = {.jointGap = gap}});
    }
    const Collector<double> axle;
    cases.push_back(
        {.name = "car-bumps",
         .group = "machines",
         .what = "a car drives over bumps: a wheel off its line by, m",
         .make = MakeCar,
         .seconds = 6.0,
         .quickSeconds = 3.0,
         .demands = {.energy = false, .accuracy = 1e-3},
         .disturb = axle.Watch([](LabWorld& lab, double& worst, int) { worst = std::max(worst, FindAxleError(lab)); }),
         .measure = axle.End([](const LabWorld&, double worst) { return worst; })});
    const Collector<double> swing;
    cases.push_back({.name = "cradle",
                     .group = "machines",
                     .what = "a cradle of five balls that touch: what the last one's first swing lacks",
                     .make = MakeCradle,
                     .seconds = 2.0,
                     .quickSeconds = 2.0,
                     .settings = "sleeping=off",
                     .restitutionThreshold = 0.0,
                     .demands = {.accuracy = 0.1},
                     .disturb = swing.Watch([](LabWorld& lab, double& most, int) {
                         const Point c = lab.Read(cradleBalls).centre;
                         most = std::max(most, std::atan2(c.x - 2.0 * cradleRadius * (cradleBalls - 1), -c.y));
                     }),
                     .measure = swing.End([](const LabWorld&, double most) { return 1.0 - most / cradleLift; })});
    const Collector<double> energy;
    const auto sum = [](const LabWorld& lab) { return SumInvariants(ReadAll(lab)).kinetic; };
    cases.push_back(
        {.name = "gas",
         .group = "machines",
         .what = "a gas of 121 elastic disks, 10,000 steps: drift of energy",
         .make = MakeGas,
         .seconds = 1e4 / 60.0,
         .quickSeconds = 10.0,
         .restitutionThreshold = 0.0,
         .demands = {.accuracy = 0.05},
         .disturb = energy.Watch([=](LabWorld& lab, double& start, int step) {
             if (step == 0) start = sum(lab);
         }),
         .measure = energy.End([=](const LabWorld& lab, double start) { return RelativeError(sum(lab), start); })});
}

void AddDominoes(std::vector<ExtremeCase>& cases) {
    struct Wave {
        double from = 0.0, to = 0.0;            ///< steps after which the dominoes that time the wave tilt
        double fromAngle = 0.0, toAngle = 0.0;  ///< of these dominoes a step ago, rad
    };
    struct Row {
        double spacing, speed;  ///< m, m/s
    };
    // To these both Box2D 2.4.1 and 3 and this engine's sequential impulses come with steps of 1/1920 s.
    for (const Row row : {Row{0.3, 3.8}, Row{0.5, 3.6}, Row{0.75, 3.25}}) {
        const Collector<Wave> wave;
        cases.push_back({.name = fmt::format("dominoes-{:g}", row.spacing),
                         .group = "machines",
                         .what = fmt::format("dominoes {:g} m apart: error of the wave's speed", row.spacing),
                         .make = [=] { return MakeDominoes(row.spacing); },
                         .seconds = 12.0,
                         .quickSeconds = 12.0,
                         .settings = "timeStep=1/60",
                         .demands = {.accuracy = 0.03},
                         .disturb = wave.Watch([](LabWorld& lab, Wave& w, int step) {
                             const auto pass = [&](int domino, double& last, double& time) {
                                 const double now = lab.Read(1 + domino).angle;  // body 0 is the floor
                                 if (time == 0.0 && now < -dominoTilt) time = step - (now + dominoTilt) / (now - last);
                                 last = now;
                             };
                             pass(waveFrom, w.fromAngle, w.from);
                             pass(waveTo, w.toAngle, w.to);
                         }),
                         .measure = wave.End([=](const LabWorld&, const Wave& w) {
                             const double seconds = (w.to - w.from) / 60.0;
                             return w.to == 0.0 ? 1.0
                                                : RelativeError(row.spacing * (waveTo - waveFrom) / seconds, row.speed);
                         })});
    }
}

}  // namespace

std::vector<ExtremeCase> MakeHoldingCases() {
    std::vector<ExtremeCase> cases;
    AddLoads(cases);
    AddLoops(cases);
    AddMachines(cases);
    AddDominoes(cases);
    return cases;
}

}  // namespace testbed
