// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Impacts: rebound heights, two-disk collisions of all mass ratios, and walls that nothing passes.

#include <cmath>

#include "testbed/engines/law_scenes.h"
#include "testbed/jobs/tradeoff/law.h"

namespace testbed {
namespace {

// --- Restitution: a ball dropped from 5 m.

constexpr double dropHeight = 5.0, ballRadius = 0.5;

/// The ball is body 1.
scenes::Scene MakeDrop(double e, double drop) {
    scenes::Scene scene = MakeEmptyScene();
    AddFloor(scene, 2.0);
    AddDynamic(scene, {0.0, ballRadius + skin + drop}, scenes::Circle(ballRadius), {1.0, 0.2, e});
    return scene;
}

/// Height of apex number `bounces` over the drop; 0 if it never comes.
double MeasureApex(const RunSpec& setting, double e, double drop, size_t bounces) {
    const auto lab = MakeLab(MakeDrop(e, drop), setting);
    ApexFinder finder;
    const int steps = static_cast<int>((3.0 + 2.5 * static_cast<double>(bounces)) * GetRate(setting));
    for (int i = 0; i < steps && finder.GetApexes().size() < bounces; ++i) {
        lab->Step();
        const BodyReading ball = lab->Read(1);
        finder.Add(ball.centre.y - ballRadius - skin, ball.velocity.y);
    }
    return finder.GetApexes().size() < bounces ? 0.0 : finder.GetApexes()[bounces - 1] / drop;
}

/// The worst over drops that meet the floor in eight phases of a step of 1/60 s (which falls 17 cm).
double WorstRebound(const RunSpec& setting, double e, size_t bounces, int phases) {
    double worst = 0.0;
    for (int phase = 0; phase < phases; ++phase) {
        const double apex = MeasureApex(setting, e, dropHeight + 0.17 * phase / phases, bounces);
        worst = std::max(worst, std::abs(apex - e * e));
    }
    return worst;
}

std::vector<double> MeasureRestitution(const RunSpec& setting, Effort effort) {
    const int phases = effort == Effort::quick ? 4 : 8;
    double worst = 0.0;
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) worst = std::max(worst, WorstRebound(setting, e, 1, phases));
    return {worst, WorstRebound(setting, 1.0, 10, phases)};
}

// --- Two disks: one of 2 m/s meets one at rest.

struct Collision {
    double massRatio, e, offset, friction;
};

constexpr double shotSpeed = 2.0;

scenes::Scene MakeCollision(const Collision& c) {
    scenes::Scene scene = MakeEmptyScene(0.0);
    const int light = AddDynamic(scene, {-1.5, c.offset}, scenes::Circle(0.5), {1.0, c.friction, c.e});
    AddDynamic(scene, {}, scenes::Circle(0.5), {c.massRatio, c.friction, c.e});
    Throw(scene, light, {shotSpeed, 0.0});
    return scene;
}

struct Kept {
    double momentum = 0.0, angular = 0.0, velocity = 0.0;  ///< relative errors
};
Kept Collide(const RunSpec& setting, const Collision& c) {
    const auto lab = MakeLab(MakeCollision(c), setting, {.restitutionThreshold = 0.0});
    const Invariants start = SumInvariants(ReadAll(*lab));
    Run(*lab, setting, 1.0);
    const Invariants end = SumInvariants(ReadAll(*lab));
    const double sine = c.offset;  // over the sum of the radii, 1 m
    const Point normal{std::sqrt(1.0 - sine * sine), -sine};
    const Point after = AfterCollision({shotSpeed, 0.0}, normal, c.massRatio, c.e);
    Kept kept;
    kept.momentum = Length(end.momentum - start.momentum) / Length(start.momentum);
    kept.angular = std::abs(end.angular - start.angular) / Length(start.momentum);  // at a leverage of 1 m
    kept.velocity = Length(lab->Read(0).velocity - after) / shotSpeed;
    return kept;
}

std::vector<double> MeasureCollisions(const RunSpec& setting, Effort) {
    Kept worst;
    double velocity = 0.0;
    int count = 0;
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
        for (const double e : {0.0, 0.5, 1.0}) {
            for (const double offset : {0.0, 0.3, 0.6}) {
                const Kept kept = Collide(setting, {ratio, e, offset, 0.0});
                worst.momentum = std::max(worst.momentum, kept.momentum);
                velocity += kept.velocity;
                ++count;
            }
        }
        const Kept rough = Collide(setting, {ratio, 0.5, 0.5, 0.5});
        worst.momentum = std::max(worst.momentum, rough.momentum);
        worst.angular = std::max(worst.angular, rough.angular);
    }
    return {velocity / count, worst.momentum, worst.angular};
}

// --- Tunnelling: shots at walls of all thicknesses, speeds, shapes, angles and phases of a step.

struct Shot {
    double thickness, speed;
    int shape;  ///< 0 disk, 1 box, 2 thin box, 3 triangle
    double angle;
    double phase;     ///< 0 … 1 of a step
    bool bulletCase;  ///< the wall is a light dynamic plate and the shot a bullet
};

