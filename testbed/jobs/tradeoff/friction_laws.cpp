// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Coulomb friction and tipping: threshold, sliding, creep, braking, slip to roll, rolling on a pulled box, the slope at
// which a box tips.

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/tradeoff/law.h"

namespace testbed {
namespace {

// --- Incline of slope tan α = 0.5 and a box that sticks or slides.

const double inclineAngle = std::atan(0.5);

/// A box (half extents) on an incline through the origin, both of friction μ. The box is body 1.
scenes::Scene MakeIncline(double alpha, double mu, Point half, double gap = boxGap) {
    scenes::Scene scene = MakeEmptyScene();
    const Material rough{1.0, mu};
    AddStatic(scene, {}, scenes::Box(50.0, 0.5), rough, alpha);
    const double height = 0.5 + half.y + gap;
    AddDynamic(scene, {-std::sin(alpha) * height, std::cos(alpha) * height}, scenes::Box(half.x, half.y), rough, alpha);
    return scene;
}

/// How far and how much faster the box on the incline gets in `seconds`, after half a second to settle.
struct Slide {
    double way = 0.0, acceleration = 0.0;
};
Slide MeasureSlide(const RunSpec& setting, double factor, double seconds) {
    const auto lab = MakeLab(MakeIncline(inclineAngle, 0.5 * factor, {0.5, 0.5}, BoxGapAtRest(setting)), setting);
    Run(*lab, setting, 0.5);
    const BodyReading start = lab->Read(1);
    Run(*lab, setting, seconds);
    const BodyReading end = lab->Read(1);
    return {Length(end.centre - start.centre), (Length(end.velocity) - Length(start.velocity)) / seconds};
}

std::vector<double> MeasureIncline(const RunSpec& setting, Effort effort) {
    // 1 cm in 2 s is a = 5 mm/s², a thousandth of the threshold, and ten halvings end at 4e-4.
    const double threshold = Bisect(0.8, 1.2, effort == Effort::quick ? 7 : 10,
                                    [&](double factor) { return MeasureSlide(setting, factor, 2.0).way < 0.01; });
    double sliding = 0.0, creep = 0.0;
    for (const double factor : {0.8, 0.9}) {
        const double exact = gravity * (std::sin(inclineAngle) - 0.5 * factor * std::cos(inclineAngle));
        sliding = std::max(sliding, RelativeError(MeasureSlide(setting, factor, 2.0).acceleration, exact));
    }
    for (const double factor : {1.05, 1.2}) creep = std::max(creep, MeasureSlide(setting, factor, 10.0).way);
    return {sliding, std::abs(threshold - 1.0), creep};
}

// --- A box slides to a stop, a slipping disk begins to roll.

constexpr double stopSpeed = 8.0, stopFriction = 0.5, rollSpeed = 6.0, rollFriction = 0.2, diskRadius = 0.5;

scenes::Scene MakeStop() {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 12.0, {0.0, stopFriction});
    AddDynamic(scene, {0.0, 0.5 + boxGap}, scenes::Box(0.5, 0.5), {1.0, stopFriction});
    return scene;
}
scenes::Scene MakeRoll() {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 20.0, {0.0, rollFriction});
    AddDynamic(scene, {0.0, diskRadius + diskGap}, scenes::Circle(diskRadius), {1.0, rollFriction});
    return scene;
}
scenes::Scene MakeStopCost() {
    scenes::Scene scene = MakeStop();
    Throw(scene, 1, {stopSpeed, 0.0});
    return scene;
}

double MeasureStop(const RunSpec& setting) {
    const auto lab = MakeLab(MakeStop(), setting);
    Run(*lab, setting, 0.5);
    const double start = lab->Read(1).centre.x;
    lab->SetVelocity(1, {stopSpeed, 0.0}, 0.0);
    Run(*lab, setting, 3.0);
    return RelativeError(lab->Read(1).centre.x - start, stopSpeed * stopSpeed / (2.0 * stopFriction * gravity));
}

struct Roll {
    double speed = 0.0, time = 0.0;  ///< relative errors
};
Roll MeasureRoll(const RunSpec& setting) {
    const auto lab = MakeLab(MakeRoll(), setting);
    Run(*lab, setting, 0.5);
    lab->SetVelocity(1, {rollSpeed, 0.0}, 0.0);
    const double h = GetTimeStep(setting);
    double slip = rollSpeed, time = 0.0;
    for (int i = 0; i < 3 * GetRate(setting); ++i) {
        lab->Step();
        const BodyReading disk = lab->Read(1);
        const double now = disk.velocity.x + diskRadius * disk.spin;
        // The disk rolls about a point half a slop inside of its rim, so a little slip stays: below 1 % it rolls. Slip
        // falls by 3μg·h per step until it is used up; the last, shorter stretch is interpolated.
        if (time == 0.0 && now < 0.01 * rollSpeed) time = h * (i + slip / (3.0 * rollFriction * gravity * h));
        slip = now;
    }
    return {RelativeError(lab->Read(1).velocity.x, 2.0 / 3.0 * rollSpeed),
            RelativeError(time, rollSpeed / (3.0 * rollFriction * gravity))};
}

std::vector<double> MeasureBraking(const RunSpec& setting, Effort) {
    const Roll roll = MeasureRoll(setting);
    return {MeasureStop(setting), roll.speed, roll.time};
}

// --- A pulled box with ten disks on its top.

