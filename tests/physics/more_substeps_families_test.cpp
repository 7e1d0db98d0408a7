// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Never worse with more sub-steps, over families of which each member is drawn at random: columns, chains under a load
// and arches, with 2 to 16 sub-steps. Bridges are in bridge_test.cpp, nets in net_test.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

class Draws {
public:
    explicit Draws(unsigned seed) : m_engine(seed) {}
    double In(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_engine); }
    int Whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

private:
    std::mt19937 m_engine;
};

/// `error` of the number of sub-steps. Below `seen` it does not matter.
void ExpectNoWorse(const std::string& what, double seen, const std::function<double(int substeps)>& error) {
    double before = error(2);
    for (const int substeps : {4, 8, 16}) {
        const double now = error(substeps);
        EXPECT_LE(now, std::max(1.1 * before, seen)) << what << ", " << substeps << " sub-steps, before " << before;
        before = now;
    }
}

/// How far the top of a column leans at most in six seconds, m.
double LeanOf(int count, double width, double height, double off, unsigned seed, int substeps) {
    Draws draws(seed);
    Lab<Ours> lab;
    lab.Ground(0.6);
    Body* top = nullptr;
    for (int i = 0; i < count; ++i) {
        top = lab.Dynamic(draws.In(-off, off), height * (i + 0.5));
        AttachBox<Ours>(top, 0.5 * width, 0.5 * height, {.friction = 0.6});
    }
    double lean = 0.0;
    for (int i = 0; i < 6 * stepRate; ++i) {
        lab.world.Step(static_cast<float>(h), substeps);
        lean = std::max(lean, std::abs(Centre(top).x));
    }
    return lean;
}

TEST(MoreSubstepsFamilies, ColumnsLeanNoMore) {
    Draws draws(1);
    for (int round = 0; round < 40; ++round) {
        const int count = draws.Whole(5, 45);
        const double width = draws.In(0.7, 1.1), height = draws.In(0.6, 0.9), off = draws.In(0.0, 0.02);
        const auto seed = static_cast<unsigned>(100 + round);
        ExpectNoWorse("column of " + std::to_string(count), 0.1 * width,
                      [&](int substeps) { return LeanOf(count, width, height, off, seed, substeps); });
    }
}

/// The widest gap of a chain with a load that is let go, m.
double GapOf(int links, double load, double angle, double seconds, int substeps) {
    Lab<Ours> lab;
    const double length = 0.5;
    const Point along{std::cos(angle), std::sin(angle)};
    std::vector<Pin<Ours>> pins;
    Body* last = lab.Static();
    for (int i = 0; i <= links; ++i) {
        const bool isLoad = i == links;
        const double at = length * (isLoad ? i : i + 0.5);
        Body* body = lab.Dynamic(along.x * at, along.y * at, angle);
        const auto box = BoxShape<Ours>(0.25f, isLoad ? 0.25f : 0.06f);
        FixtureDef def;
        def.shape = &box;
        def.density = isLoad ? static_cast<float>(load * 0.06 / 0.25) : 1.0f;
        def.filter.groupIndex = -1;
        body->CreateFixture(&def);
        pins.push_back(lab.Hinge(last, body, along.x * length * i, along.y * length * i));
        last = body;
    }
    double gap = 0.0;
    for (int i = 0; i < static_cast<int>(seconds * stepRate); ++i) {
        lab.world.Step(static_cast<float>(h), substeps);
        for (const Pin<Ours>& pin : pins) gap = std::max(gap, pin.Gap());
    }
    return gap;
}

TEST(MoreSubstepsFamilies, LoadedChainsOpenNoMore) {
    Draws draws(2);
    for (int round = 0; round < 40; ++round) {
        const int links = draws.Whole(4, 20);
        const double load = std::pow(10.0, draws.In(1.5, 4.0)), angle = draws.In(-1.5, 0.2);
        ExpectNoWorse(std::to_string(links) + " links, load " + std::to_string(load), 1e-4,
                      [&](int substeps) { return GapOf(links, load, angle, 3.0, substeps); });
    }
}

/// How far the crown of an arch sinks in four seconds, m; as far as it is high if it falls.
double SinkOf(int stones, double thickness, int substeps) {
    Lab<Ours> lab;
    lab.Ground(0.8);
    const double inner = 4.0, outer = inner * (1.0 + thickness);
    Body* crown = nullptr;
    for (int i = 0; i < stones; ++i) {
        const double from = circleRatio * i / stones, to = circleRatio * (i + 1) / stones, middle = 0.5 * (from + to);
        const Point at{0.5 * (inner + outer) * std::cos(middle), 0.5 * (inner + outer) * std::sin(middle)};
        const auto corner = [&](double radius, double angle) {
            return Lab<Ours>::At(radius * std::cos(angle) - at.x, radius * std::sin(angle) - at.y);
        };
        const Vec2 corners[] = {corner(inner, from), corner(outer, from), corner(outer, to), corner(inner, to)};
        PolygonShape stone;
        EXPECT_TRUE(stone.Set(corners, 4));
        Body* body = lab.Dynamic(at.x, at.y);
        AttachShape<Ours>(body, stone, {.friction = 0.8});
        if (i == stones / 2) crown = body;
    }
    const double built = Centre(crown).y;
    for (int i = 0; i < 4 * stepRate; ++i) lab.world.Step(static_cast<float>(h), substeps);
    return built - Centre(crown).y;
}

TEST(MoreSubstepsFamilies, ArchesSinkNoMore) {
    Draws draws(3);
    for (int round = 0; round < 40; ++round) {
        const int stones = 2 * draws.Whole(4, 15) + 1;
        const double thickness = draws.In(0.13, 0.3);
        ExpectNoWorse("arch of " + std::to_string(stones), 0.01,
                      [&](int substeps) { return SinkOf(stones, thickness, substeps); });
    }
}

}  // namespace
}  // namespace scree::test
