// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Tiny and huge bodies, and ordinary ones far from the origin.

#include <fmt/format.h>

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {
namespace {

/// A pyramid of base 5 of boxes of size s.
scenes::Scene MakeSized(double s, double g = gravity) {
    scenes::Scene scene = MakeEmptyScene(g);
    const double gap = boxGap * s;
    AddStatic(scene, {0.0, -s}, scenes::Box(20.0 * s, s), {0.0, 0.6});
    for (int r = 0; r < 5; ++r) {
        for (int i = 0; i < 5 - r; ++i) {
            AddDynamic(scene, {1.125 * s * (i - 0.5 * (4 - r)), s * (0.5 + r) + gap * (r + 1)},
                       scenes::Box(0.5 * s, 0.5 * s), {1.0, 0.6});
        }
    }
    return scene;
}

/// Ten disks and boxes of 1 cm on a ground of 1000 km.
scenes::Scene MakeCrumbs() {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 1e6, {0.0, 0.6});
    for (int i = 0; i < 10; ++i) {
        const Point at{0.02 * i - 0.1, 0.03};
        if (i % 2 == 0) {
            AddDynamic(scene, at, scenes::Circle(0.005), {1.0, 0.6});
        } else {
            AddDynamic(scene, at, scenes::Box(0.005, 0.005), {1.0, 0.6});
        }
    }
    return scene;
}

/// A box whose shape lies 15 km off its body's origin, dropped by 1 m.
scenes::Scene MakeOffset() {
    scenes::Scene scene = MakeEmptyScene();
    AddStatic(scene, {15000.0, -1.0}, scenes::Box(20.0, 1.0), {0.0, 0.6});
    AddDynamic(scene, {}, scenes::Box(0.5, 0.5, scenes::Point(15000.0, 1.5)), {1.0, 0.6});
    return scene;
}

/// A box on a floor without friction at 1 cm/s.
scenes::Scene MakeSlider() {
    scenes::Scene scene = MakeEmptyScene();
    AddStatic(scene, {0.0, -1.0}, scenes::Box(20.0, 1.0), {0.0, 0.0});
    Throw(scene, AddDynamic(scene, {0.0, 0.5 + boxGap}, scenes::Box(0.5, 0.5), {1.0, 0.0}), {0.01, 0.0});
    return scene;
}

/// Five hinged links, swung from the horizontal.
scenes::Scene MakeSwing() {
    scenes::Scene scene = MakeEmptyScene();
    int before = AddAnchor(scene, {});
    for (int i = 0; i < 5; ++i) {
        const int link = AddDynamic(scene, {i + 0.5, 0.0}, scenes::Box(0.5, 0.125));
        Hinge(scene, before, link, {double(i), 0.0});
        before = link;
    }
    return scene;
}

/// A figure of five limbs with limited hinges, dropped by 3 m.
scenes::Scene MakeFigure() {
    scenes::Scene scene = MakeEmptyScene();
    AddStatic(scene, {0.0, -1.0}, scenes::Box(20.0, 1.0), {0.0, 0.6});
    const int torso = AddDynamic(scene, {0.0, 4.0}, scenes::Box(0.25, 0.5), {1.0, 0.6});
    const auto limb = [&](Point at, Point hinge, double hx, double hy) {
        const int part = AddDynamic(scene, at, scenes::Box(hx, hy), {1.0, 0.6});
        Hinge(scene, torso, part, hinge);
        scenes::Joint& joint = scene.joints.back();
        joint.enableLimit = true;
        joint.lowerAngle = -0.8f;
        joint.upperAngle = 0.8f;
    };
    limb({0.0, 4.8}, {0.0, 4.55}, 0.2, 0.2);
    limb({-0.6, 4.3}, {-0.3, 4.3}, 0.3, 0.1);
    limb({0.6, 4.3}, {0.3, 4.3}, 0.3, 0.1);
    limb({-0.15, 3.0}, {-0.15, 3.45}, 0.1, 0.4);
    limb({0.15, 3.0}, {0.15, 3.45}, 0.1, 0.4);
    for (scenes::Fixture& fixture : scene.fixtures) fixture.groupIndex = 0;
    return scene;
}

Bounds Around(double x, double reach) { return {{x - reach, -reach}, {x + reach, reach}}; }

void AddFar(std::vector<ExtremeCase>& cases, int power) {
    const double x = power == 0 ? 0.0 : std::pow(10.0, power);
    const std::string place = power == 0 ? "at the origin" : fmt::format("1e{} m from the origin", power);
    const std::string suffix = fmt::format("-far-{}", power == 0 ? "0" : fmt::format("1e{}", power));
    cases.push_back({.name = "settle" + suffix,
                     .group = "far away",
                     .what = "a pyramid of base 5 " + place,
                     .make = [] { return MakeSized(1.0); },
                     .quickSeconds = 5.0,
                     .place = {x, 0.0},
                     .demands = {.bounds = Around(x, 15.0), .overlap = 0.02, .restSpeed = 0.05}});
    cases.push_back({.name = "slide" + suffix,
                     .group = "far away",
                     .what = "a box slides with 1 cm/s without friction " + place + ": its way",
                     .make = MakeSlider,
                     .quickSeconds = 5.0,
                     .settings = "sleeping=off",  // 1 cm/s is slow enough to fall asleep
                     .place = {x, 0.0},
                     .demands = {.bounds = Around(x, 15.0), .accuracy = 0.02},
                     .measure = [x](const LabWorld& lab, double seconds) {
                         return RelativeError(lab.Read(1).centre.x - x, 0.01 * seconds);
                     }});
    cases.push_back({.name = "chain" + suffix,
                     .group = "far away",
                     .what = "five hinged links swing " + place,
                     .make = MakeSwing,
                     .quickSeconds = 3.0,
                     .place = {x, 0.0},
                     .demands = {.bounds = Around(x, 15.0), .jointGap = 0.01}});
    cases.push_back({.name = "figure" + suffix,
                     .group = "far away",
                     .what = "a figure of five limbs falls " + place,
                     .make = MakeFigure,
                     .quickSeconds = 5.0,
                     .place = {x, 0.0},
                     .demands = {.bounds = Around(x, 15.0), .jointGap = 0.05, .restSpeed = 0.1}});
}

}  // namespace

