// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is built flush, piece on piece without gaps, as people build: pyramids, columns, card houses, arches, heaps. All
// of it must stand where it was built and come to rest.

#include <fmt/format.h>

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/extremes/extreme_case.h"

namespace testbed {
namespace {

constexpr double mustSleep = 1e-9;  ///< m/s: only what sleeps is so slow

scenes::Scene MakeFloored(double halfWidth, double friction = 0.6) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, halfWidth, {0.0, friction});
    return scene;
}

/// The largest way to the side since the start, m.
double FindShift(const LabWorld& lab, double) {
    double shift = 0.0;
    for (int i = 0; i < lab.GetBodyCount(); ++i) {
        const double start = double{lab.GetScene().bodies[static_cast<size_t>(i)].position.x};
        shift = std::max(shift, std::abs(lab.Read(i).origin.x - start));
    }
    return shift;
}

/// 0 if the highest body of the start has sunk by less than a tenth of its height, else 1: an error of outcome.
double HasFallen(const LabWorld& lab, double) {
    int highest = 0;
    const auto& bodies = lab.GetScene().bodies;
    for (int i = 0; i < lab.GetBodyCount(); ++i) {
        if (bodies[static_cast<size_t>(i)].position.y > bodies[static_cast<size_t>(highest)].position.y) highest = i;
    }
    return lab.Read(highest).origin.y > 0.9 * double{bodies[static_cast<size_t>(highest)].position.y} ? 0.0 : 1.0;
}

constexpr double brickHeight = 0.8;

/// Bricks of 1 × 0.8 m, 8 cm apart in their rows; each is this much lower than where it just touches, m.
scenes::Scene MakePyramid(int rows, double squeeze = 0.0) {
    scenes::Scene scene = MakeFloored(rows + 20.0);
    for (int r = 0; r < rows; ++r) {
        for (int i = 0; i < rows - r; ++i) {
            AddDynamic(scene, {1.08 * (i - 0.5 * (rows - 1 - r)), brickHeight * (r + 0.5) - squeeze * (r + 1)},
                       scenes::Box(0.5, 0.5 * brickHeight), {1.0, 0.6});
        }
    }
    return scene;
}

scenes::Scene MakeColumn(int count, double topDensity = 1.0) {
    scenes::Scene scene = MakeFloored(count + 20.0);
    for (int i = 0; i < count; ++i) {
        AddDynamic(scene, {0.0, 0.7 * (i + 0.5)}, scenes::Box(0.45, 0.35), {i + 1 == count ? topDensity : 1.0, 0.6});
    }
    return scene;
}

/// Pairs of cards that lean on each other by 0.35 rad, with flat ones on top, all just touching.
scenes::Scene MakeCardHouse(int levels) {
    scenes::Scene scene = MakeFloored(20.0, 0.9);
    const Material card{1.0, 0.9};
    const double half = 0.5, thick = 0.02, lean = 0.35;
    const double rise = half * std::cos(lean) + thick * std::sin(lean);   // of a leaning card's centre over its foot
    const double reach = half * std::sin(lean) + thick * std::cos(lean);  // of its outline to the side
    for (int level = 0; level < levels; ++level) {
        const double bottom = level * (2.0 * rise + 2.0 * thick);
        for (int pair = 0; pair < levels - level; ++pair) {
            const double x = (pair - 0.5 * (levels - level - 1)) * 4.0 * reach;
            AddDynamic(scene, {x - reach, bottom + rise}, scenes::Box(thick, half), card, -lean);
            AddDynamic(scene, {x + reach, bottom + rise}, scenes::Box(thick, half), card, lean);
            if (pair == 0) continue;
            AddDynamic(scene, {x - 2.0 * reach, bottom + 2.0 * rise + thick}, scenes::Box(2.2 * reach, thick), card);
        }
    }
    return scene;
}

