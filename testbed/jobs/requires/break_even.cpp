// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of break_even.h. Both forms of a world step in turn, and of every step the fastest repeat counts.

#include "testbed/jobs/requires/break_even.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <random>

#include "scree/inspect.h"
#include "scree/world.h"

namespace testbed {

namespace {

constexpr float timeStep = 1.0f / 60.0f;

/// Numbers in [0, 1) that are the same everywhere.
class Random {
public:
    float Next() { return static_cast<float>(m_engine() >> 8) * (1.0f / 16777216.0f); }
    float Next(float low, float high) { return low + (high - low) * Next(); }

private:
    std::mt19937 m_engine{20};
};

void AddCircle(scree::World& world, scree::BodyType type, scree::Vec2 position, scree::Vec2 velocity) {
    scree::BodyDef def;
    def.type = type;
    def.position = position;
    def.linearVelocity = velocity;
    def.allowSleep = false;
    scree::CircleShape circle;
    circle.m_radius = 0.25f;
    world.CreateBody(&def)->CreateFixture(&circle, 1.0f);
}

/// Half the side of a square with a third of a circle a m².
float HalfSide(int circles) { return 0.87f * std::sqrt(static_cast<float>(circles)); }

std::unique_ptr<scree::World> MakeStaticShareWorld(const BreakEvenPlan& plan, StaticLayout layout, double share,
                                                   bool apart) {
    scree::WorldDef def;
    def.gravity = {0.0f, 0.0f};
    def.continuousPhysics = false;
    def.staticShareThreshold = apart ? 0.0f : 1.0f;
    auto world = std::make_unique<scree::World>(def);
    const auto statics = static_cast<int>(share / (1.0 - share) * plan.movers);
    const bool scattered = layout == StaticLayout::scattered;
    const float half = HalfSide(scattered ? plan.movers + statics : plan.movers);
    const float staticHalf = scattered ? half : HalfSide(statics);
    const float centre = scattered ? 0.0f : -1.1f * (half + staticHalf);
    Random random;
    for (int i = 0; i < statics; ++i) {
        const scree::Vec2 position{centre + random.Next(-staticHalf, staticHalf), random.Next(-staticHalf, staticHalf)};
        AddCircle(*world, scree::staticBody, position, {0.0f, 0.0f});
    }
    for (int i = 0; i < plan.movers; ++i) {
        const scree::Vec2 position{random.Next(-half, half), random.Next(-half, half)};
        const scree::Vec2 velocity{random.Next(-3.0f, 3.0f), random.Next(-3.0f, 3.0f)};
        AddCircle(*world, scree::dynamicBody, position, velocity);
    }
    return world;
}

std::unique_ptr<scree::World> MakeFastShareWorld(const BreakEvenPlan& plan, double share, bool continuous) {
    scree::WorldDef def;
    def.gravity = {0.0f, 0.0f};
    def.continuousPhysics = continuous;
    auto world = std::make_unique<scree::World>(def);
    const float half = HalfSide(plan.movers);
    Random random;
    for (int i = 0; i < plan.movers; ++i) {
        const bool fast = i < static_cast<int>(share * plan.movers);
        const float speed = fast ? 60.0f : 1.0f;  // 1 m or 2 cm a step
        const scree::Vec2 position{random.Next(-half, half), random.Next(-half, half)};
        AddCircle(*world, scree::dynamicBody, position, {i % 2 == 0 ? speed : -speed, 0.0f});
    }
    for (float x = -2.0f * half; x < 2.0f * half; x += 2.0f) {
        AddCircle(*world, scree::staticBody, {x, -half - 1.0f}, {0.0f, 0.0f});
    }
    return world;
}

std::unique_ptr<scree::World> MakeIsolatedShareWorld(const BreakEvenPlan& plan, double share, bool apart) {
    scree::WorldDef def;
    def.continuousPhysics = false;
    auto world = std::make_unique<scree::World>(def);
    scree::inspect::SetIsolatedPath(*world, apart);
    constexpr float pitch = 1.0f, radius = 0.25f;
    const float width = pitch * static_cast<float>(plan.movers);
    const scree::BodyDef groundDef;
    scree::EdgeShape ground;
    ground.SetTwoSided({-pitch, 0.0f}, {width, 0.0f});
    world->CreateBody(&groundDef)->CreateFixture(&ground, 0.0f);
    // Free and lying circles alternate in memory as in a scene where some have just been thrown up.
    double falling = 0.0;
    for (int i = 0; i < plan.movers; ++i) {
        falling += share;
        const bool falls = falling >= 1.0 - 1e-9;
        if (falls) falling -= 1.0;
        const float height = falls ? 100.0f : radius;
        AddCircle(*world, scree::dynamicBody, {pitch * static_cast<float>(i), height}, {0.0f, 0.0f});
    }
    return world;
}

using MakeWorld = std::function<std::unique_ptr<scree::World>(const BreakEvenPlan&, double share, bool with)>;

/// ns a mover and step by `read` (ms of a step), of both forms.
BreakEvenPoint Measure(const BreakEvenPlan& plan, double share, const MakeWorld& make,
                       float (*read)(const scree::Profile&), int substeps) {
    const auto steps = static_cast<size_t>(plan.steps);
    std::vector<double> best[2];
    for (auto& of : best) of.assign(steps, std::numeric_limits<double>::infinity());
    for (int repeat = 0; repeat < plan.repeats; ++repeat) {
        const std::unique_ptr<scree::World> worlds[2] = {make(plan, share, false), make(plan, share, true)};
        for (size_t step = 0; step < steps; ++step) {
            for (size_t turn = 0; turn < 2; ++turn) {
                const size_t i = (turn + step) % 2;
                const scree::StepReport report =
                    substeps > 0 ? worlds[i]->Step(timeStep, substeps) : worlds[i]->Step(timeStep, 8, 3);
                best[i][step] = std::min(best[i][step], double{read(report.profile)});
            }
        }
    }
    const auto perMover = [&](const std::vector<double>& ms) {
        return std::accumulate(ms.begin(), ms.end(), 0.0) * 1e6 / plan.steps / plan.movers;
    };
    return {share, perMover(best[0]), perMover(best[1])};
}

std::vector<BreakEvenPoint> MeasureAll(const BreakEvenPlan& plan, const MakeWorld& make,
                                       float (*read)(const scree::Profile&), const std::function<void()>& onPoint,
                                       int substeps = 0) {
    std::vector<BreakEvenPoint> points;
    for (const double share : plan.shares) {
        points.push_back(Measure(plan, share, make, read, substeps));
        if (onPoint) onPoint();
    }
    return points;
}

}  // namespace

std::string DescribeBreakEven(const std::vector<BreakEvenPoint>& points) {
    const auto gain = [](const BreakEvenPoint& p) { return 1.0 - p.nsWith / p.nsWithout; };
    if (points.empty()) return "";
    if (gain(points.back()) <= 0.0)
        return fmt::format("costs {:.0f} % at {:.2f}", -100.0 * gain(points.back()), points.back().share);
    std::size_t first = points.size() - 1;
    while (first > 0 && gain(points[first - 1]) > 0.0) --first;
    const std::string at = fmt::format("saves {:.0f} % at {:.2f}", 100.0 * gain(points.back()), points.back().share);
    if (first == 0) return "pays at every share; " + at;
    const BreakEvenPoint &below = points[first - 1], &above = points[first];
    const double part = -gain(below) / (gain(above) - gain(below));
    return fmt::format("pays above a share of {:.2f}; {}", below.share + part * (above.share - below.share), at);
}

std::vector<BreakEvenPoint> MeasureStaticShare(const BreakEvenPlan& plan, StaticLayout layout,
                                               const std::function<void()>& onPoint) {
    const auto make = [layout](const BreakEvenPlan& p, double share, bool with) {
        return MakeStaticShareWorld(p, layout, share, with);
    };
    return MeasureAll(
        plan, make, [](const scree::Profile& p) { return p.broadPhase; }, onPoint);
}

std::vector<BreakEvenPoint> MeasureFastShare(const BreakEvenPlan& plan, const std::function<void()>& onPoint) {
    return MeasureAll(
        plan, MakeFastShareWorld, [](const scree::Profile& p) { return p.step; }, onPoint);
}

std::vector<BreakEvenPoint> MeasureIsolatedShare(const BreakEvenPlan& plan, int substeps,
                                                 const std::function<void()>& onPoint) {
    return MeasureAll(
        plan, MakeIsolatedShareWorld, [](const scree::Profile& p) { return p.islands + p.solver; }, onPoint, substeps);
}

}  // namespace testbed