std::vector<ExtremeCase> MakePlaceCases() {
    std::vector<ExtremeCase> cases;
    for (int power = -3; power <= 4; ++power) {
        // All lengths times s, those of gravity too: the same scene in other units.
        const double s = std::pow(10.0, power);
        cases.push_back(
            {.name = fmt::format("size-1e{}", power),
             .group = "scale",
             .what = fmt::format("a pyramid of base 5 with all lengths times {0:g} (ours: length scale {0:g})", s),
             .make = [=] { return MakeSized(s, s * gravity); },
             .quickSeconds = 5.0,
             .scale = s,
             .settings = fmt::format("lengthScale={:g}", s),
             .demands = {.bounds = Bounds{{-10.0 * s, 0.0}, {10.0 * s, 10.0 * s + 0.2}},
                         .overlap = 0.02 * s,
                         .restSpeed = 0.05 * s}});
    }
    for (const int power : {-3, -2, -1, 2, 4}) {
        const double s = std::pow(10.0, power);
        cases.push_back(
            {.name = fmt::format("size-1e{}-on-earth", power),
             .group = "scale",
             .what = fmt::format("a pyramid of base 5 of boxes of {0:g} m under 10 m/s² (ours: length scale {0:g})", s),
             .make = [=] { return MakeSized(s); },
             .quickSeconds = 5.0,
             .scale = s,
             .settings = fmt::format("lengthScale={:g}", s),
             .demands = {.bounds = Bounds{{-10.0 * s, 0.0}, {10.0 * s, 10.0 * s + 0.2}},
                         .overlap = 0.02 * s,
                         .restSpeed = 0.05 * std::max(1.0, std::sqrt(s))}});
    }
    cases.push_back(
        {.name = "crumbs",
         .group = "scale",
         .what = "bodies of 1 cm on a ground of 1000 km (ours: length scale 0.01)",
         .make = MakeCrumbs,
         .quickSeconds = 5.0,
         .scale = 0.01,
         .settings = "lengthScale=0.01",
         .demands = {.bounds = Bounds{{-1.0, 0.0}, {1.0, 0.2}}, .overlap = 0.02 * 0.01, .restSpeed = 0.05}});
    cases.push_back(
        {.name = "offset-shape",
         .group = "scale",
         .what = "a shape 15 km off its body's origin falls by 1 m",
         .make = MakeOffset,
         .quickSeconds = 5.0,
         .demands = {.bounds = Bounds{{14980.0, 0.0}, {15020.0, 3.0}}, .overlap = 0.02, .restSpeed = 0.05}});
    for (const int power : {0, 3, 4, 5, 6, 7}) AddFar(cases, power);
    return cases;
}

}  // namespace testbed
