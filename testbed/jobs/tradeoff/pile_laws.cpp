// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Piles at rest: what each interface of a column and each row of a pyramid carries, how far bodies sink, how still they
// are.

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/tradeoff/law.h"

namespace testbed {
namespace {

constexpr double side = 1.0;                         ///< of the boxes, m
constexpr double restDistance = side + boxGap;       ///< of two centres at rest, m
constexpr double touchDistance = side + 2.0 * skin;  ///< of two centres whose skins just touch, m

/// Mean force in N that each level carries, over half a second: the impulses of the contacts whose upper body is there.
std::vector<double> MeanForces(LabWorld& lab, const RunSpec& setting, int levels) {
    std::vector<double> force(static_cast<size_t>(levels), 0.0);
    std::vector<ContactReading> contacts;
    const int steps = GetRate(setting) / 2;
    const double time = steps * GetTimeStep(setting);
    for (int i = 0; i < steps; ++i) {
        lab.Step();
        lab.GetContacts(contacts);
        for (const ContactReading& c : contacts) {
            const double upper = std::max(lab.Read(c.bodyA).centre.y, lab.Read(c.bodyB).centre.y);
            const long level = std::lround((upper - 0.5 * side) / restDistance);
            if (level < 0 || level >= levels) continue;  // fallen: it is missed where it belongs
            for (int p = 0; p < c.pointCount; ++p) force[static_cast<size_t>(level)] += c.impulses[p] / time;
        }
    }
    return force;
}

/// Root mean square speed of the moving bodies over a second.
double Unrest(LabWorld& lab, const RunSpec& setting) {
    double sum = 0.0;
    for (int i = 0; i < GetRate(setting); ++i) {
        lab.Step();
        const double speed = RmsSpeed(ReadMoving(lab));
        sum += speed * speed;
    }
    return std::sqrt(sum / GetRate(setting));
}

// --- Column: body 0 is the floor, body 1 the lowest box.

scenes::Scene MakeColumn(int count) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 4.0);
    for (int i = 0; i < count; ++i) {
        AddDynamic(scene, {0.0, 0.5 * side + boxGap + restDistance * i}, scenes::Box(0.5 * side, 0.5 * side));
    }
    return scene;
}

/// A box that is this much too low lies beside the one that was below it, m.
constexpr double fallen = 0.5 * side;

/// Worst relative error of an interface's force, worst overlap, rms speed after `seconds`.
std::vector<double> MeasureColumn(const RunSpec& setting, int count, double seconds) {
    const auto lab = MakeLab(MakeColumn(count), setting);
    Run(*lab, setting, seconds);
    const std::vector<double> forces = MeanForces(*lab, setting, count);
    const double weight = lab->Read(1).mass * gravity;
    double force = 0.0, overlap = 0.0;
    for (int i = 0; i < count; ++i) {
        force = std::max(force, RelativeError(forces[static_cast<size_t>(i)], weight * (count - i)));
        if (i == 0) continue;
        overlap = std::max(overlap, touchDistance - (lab->Read(i + 1).centre.y - lab->Read(i).centre.y));
    }
    return {force, overlap, Unrest(*lab, setting)};
}

// --- Pyramid: row r carries m·g·(B − r)(B − r + 1)/2.

constexpr int pyramidBase = 10;

scenes::Scene MakePyramid() {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 10.0, {0.0, 0.6});
    for (int r = 0; r < pyramidBase; ++r) {
        for (int i = 0; i < pyramidBase - r; ++i) {
            const double x = 1.125 * (i - 0.5 * (pyramidBase - r - 1));
            AddDynamic(scene, {x, 0.5 * side + boxGap + restDistance * r}, scenes::Box(0.5 * side, 0.5 * side),
                       {1.0, 0.6});
        }
    }
    return scene;
}

/// Index of box i of row r.
int PyramidBody(int r, int i) { return 1 + r * pyramidBase - r * (r - 1) / 2 + i; }

std::vector<double> MeasurePyramid(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakePyramid(), setting);
    Run(*lab, setting, 10.0);
    const std::vector<double> forces = MeanForces(*lab, setting, pyramidBase);
    const double weight = lab->Read(1).mass * gravity;
    double force = 0.0, overlap = 0.0, asymmetry = 0.0;
    for (int r = 0; r < pyramidBase; ++r) {
        const int boxes = pyramidBase - r;
        force = std::max(force, RelativeError(forces[static_cast<size_t>(r)], weight * 0.5 * boxes * (boxes + 1)));
        for (int i = 0; i < boxes; ++i) {
            const Point left = lab->Read(PyramidBody(r, i)).centre;
            const Point right = lab->Read(PyramidBody(r, boxes - 1 - i)).centre;
            asymmetry = std::max(asymmetry, Length({left.x + right.x, left.y - right.y}));
            if (r == 0) continue;
            overlap = std::max(overlap, touchDistance - (left.y - lab->Read(PyramidBody(r - 1, i)).centre.y));
        }
    }
    return {force, overlap, asymmetry, Unrest(*lab, setting)};
}

}  // namespace

std::vector<Law> MakePileLaws() {
    return {
        {.name = "column-10",
         .title = "A column of 10 boxes after 2 s",
         .exact = "interface k carries the k boxes above it",
         .errors = {{.name = "worst force, relative", .game = 2e-2, .precise = 1e-2, .rounding = 1e-4},
                    {.name = "worst overlap of skins",
                     .unit = "m",
                     .game = 1e-2,
                     .precise = 1e-2,
                     .rounding = 1e-5,
                     .failed = fallen},
                    {.name = "rms speed", .unit = "m/s", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5}},
         .measure = [](const RunSpec& setting, Effort) { return MeasureColumn(setting, 10, 2.0); },
         .costScene = [] { return MakeColumn(10); },
         .pitch = {12.0, 15.0}},
        {.name = "column-50",
         .title = "A column of 50 boxes after 10 s",
         .exact = "interface k carries the k boxes above it",
         .errors = {{.name = "worst force, relative", .precise = 1e-2, .rounding = 1e-4},
                    {.name = "worst overlap of skins", .unit = "m", .rounding = 1e-5, .failed = fallen},
                    {.name = "rms speed", .unit = "m/s", .rounding = 1e-5}},
         .measure = [](const RunSpec& setting, Effort) { return MeasureColumn(setting, 50, 10.0); },
         .costScene = [] { return MakeColumn(50); },
         .pitch = {12.0, 60.0}},
        {.name = "pyramid",
         .title = "A pyramid of base 10 after 10 s",
         .exact = "row r carries (B − r)(B − r + 1)/2 boxes; symmetric; at rest",
         .errors = {{.name = "worst force of a row, relative", .game = 2e-2, .precise = 5e-3, .rounding = 1e-4},
                    {.name = "worst overlap of skins", .unit = "m", .rounding = 1e-5, .failed = fallen},
                    {.name = "asymmetry", .unit = "m", .rounding = 1e-5},
                    {.name = "rms speed", .unit = "m/s", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5}},
         .measure = MeasurePyramid,
         .costScene = MakePyramid,
         .pitch = {25.0, 15.0}},
    };
}

}  // namespace testbed