/// Half a ring of wedges, 4 m in radius and this share of it thick, on two feet.
scenes::Scene MakeArch(int stones, double thickness) {
    scenes::Scene scene = MakeFloored(20.0, 0.8);
    const double inner = 4.0, outer = inner * (1.0 + thickness);
    for (int i = 0; i < stones; ++i) {
        const double from = scenes::pi * i / stones, to = scenes::pi * (i + 1) / stones, middle = 0.5 * (from + to);
        const Point at{0.5 * (inner + outer) * std::cos(middle), 0.5 * (inner + outer) * std::sin(middle)};
        const auto corner = [&](double radius, double angle) {
            return scenes::Point(radius * std::cos(angle) - at.x, radius * std::sin(angle) - at.y);
        };
        AddDynamic(scene, at,
                   scenes::Polygon({corner(inner, from), corner(outer, from), corner(outer, to), corner(inner, to)}),
                   {1.0, 0.8});
    }
    return scene;
}

/// Boxes of mixed sizes let fall into a bin.
scenes::Scene MakeHeap(int count) {
    scenes::Scene scene = MakeFloored(40.0);
    for (const double side : {-1.0, 1.0}) AddStatic(scene, {13.0 * side, 50.0}, scenes::Box(1.0, 50.0), {0.0, 0.6});
    scenes::Random random(5);
    for (int i = 0; i < count; ++i) {
        const Point at{i % 24 - 11.5, 1.0 + static_cast<double>(i / 24)};
        const double width = random.Uniform(0.4, 0.8), height = random.Uniform(0.4, 0.8);
        AddDynamic(scene, at, scenes::Box(0.5 * width, 0.5 * height), {1.0, 0.6}, random.Uniform(0.0, 2.0));
    }
    return scene;
}

/// Boxes of 1 mm to 1 m side by side on a floor that is a box.
scenes::Scene MakeMixedSizes() {
    scenes::Scene scene = MakeEmptyScene();
    AddStatic(scene, {0.0, -1.0}, scenes::Box(20.0, 1.0), {0.0, 0.6});
    for (int i = 0; i < 4; ++i) {
        const double half = 0.5 * std::pow(10.0, -i);
        AddDynamic(scene, {2.0 * i - 3.0, half}, scenes::Box(half, half), {1.0, 0.6});
    }
    return scene;
}

/// The worst height above the floor or below it, m.
double FindFloat(const LabWorld& lab, double) {
    double worst = 0.0;
    for (int i = 1; i < lab.GetBodyCount(); ++i) {
        const double half = double{lab.GetScene().bodies[static_cast<size_t>(i)].position.y};
        worst = std::max(worst, std::abs(lab.Read(i).origin.y - half));
    }
    return worst;
}

void AddPyramids(std::vector<ExtremeCase>& cases) {
    struct Pile {
        int rows;
        double seconds, shift;  ///< until Box2D 3 with 4 sub-steps sleeps, and how far bricks then are, m
    };
    for (const Pile pile : {Pile{15, 1.7, 0.0066}, Pile{40, 2.4, 0.06}, Pile{60, 4.0, 0.14}, Pile{80, 6.6, 0.2}}) {
        cases.push_back(
            {.name = fmt::format("flush-pyramid-{}", pile.rows),
             .group = "built flush",
             .what = fmt::format("a pyramid of {} rows: asleep after {} s, shifted", pile.rows, pile.seconds),
             .make = [=] { return MakePyramid(pile.rows); },
             .seconds = pile.seconds,
             .quickSeconds = pile.rows > 40 ? 0.5 : pile.seconds,
             .demands = {.overlap = 0.02, .restSpeed = mustSleep, .accuracy = pile.shift},
             .measure = FindShift});
    }
    for (const int depth : {15, 50}) {
        cases.push_back({.name = fmt::format("squeezed-pyramid-{}mm", depth),
                         .group = "built flush",
                         .what = fmt::format("a pyramid of 15 rows, each {} mm in the one below: shifted", depth),
                         .make = [=] { return MakePyramid(15, 0.001 * depth); },
                         .quickSeconds = 2.0,
                         .demands = {.energy = false, .accuracy = 0.05, .maxSpeed = 3.0},
                         .measure = FindShift});
    }
}