constexpr double pullForce = 130.0, pullFriction = 0.3, topRadius = 0.3;
constexpr int topDisks = 10;

scenes::Scene MakePull(double restOfBox, double restOfDisks) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 30.0, {0.0, pullFriction * pullFriction / 0.5});  // friction mixes by the geometric mean
    AddDynamic(scene, {0.0, 0.5 + restOfBox}, scenes::Box(8.0, 0.5), {1.0, 0.5});
    for (int i = 0; i < topDisks; ++i) {
        // On the box they fall behind by 3.3 m while it is pulled, and none is to leave it.
        AddDynamic(scene, {1.2 * i - 4.2, 1.0 + restOfBox + topRadius + restOfDisks}, scenes::Circle(topRadius),
                   {1.0, 0.5});
    }
    return scene;
}

std::vector<double> MeasurePull(const RunSpec& setting, Effort) {
    const auto lab = MakeLab(MakePull(BoxGapAtRest(setting), DiskGapAtRest(setting)), setting);
    Run(*lab, setting, 1.0);
    const int steps = 3 * GetRate(setting) / 2;
    const double before = lab->Read(1).velocity.x, time = steps * GetTimeStep(setting);
    for (int i = 0; i < steps; ++i) {
        lab->ApplyForce(1, {pullForce, 0.0});
        lab->Step();
    }
    const double acceleration = (lab->Read(1).velocity.x - before) / time;
    double disks = 0.0;
    for (int i = 0; i < topDisks; ++i) disks += lab->Read(2 + i).velocity.x / time / topDisks;
    const double box = lab->Read(1).mass, load = topDisks * lab->Read(2).mass;
    // The floor slows by μ(M + n·m)g; each disk rolls backward on the box and takes m·a/3 from it.
    const double exact = (pullForce - pullFriction * (box + load) * gravity) / (box + load / 3.0);
    return {RelativeError(acceleration, exact), RelativeError(disks, exact / 3.0)};
}

// --- A box tips where its centre leaves its foot: tan α = w/h.

std::vector<double> MeasureTipping(const RunSpec& setting, Effort effort) {
    double worst = 0.0;
    for (const double width : {0.3, 0.6}) {  // of a box 1 m high
        const double slope = Bisect(0.8 * width, 1.2 * width, effort == Effort::quick ? 7 : 10, [&](double tangent) {
            const double tilt = std::atan(tangent);
            const auto lab = MakeLab(MakeIncline(tilt, 2.0, {0.5 * width, 0.5}, BoxGapAtRest(setting)), setting);
            Run(*lab, setting, 4.0);
            return std::abs(lab->Read(1).angle - tilt) > 0.3;
        });
        worst = std::max(worst, RelativeError(slope, width));
    }
    return {worst};
}

}  // namespace

std::vector<Law> MakeFrictionLaws() {
    return {
        {.name = "incline",
         .title = "A box on a slope of 0.5, friction 0.8 to 1.2 times the slope",
         .exact = "slides with g(sin α − μ cos α) below the threshold, does not move above it",
         .errors = {{.name = "acceleration, relative", .rounding = 1e-4},
                    {.name = "threshold, relative", .game = 2e-2, .precise = 5e-3, .rounding = 1e-3},
                    {.name = "creep in 10 s", .unit = "m", .game = 5e-3, .precise = 1e-4, .rounding = 1e-5}},
         .measure = MeasureIncline,
         .costScene =
             [] {
                 return MakeIncline(inclineAngle, 0.45, {0.5, 0.5});
             },
         .pitch = {120.0, 80.0}},
        {.name = "braking",
         .title = "A box slides to a stop from 8 m/s; a disk thrown with 6 m/s begins to roll",
         .exact = "way v²/(2μg); rolls with 2/3 v after v/(3μg)",
         .errors = {{.name = "way, relative", .game = 2e-2, .precise = 2e-3, .rounding = 1e-4},
                    {.name = "rolling speed, relative", .game = 2e-2, .precise = 2e-3, .rounding = 1e-4},
                    {.name = "time to roll, relative", .game = 2e-2, .precise = 2e-3, .rounding = 1e-4}},
         .measure = MeasureBraking,
         .costScene = MakeStopCost,
         .pitch = {30.0, 5.0}},
        {.name = "pulled-box",
         .title = "A box with ten disks on its top is pulled over a floor",
         .exact = "a = (F − μ(M + n·m)g)/(M + n·m/3), the disks roll with a/3",
         .errors = {{.name = "acceleration, relative", .game = 2e-2, .precise = 5e-3, .rounding = 1e-4},
                    {.name = "acceleration of the disks, relative", .game = 2e-2, .precise = 5e-3, .rounding = 1e-4}},
         .measure = MeasurePull,
         .costScene = [] { return MakePull(boxGap, diskGap); },
         .pitch = {65.0, 5.0}},
        {.name = "tipping",
         .title = "Boxes of 0.3 and 0.6 × 1 m on slopes: where they tip",
         .exact = "tan α = w/h",
         .errors = {{.name = "slope, relative", .game = 5e-2, .precise = 3e-2, .rounding = 1e-3}},
         .measure = MeasureTipping,
         .costScene =
             [] {
                 return MakeIncline(std::atan(0.25), 2.0, {0.15, 0.5});
             },
         .pitch = {120.0, 60.0}},
    };
}

}  // namespace testbed
