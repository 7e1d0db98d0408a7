// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Extreme speeds, spins, time steps, gravity and materials.

#include <fmt/format.h>

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {
namespace {

/// A room of 20 × 20 m with walls of the given thickness, its floor at y = 0.
void AddRoom(scenes::Scene& scene, double thickness, const Material& material) {
    const double h = 0.5 * thickness;
    AddStatic(scene, {0.0, -h}, scenes::Box(10.0 + thickness, h), material);
    AddStatic(scene, {0.0, 20.0 + h}, scenes::Box(10.0 + thickness, h), material);
    AddStatic(scene, {-10.0 - h, 10.0}, scenes::Box(h, 10.0), material);
    AddStatic(scene, {10.0 + h, 10.0}, scenes::Box(h, 10.0), material);
}
constexpr Bounds room{{-10.05, -0.05}, {10.05, 20.05}};

/// Boxes and disks that fly about in a room of 1 mm walls.
scenes::Scene MakeFlyers(double speed) {
    scenes::Scene scene = MakeEmptyScene();
    AddRoom(scene, 1e-3, {0.0, 0.2, 0.5});
    scenes::Random random(5);
    for (int i = 0; i < 20; ++i) {
        const Point at{random.Uniform(-8.0, 8.0), random.Uniform(2.0, 18.0)};
        const auto shape = i % 2 == 0 ? scenes::Circle(0.3) : scenes::Box(0.4, 0.15);
        const int body = AddDynamic(scene, at, shape, {1.0, 0.2, 0.5});
        const double angle = random.Uniform(0.0, 2.0 * scenes::pi);
        Throw(scene, body, {speed * std::cos(angle), speed * std::sin(angle)}, random.Uniform(-5.0, 5.0));
    }
    return scene;
}

scenes::Scene MakeHeadOn(double speed) {
    scenes::Scene scene = MakeEmptyScene(0.0);
    Throw(scene, AddDynamic(scene, {-20.0, 0.0}, scenes::Box(0.5, 0.5)), {speed, 0.0});
    Throw(scene, AddDynamic(scene, {20.0, 0.1}, scenes::Box(0.5, 0.5)), {-speed, 0.0});
    return scene;
}

/// A wedge shot into the corner of two walls.
scenes::Scene MakeWedge() {
    scenes::Scene scene = MakeEmptyScene();
    AddRoom(scene, 0.1, {0.0, 0.3});
    const auto wedge = scenes::Polygon({scenes::Point(-1.0, -0.3), scenes::Point(1.0, 0.0), scenes::Point(-1.0, 0.3)});
    Throw(scene, AddDynamic(scene, {0.0, 10.0}, wedge, {1.0, 0.3}, -0.7), {700.0, -700.0});
    return scene;
}

/// A pyramid of base 5 and a chain of 5 beside it.
scenes::Scene MakeMixed(double g = gravity, double friction = 0.6, double restitution = 0.0) {
    scenes::Scene scene = MakeEmptyScene(g);
    const Material material{1.0, friction, restitution};
    AddFloor(scene, 30.0, material);
    for (int r = 0; r < 5; ++r) {
        for (int i = 0; i < 5 - r; ++i) {
            AddDynamic(scene, {1.125 * (i - 0.5 * (4 - r)), 0.5 + boxGap + (1.0 + boxGap) * r}, scenes::Box(0.5, 0.5),
                       material);
        }
    }
    int before = AddAnchor(scene, {10.0, 8.0});
    for (int i = 0; i < 5; ++i) {
        const int link = AddDynamic(scene, {10.5 + i, 8.0}, scenes::Box(0.5, 0.125), material);
        Hinge(scene, before, link, {10.0 + i, 8.0});
        before = link;
    }
    return scene;
}

scenes::Scene MakeDrops(double friction, double restitution) {
    scenes::Scene scene = MakeEmptyScene();
    AddRoom(scene, 1.0, {0.0, friction, restitution});
    for (int i = 0; i < 10; ++i) {
        const Point at{1.7 * i - 8.0, 3.0 + 0.3 * i};
        const auto shape = i % 2 == 0 ? scenes::Circle(0.5) : scenes::Box(0.5, 0.5);
        Throw(scene, AddDynamic(scene, at, shape, {1.0, friction, restitution}, 0.3 * i), {2.0, 0.0});
    }
    return scene;
}

/// Spinning boxes, free or on a floor.
scenes::Scene MakeSpinner(double spin, bool touching) {
    scenes::Scene scene = MakeEmptyScene(touching ? gravity : 0.0);
    if (touching) AddRoom(scene, 1.0, {0.0, 0.6});
    Throw(scene, AddDynamic(scene, {0.0, touching ? 2.0 : 10.0}, scenes::Box(1.0, 0.1), {1.0, 0.6}), {}, spin);
    return scene;
}

void AddSpeeds(std::vector<ExtremeCase>& cases) {
    for (const double speed : {0.0, 10.0, 100.0, 1e3, 1e4}) {
        cases.push_back({.name = fmt::format("speed-{:g}", speed),
                         .group = "speed",
                         .what = fmt::format("20 bodies of {:g} m/s in a room with walls of 1 mm", speed),
                         .make = [=] { return MakeFlyers(speed); },
                         .quickSeconds = 1.0,
                         .demands = {.bounds = room}});
    }
    cases.push_back({.name = "head-on-1e3",
                     .group = "speed",
                     .what = "two boxes meet head-on with 1000 m/s each, as bullets",
                     .make =
                         [] {
                             scenes::Scene scene = MakeHeadOn(1e3);
                             for (scenes::Body& body : scene.bodies) body.bullet = true;
                             return scene;
                         },
                     .seconds = 1.0,
                     .demands = {.accuracy = 0.5},
                     // They must not pass each other: the left one stays left.
                     .measure = [](const LabWorld& lab,
                                   double) { return lab.Read(0).centre.x < lab.Read(1).centre.x ? 0.0 : 1.0; }});
    cases.push_back({.name = "wedge-1e3",
                     .group = "speed",
                     .what = "a wedge shot into a corner with 1000 m/s",
                     .make = MakeWedge,
                     .demands = {.bounds = room}});
}

void AddSteps(std::vector<ExtremeCase>& cases) {
    const auto add = [&cases](const std::string& name, const std::string& what, std::function<double(int)> length) {
        const bool still = name == "dt-0";
        cases.push_back({.name = name,
                         .group = "time step",
                         .what = what,
                         .make = [] { return MakeMixed(); },
                         .quickSeconds = 2.5,
                         .demands = {.bounds = Bounds{{-20.0, -2.0}, {30.0, 20.0}},
                                     .overlap = still ? 0.0 : 0.02,
                                     .jointGap = still ? 0.0 : 0.01,
                                     .restSpeed = still ? 0.0 : 0.05,
                                     .restOfLoose = true},
                         .stepLength = std::move(length)});
    };
    add("dt-0", "a pyramid and a chain, steps of no length", [](int) { return 0.0; });
    for (const int rate : {1000, 240, 30, 20, 10}) {
        add(fmt::format("dt-1-{}", rate), fmt::format("a pyramid and a chain, steps of 1/{} s", rate),
            [=](int) { return 1.0 / rate; });
    }
    add("dt-jitter", "a pyramid and a chain, steps between 1/240 and 1/15 s", [](int step) {
        // A fixed scramble of the step's number: 0 … 1.
        const double share =
            static_cast<double>((static_cast<std::uint32_t>(step) * 2654435761u) >> 16 & 0xffff) / 65535.0;
        return 1.0 / 240.0 + share * (1.0 / 15.0 - 1.0 / 240.0);
    });
}

}  // namespace

std::vector<ExtremeCase> MakeMotionCases() {
    std::vector<ExtremeCase> cases;
    AddSpeeds(cases);
    AddSteps(cases);
    for (const double g : {0.0, 1e2, 1e3, 1e4}) {
        cases.push_back({.name = fmt::format("gravity-{:g}", g),
                         .group = "gravity",
                         .what = fmt::format("a pyramid and a chain under {:g} m/s²", g),
                         .make = [=] { return MakeMixed(g); },
                         .quickSeconds = 2.5,
                         .demands = {.bounds = Bounds{{-20.0, -2.0}, {30.0, 20.0}},
                                     .overlap = 0.02,
                                     .jointGap = 0.01,
                                     .restSpeed = 0.05 * std::max(1.0, std::sqrt(g / gravity)),
                                     .restOfLoose = true}});
    }
    for (const double spin : {1e2, 1e3, 1e4}) {
        for (const bool touching : {false, true}) {
            cases.push_back({.name = fmt::format("spin-{:g}{}", spin, touching ? "-touching" : ""),
                             .group = "spin",
                             .what = fmt::format("a rod of 2 m spins with {:g} rad/s{}", spin,
                                                 touching ? " and falls on a floor" : " in free space"),
                             .make = [=] { return MakeSpinner(spin, touching); },
                             .demands = {.bounds = touching ? std::optional(room) : std::nullopt}});
        }
    }
    cases.push_back({.name = "spin-1e7-steps",
                     .group = "spin",
                     .what = "a box spins with 5 rad/s for 10,000,000 steps",
                     .make = [] { return MakeSpinner(5.0, false); },
                     .seconds = 1e7 / 60.0,
                     .quickSeconds = 1e5 / 60.0,
                     .demands = {.accuracy = 1e-3},
                     .measure =
                         [](const LabWorld& lab, double) {
                             const BodyReading rod = lab.Read(0);
                             return std::max(RelativeError(rod.spin, 5.0),
                                             std::abs(std::hypot(rod.cos, rod.sin) - 1.0));
                         }});
    for (const double friction : {0.0, 1.0, 1e3}) {
        cases.push_back({.name = fmt::format("friction-{:g}", friction),
                         .group = "material",
                         .what = fmt::format("ten bodies of friction {:g} fall into a room", friction),
                         .make = [=] { return MakeDrops(friction, 0.0); },
                         .quickSeconds = 5.0,
                         .demands = {.bounds = room, .overlap = 0.02}});
    }
    for (const double restitution : {-1.0, 0.0, 1.0, 2.0}) {
        // At 2 each bounce takes half the time of the one before: energy has no bound after some 3 s.
        const bool growing = restitution > 1.0;
        cases.push_back({.name = fmt::format("restitution-{:g}", restitution),
                         .group = "material",
                         .what = fmt::format("ten bodies of restitution {:g} fall into a room{}", restitution,
                                             growing ? ", for 2.5 s" : ""),
                         .make = [=] { return MakeDrops(0.3, restitution); },
                         .seconds = growing ? 2.5 : 5.0,
                         .quickSeconds = 5.0,
                         .demands = {.energy = restitution <= 1.0, .bounds = room, .overlapShare = 0.1}});
    }
    return cases;
}

}  // namespace testbed