void AddColumns(std::vector<ExtremeCase>& cases) {
    for (const int count : {20, 40, 80, 120}) {
        cases.push_back({.name = fmt::format("flush-column-{}", count),
                         .group = "built flush",
                         .what = fmt::format("a column of {} boxes of 0.9 × 0.7 m: leans by", count),
                         .make = [=] { return MakeColumn(count); },
                         .seconds = 20.0,
                         .quickSeconds = 5.0,
                         .demands = {.bounds = Bounds{{-0.45, 0.0}, {0.45, 0.7 * count}}, .accuracy = 0.1},
                         .measure = FindShift});
    }
    for (const double load : {10.0, 100.0}) {
        cases.push_back({.name = fmt::format("flush-column-load-{:g}", load),
                         .group = "built flush",
                         .what = fmt::format("a column of 10 boxes under one of {:g} times the mass: leans by", load),
                         .make = [=] { return MakeColumn(11, load); },
                         .seconds = 20.0,
                         .quickSeconds = 5.0,
                         .demands = {.bounds = Bounds{{-0.45, 0.0}, {0.45, 8.0}}, .accuracy = 0.1},
                         .measure = FindShift});
    }
}

}  // namespace

std::vector<ExtremeCase> MakeBuiltCases() {
    std::vector<ExtremeCase> cases;
    AddPyramids(cases);
    AddColumns(cases);
    for (const int levels : {3, 5}) {
        cases.push_back({.name = fmt::format("flush-cards-{}", levels),
                         .group = "built flush",
                         .what = fmt::format("a house of cards of {} levels: has fallen", levels),
                         .make = [=] { return MakeCardHouse(levels); },
                         .seconds = 20.0,
                         .quickSeconds = 5.0,
                         .demands = {.accuracy = 0.5},
                         .measure = HasFallen});
    }
    for (const auto& [stones, percent] : {std::pair{15, 14}, {15, 25}, {31, 14}, {31, 25}}) {
        cases.push_back(
            {.name = fmt::format("flush-arch-{}-{}", stones, percent),
             .group = "built flush",
             .what = fmt::format("an arch of {} stones, {} % of its radius thick: has fallen", stones, percent),
             .make = [=] { return MakeArch(stones, 0.01 * percent); },
             .seconds = 20.0,
             .quickSeconds = 5.0,
             .demands = {.accuracy = 0.5},
             .measure = HasFallen});
    }
    // The line of thrust of a half ring leaves stones thinner than 0.1075 times the middle radius.
    cases.push_back({.name = "flush-arch-15-7",
                     .group = "built flush",
                     .what = "an arch of 15 stones, 7 % of its radius thick, which cannot stand: stands",
                     .make = [] { return MakeArch(15, 0.07); },
                     .seconds = 20.0,
                     .quickSeconds = 5.0,
                     .demands = {.accuracy = 0.5},
                     .measure = [](const LabWorld& lab, double s) { return 1.0 - HasFallen(lab, s); }});
    for (const int count : {150, 1500}) {
        cases.push_back({.name = fmt::format("heap-{}", count),
                         .group = "built flush",
                         .what = fmt::format("{} boxes of mixed sizes let fall into a bin: asleep after 12 s", count),
                         .make = [=] { return MakeHeap(count); },
                         .seconds = 12.0,
                         .quickSeconds = count > 1000 ? 1.0 : 12.0,
                         .demands = {.bounds = Bounds{{-13.0, 0.0}, {13.0, 100.0}}, .restSpeed = mustSleep}});
    }
    cases.push_back({.name = "mixed-sizes",
                     .group = "built flush",
                     .what = "boxes of 1 mm, 1 cm, 10 cm and 1 m on one floor: above it or below",
                     .make = MakeMixedSizes,
                     .quickSeconds = 5.0,
                     .demands = {.accuracy = 1e-3},
                     .measure = FindFloat});
    return cases;
}

}  // namespace testbed
