// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Piles of extreme mass ratios, heights, overlaps and loads.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {
namespace {

scenes::Scene MakeFloored(double halfWidth, const Material& material = {0.0, 0.6}) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, halfWidth, material);
    return scene;
}

/// `lower` boxes of mass 1 below or above a box of mass `ratio`.
scenes::Scene MakeMassRatio(double ratio, bool heavyOnTop) {
    scenes::Scene scene = MakeFloored(20.0);
    for (int i = 0; i < 2; ++i) {
        const bool heavy = heavyOnTop == (i == 1);
        AddDynamic(scene, {0.0, 0.5 + boxGap + (1.0 + boxGap) * i}, scenes::Box(0.5, 0.5), {heavy ? ratio : 1.0, 0.6});
    }
    return scene;
}

scenes::Scene MakeStack(int count) {
    scenes::Scene scene = MakeFloored(40.0);
    for (int i = 0; i < count; ++i) {
        AddDynamic(scene, {0.0, 0.5 + boxGap + (1.0 + boxGap) * i}, scenes::Box(0.5, 0.5), {1.0, 0.6});
    }
    return scene;
}

scenes::Scene MakePyramid(int base) {
    scenes::Scene scene = MakeFloored(base + 20.0);
    for (int r = 0; r < base; ++r) {
        for (int i = 0; i < base - r; ++i) {
            AddDynamic(scene, {1.125 * (i - 0.5 * (base - r - 1)), 0.5 + boxGap + (1.0 + boxGap) * r},
                       scenes::Box(0.5, 0.5), {1.0, 0.6});
        }
    }
    return scene;
}

/// Cards of 1 mm × 20 cm that lean on each other in pairs, with flat ones on top.
scenes::Scene MakeCardHouse() {
    scenes::Scene scene = MakeFloored(3.0, {0.0, 1.0});
    const Material card{100.0, 1.0};
    const double half = 0.1, lean = 0.3, rise = half * std::cos(lean), reach = half * std::sin(lean);
    for (int level = 0; level < 3; ++level) {
        const double bottom = skin + level * (2.0 * rise + 2.0 * boxGap);
        for (int pair = 0; pair < 3 - level; ++pair) {
            const double x = (pair - 0.5 * (2 - level)) * (4.0 * reach + 4.0 * skin);
            const double apart = reach + skin;
            AddDynamic(scene, {x - apart, bottom + rise}, scenes::Box(5e-4, half), card, -lean);
            AddDynamic(scene, {x + apart, bottom + rise}, scenes::Box(5e-4, half), card, lean);
            if (pair > 0) {
                AddDynamic(scene, {x - 2.0 * reach - 2.0 * skin, bottom + 2.0 * rise + boxGap}, scenes::Box(half, 5e-4),
                           card);
            }
        }
    }
    return scene;
}

scenes::Scene MakeOnePoint(int count) {
    scenes::Scene scene = MakeFloored(200.0);
    for (int i = 0; i < count; ++i) AddDynamic(scene, {0.0, 40.0}, scenes::Box(0.25, 0.25), {1.0, 0.3});
    return scene;
}

/// A pyramid of boxes that overlap their neighbours by a share of their size.
scenes::Scene MakeOverlapped(double share) {
    scenes::Scene scene = MakeFloored(100.0);
    const double pitch = 1.0 - share;
    for (int r = 0; r < 8; ++r) {
        for (int i = 0; i < 8; ++i) {
            AddDynamic(scene, {(i - 3.5) * pitch, 0.5 + boxGap + r * pitch}, scenes::Box(0.5, 0.5), {1.0, 0.3});
        }
    }
    return scene;
}

/// A column of five in a shaft with rigid walls, so that nothing can give way to the side.
scenes::Scene MakeShaft() {
    scenes::Scene scene = MakeStack(5);
    for (const double side : {-1.0, 1.0}) AddStatic(scene, {side * 1.05, 10.0}, scenes::Box(0.5, 10.0), {0.0, 0.3});
    return scene;
}

/// Presses the top box of the column down for two seconds.
void Press(LabWorld& lab, int step, double force) {
    if (step < 120) lab.ApplyForce(5, {0.0, -force});  // body 0 is the floor
}

/// A box on a floor of many short edges: as many pairs on one body.
scenes::Scene MakeManyPairs(int count) {
    scenes::Scene scene = MakeEmptyScene();
    scenes::AddBody(scene, scenes::BodyType::isStatic, {});
    const double length = 0.01;
    for (int i = 0; i < count; ++i) {
        const double x = (i - 0.5 * count) * length;
        AddPart(scene, scenes::Edge(scenes::Point(x, 0.0), scenes::Point(x + length, 0.0)), {0.0, 0.6});
    }
    AddDynamic(scene, {0.0, 1.0 + boxGap}, scenes::Box(0.5 * count * length, 1.0), {1.0, 0.6});
    return scene;
}

