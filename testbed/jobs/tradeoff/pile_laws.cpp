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

constexpr double side = 1.0;  ///< of the boxes, m

/// What the contacts of a pile carry, over half a second. Bodies come from below upwards.
struct Load {
    std::vector<double> force;  ///< mean, per level of the upper body of a contact, N
    double overlap = 0.0;       ///< worst of what the solver keeps apart, at the end, m
};

/// `levelOf`: the level of a body above the floor.
template <typename LevelOf>
Load MeasureLoad(LabWorld& lab, const RunSpec& setting, int levels, LevelOf&& levelOf) {
    Load load;
    load.force.assign(static_cast<size_t>(levels), 0.0);
    std::vector<ContactReading> contacts;
    const int steps = GetRate(setting) / 2;
    const double time = steps * GetTimeStep(setting);
    for (int i = 0; i < steps; ++i) {
        lab.Step();
        lab.GetContacts(contacts);
        load.overlap = 0.0;
        for (const ContactReading& c : contacts) {
            const auto level = static_cast<size_t>(levelOf(std::max(c.bodyA, c.bodyB)));
            for (int p = 0; p < c.pointCount; ++p) {
                load.force[level] += c.impulses[p] / time;
                load.overlap = std::max(load.overlap, -c.separations[p]);
            }
        }
    }
    return load;
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

scenes::Scene MakeColumn(int count, double gap = boxGap) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 4.0);
    for (int i = 0; i < count; ++i) {
        AddDynamic(scene, {0.0, 0.5 * side + gap + (side + gap) * i}, scenes::Box(0.5 * side, 0.5 * side));
    }
    return scene;
}

/// A box that is this much too low lies beside the one that was below it, m.
constexpr double fallen = 0.5 * side;

/// Worst relative error of an interface's force, worst overlap, rms speed after `seconds`.
std::vector<double> MeasureColumn(const RunSpec& setting, int count, double seconds) {
    const auto lab = MakeLab(MakeColumn(count, BoxGapAtRest(setting)), setting);
    Run(*lab, setting, seconds);
    const Load load = MeasureLoad(*lab, setting, count, [](int body) { return body - 1; });
    const double weight = lab->Read(1).mass * gravity;
    double force = 0.0;
    for (int i = 0; i < count; ++i)
        force = std::max(force, RelativeError(load.force[static_cast<size_t>(i)], weight * (count - i)));
    return {force, load.overlap, Unrest(*lab, setting)};
}

// --- Pyramid: row r carries m·g·(B − r)(B − r + 1)/2.

constexpr int pyramidBase = 10;

scenes::Scene MakePyramid(double gap = boxGap) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 10.0, {0.0, 0.6});
    for (int r = 0; r < pyramidBase; ++r) {
        for (int i = 0; i < pyramidBase - r; ++i) {
            const double x = 1.125 * (i - 0.5 * (pyramidBase - r - 1));
            AddDynamic(scene, {x, 0.5 * side + gap + (side + gap) * r}, scenes::Box(0.5 * side, 0.5 * side),
                       {1.0, 0.6});
        }
    }
    return scene;
}

/// Index of box i of row r.
int PyramidBody(int r, int i) { return 1 + r * pyramidBase - r * (r - 1) / 2 + i; }
int PyramidRow(int body) {
    int row = 0;
    while (row + 1 < pyramidBase && PyramidBody(row + 1, 0) <= body) ++row;
    return row;
}

std::vector<double> MeasurePyramid(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakePyramid(BoxGapAtRest(setting)), setting);
    Run(*lab, setting, 10.0);
    const Load load = MeasureLoad(*lab, setting, pyramidBase, PyramidRow);
    const double weight = lab->Read(1).mass * gravity;
    double force = 0.0, asymmetry = 0.0;
    for (int r = 0; r < pyramidBase; ++r) {
        const int boxes = pyramidBase - r;
        force = std::max(force, RelativeError(load.force[static_cast<size_t>(r)], weight * 0.5 * boxes * (boxes + 1)));
        for (int i = 0; i < boxes; ++i) {
            const Point left = lab->Read(PyramidBody(r, i)).centre;
            const Point right = lab->Read(PyramidBody(r, boxes - 1 - i)).centre;
            asymmetry = std::max(asymmetry, Length({left.x + right.x, left.y - right.y}));
        }
    }
    return {force, load.overlap, asymmetry, Unrest(*lab, setting)};
}

}  // namespace

std::vector<Law> MakePileLaws() {
    return {
        {.name = "column-10",
         .title = "A column of 10 boxes after 2 s",
         .exact = "interface k carries the k boxes above it",
         .errors =
             {{.name = "worst force, relative", .game = 2e-2, .precise = 1e-2, .rounding = 1e-4},
              {.name = "worst overlap", .unit = "m", .game = 1e-2, .precise = 1e-2, .rounding = 1e-5, .failed = fallen},
              {.name = "rms speed", .unit = "m/s", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5}},
         .measure = [](const RunSpec& setting, Effort) { return MeasureColumn(setting, 10, 2.0); },
         .costScene = [] { return MakeColumn(10); },
         .pitch = {12.0, 15.0}},
        {.name = "column-50",
         .title = "A column of 50 boxes after 10 s",
         .exact = "interface k carries the k boxes above it",
         .errors = {{.name = "worst force, relative", .precise = 1e-2, .rounding = 1e-4},
                    {.name = "worst overlap", .unit = "m", .rounding = 1e-5, .failed = fallen},
                    {.name = "rms speed", .unit = "m/s", .rounding = 1e-5}},
         .measure = [](const RunSpec& setting, Effort) { return MeasureColumn(setting, 50, 10.0); },
         .costScene = [] { return MakeColumn(50); },
         .pitch = {12.0, 60.0}},
        {.name = "pyramid",
         .title = "A pyramid of base 10 after 10 s",
         .exact = "row r carries (B − r)(B − r + 1)/2 boxes; symmetric; at rest",
         .errors = {{.name = "worst force of a row, relative", .game = 2e-2, .precise = 5e-3, .rounding = 1e-4},
                    {.name = "worst overlap", .unit = "m", .rounding = 1e-5, .failed = fallen},
                    {.name = "asymmetry", .unit = "m", .rounding = 1e-5},
                    {.name = "rms speed", .unit = "m/s", .game = 1e-2, .precise = 1e-4, .rounding = 1e-5}},
         .measure = MeasurePyramid,
         .costScene = [] { return MakePyramid(); },
         .pitch = {25.0, 15.0}},
    };
}

}  // namespace testbed