scenes::Shape MakeShotShape(int shape) {
    switch (shape) {
        case 0:
            return scenes::Circle(0.25);
        case 1:
            return scenes::Box(0.25, 0.1);
        case 2:
            return scenes::Box(0.5, 0.02);
        default:
            return scenes::Polygon({scenes::Point(-0.2, -0.2), scenes::Point(0.3, 0.0), scenes::Point(-0.2, 0.2)});
    }
}

/// The shot is body 1. It starts left of the wall and flies to the right.
scenes::Scene MakeShot(const Shot& shot, double h) {
    scenes::Scene scene = MakeEmptyScene(0.0);
    const auto wall = scenes::Box(0.5 * shot.thickness, 10.0);
    const Point at{0.5 * shot.thickness, 0.0};
    if (shot.bulletCase) {
        AddDynamic(scene, at, wall, {100.0 / shot.thickness});
    } else {
        AddStatic(scene, at, wall);
    }
    const double start = -1.0 - (0.5 + shot.phase) * shot.speed * h;
    const int body = AddDynamic(scene, {start, 0.0}, MakeShotShape(shot.shape), {}, shot.angle);
    Throw(scene, body, {shot.speed, 0.0});
    scene.bodies[static_cast<size_t>(body)].bullet = shot.bulletCase;
    return scene;
}

/// Whether the shot is found behind the wall; capped steps are failures too, for they hide the speed.
bool Crosses(const RunSpec& setting, const Shot& shot) {
    const scenes::Scene scene = MakeShot(shot, GetTimeStep(setting));
    RunSpec free = setting;
    free.caps = false;
    const auto lab = MakeLab(scene, free);
    // Box2D caps 2 m per step: as many steps as it needs to arrive, and some to come out.
    const double way = 1.0 + 1.5 * shot.speed * GetTimeStep(setting);
    const int steps = std::min(600, 12 + static_cast<int>(way / std::min(2.0, shot.speed * GetTimeStep(setting))));
    for (int i = 0; i < steps; ++i) {
        if (lab->Step().capped > 0) return true;
        if (lab->Read(1).centre.x > lab->Read(0).centre.x + 0.5 * shot.thickness) return true;
    }
    return false;
}

std::vector<double> MeasureTunnelling(const RunSpec& setting, Effort effort) {
    const int phases = effort == Effort::quick ? 5 : 33;
    double statics = 0.0, bullets = 0.0;
    for (const double thickness : {1e-3, 1e-2, 0.1, 1.0}) {
        for (const double speed : {10.0, 100.0, 1e3, 1e4}) {
            for (int shape = 0; shape < 4; ++shape) {
                for (int phase = 0; phase < phases; ++phase) {
                    const double share = static_cast<double>(phase) / phases;
                    const double angle = 0.7 * (phase % 3);
                    statics += Crosses(setting, {thickness, speed, shape, angle, share, false});
                    // Against a moving plate each third phase is enough.
                    if (phase % 3 == 0) bullets += Crosses(setting, {thickness, speed, shape, angle, share, true});
                }
            }
        }
    }
    return {statics, bullets};
}

}  // namespace

std::vector<Law> MakeImpactLaws() {
    return {
        {.name = "restitution",
         .title = "A ball drops 5 m, restitution 0 to 1, worst over the phases of a step",
         .exact = "the apex is e² of the drop; e = 1 keeps its energy over ten bounces",
         .errors = {{.name = "apex over the drop", .game = 0.03, .precise = 0.01, .rounding = 1e-4},
                    {.name = "energy after ten bounces", .game = 0.30, .precise = 0.02, .rounding = 1e-4}},
         .measure = MeasureRestitution,
         .costScene = [] { return MakeDrop(1.0, 1.0); },
         .pitch = {6.0, 8.0}},
        {.name = "two-disks",
         .title = "Two disks collide, masses 1:1 to 1:1000, central and oblique",
         .exact = "the closed form of the velocities; momentum",
         .errors = {{.name = "velocity, mean", .rounding = 1e-5},
                    {.name = "momentum", .game = 1e-5, .precise = 1e-6, .rounding = 1e-6},
                    {.name = "angular momentum, rough disks", .rounding = 1e-5}},
         .measure = MeasureCollisions,
         .costScene =
             [] {
                 return MakeCollision({10.0, 0.5, 0.3, 0.0});
             },
         .pitch = {10.0, 10.0}},
        {.name = "tunnelling",
         .title = "Shots at walls of 1 mm to 1 m with 10 to 10,000 m/s, four shapes, all phases of a step",
         .exact = "none passes",
         .errors = {{.name = "through static walls", .unit = "shots", .game = 0.0, .precise = 0.0, .rounding = 0.5},
                    {.name = "bullets through plates", .unit = "shots", .precise = 0.0, .rounding = 0.5}},
         .measure = MeasureTunnelling,
         .costScene =
             [] {
                 return MakeShot({0.1, 100.0, 1, 0.7, 0.5, false}, 1.0 / 60.0);
             },
         .pitch = {30.0, 30.0},
         .capped = false},
    };
}

}  // namespace testbed