/// How far the upper box is from where it lies on the lower one, m: one that has gone through overlaps nothing.
double MeasureSunk(const LabWorld& lab, double /*seconds*/) {
    return std::max(0.0, 1.5 - double{lab.Read(2).origin.y});  // body 0 is the floor
}

void AddRatios(std::vector<ExtremeCase>& cases) {
    for (const int power : {0, 2, 3, 4, 6}) {
        const double ratio = std::pow(10.0, power);
        for (const bool heavyOnTop : {false, true}) {
            cases.push_back({.name = fmt::format("{}-1e{}", heavyOnTop ? "heavy-on-light" : "light-on-heavy", power),
                             .group = "mass ratio",
                             .what = fmt::format("a box {} one of {:g} times its mass: the upper one sunk by, m",
                                                 heavyOnTop ? "below" : "on", ratio),
                             .make = [=] { return MakeMassRatio(ratio, heavyOnTop); },
                             .quickSeconds = 5.0,
                             .demands = {.bounds = Bounds{{-10.0, -1.0}, {10.0, 20.0}},
                                         .overlap = 0.02,
                                         .restSpeed = 0.05,
                                         .accuracy = 0.04},
                             .measure = MeasureSunk});
        }
    }
}

}  // namespace

std::vector<ExtremeCase> MakePileCases() {
    std::vector<ExtremeCase> cases;
    AddRatios(cases);
    for (const int count : {10, 50, 100, 200, 500}) {
        cases.push_back(
            {.name = fmt::format("column-{}", count),
             .group = "columns and pyramids",
             .what = fmt::format("a single column of {} boxes", count),
             .make = [=] { return MakeStack(count); },
             .quickSeconds = 2.5,
             .demands = {.bounds = Bounds{{-2.0, 0.0}, {2.0, 1.1 * count}}, .overlap = 0.02, .restSpeed = 0.05}});
    }
    for (const int base : {10, 50, 100, 200}) {
        cases.push_back(
            {.name = fmt::format("pyramid-{}", base),
             .group = "columns and pyramids",
             .what = fmt::format("a pyramid of base {}", base),
             .make = [=] { return MakePyramid(base); },
             .demands = {
                 .bounds = Bounds{{-1.5 * base, 0.0}, {1.5 * base, 1.2 * base}}, .overlap = 0.02, .restSpeed = 0.05}});
    }
    cases.push_back(
        {.name = "card-house",
         .group = "columns and pyramids",
         .what = "a house of cards of 1 mm × 20 cm",
         .make = MakeCardHouse,
         .scale = 0.1,
         .demands = {
             .bounds = Bounds{{-3.0, -0.01}, {3.0, 2.0}}, .overlapShare = 0.0, .overlap = 0.02, .restSpeed = 0.05}});
    for (const int count : {10, 100, 1000}) {
        cases.push_back({.name = fmt::format("one-point-{}", count),
                         .group = "overlap",
                         .what = fmt::format("{} boxes made on one point", count),
                         .make = [=] { return MakeOnePoint(count); },
                         .scale = 0.5,
                         .demands = {.energy = false,
                                     .bounds = Bounds{{-200.0, 0.0}, {200.0, 200.0}},
                                     .overlapShare = count < 1000 ? 0.1 : 0.0,
                                     .maxSpeed = 100.0}});
    }
    for (const int percent : {25, 99}) {
        cases.push_back(
            {.name = fmt::format("overlap-{}", percent),
             .group = "overlap",
             .what = fmt::format("64 boxes that overlap by {} % at the start", percent),
             .make = [=] { return MakeOverlapped(0.01 * percent); },
             .quickSeconds = 5.0,
             .demands = {.energy = false, .bounds = Bounds{{-100.0, 0.0}, {100.0, 60.0}}, .maxSpeed = 60.0}});
    }
    for (const double force : {1e3, 1e5, 1e7}) {
        cases.push_back({.name = fmt::format("press-1e{:.0f}", std::log10(force)),
                         .group = "load",
                         .what = fmt::format("five boxes in a shaft pressed with {:g} N for 2 s, then let go", force),
                         .make = MakeShaft,
                         .seconds = 7.0,
                         .quickSeconds = 5.0,
                         .demands = {.energy = false,
                                     .bounds = Bounds{{-0.5, 0.0}, {0.5, 30.0}},
                                     .restSpeed = 0.05,
                                     .maxSpeed = 30.0},
                         .disturb = [=](LabWorld& lab, int step) { Press(lab, step, force); }});
    }
    cases.push_back({.name = "pairs-1e5",
                     .group = "load",
                     .what = "one body on 100,000 edges",
                     .make = [] { return MakeManyPairs(100000); },
                     .seconds = 0.5,
                     .quickSeconds = 0.2,
                     .demands = {.bounds = Bounds{{-2.0, 0.0}, {2.0, 2.0}}, .overlap = 0.02}});
    return cases;
}

}  // namespace testbed
