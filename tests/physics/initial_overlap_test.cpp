// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies that are made in each other part under the soft step without being thrown, alike with any number of sub-steps.
// Sizes, masses, counts and places vary at random.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

constexpr int substepCounts[] = {2, 4, 8, 16, 32};

struct Chance {
    std::mt19937 engine;
    explicit Chance(unsigned seed) : engine(seed) {}
    double In(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
};

Body* AddBrick(Lab<Ours>& lab, double x, double y, double width, double height, double density = 1.0) {
    Body* body = lab.Dynamic(x, y);
    AttachBox<Ours>(body, 0.5 * width, 0.5 * height, {density, 0.6});
    return body;
}

struct Squeezed {
    int rows;
    double width, height, pitch;
    double squeeze;  ///< of each row into the one below, m
    bool isColumn;
};

struct Rise {
    double speed = 0.0, shift = 0.0, lacks = 0.0;  ///< m/s, m, m of the height at which all just touches
};

Rise LetRise(const Squeezed& pile, int substeps) {
    Lab<Ours> lab;
    lab.Ground(0.6);
    std::vector<std::pair<Body*, double>> bricks;
    for (int r = 0; r < pile.rows; ++r) {
        const int count = pile.isColumn ? 1 : pile.rows - r;
        for (int i = 0; i < count; ++i) {
            const double x = pile.pitch * (i - 0.5 * (count - 1));
            const double y = pile.height * (r + 0.5) - pile.squeeze * (r + 1);
            bricks.emplace_back(AddBrick(lab, x, y, pile.width, pile.height), x);
        }
    }
    Rise rise;
    for (int i = 0; i < 3 * stepRate; ++i) {
        lab.world.Step(static_cast<float>(h), substeps);
        for (const auto& [brick, x] : bricks) {
            rise.speed = std::max(rise.speed, Length(Speed(brick)));
            rise.shift = std::max(rise.shift, std::abs(Centre(brick).x - x));
        }
    }
    rise.lacks = pile.height * (pile.rows - 0.5) - Centre(bricks.back().first).y;
    return rise;
}

TEST(InitialOverlap, SqueezedPilesRiseWithoutAThrow) {
    Chance chance(21);
    for (int round = 0; round < 8; ++round) {
        Squeezed pile{.rows = static_cast<int>(chance.In(5.0, 19.0)),
                      .width = chance.In(0.8, 1.2),
                      .height = chance.In(0.5, 0.9),
                      .pitch = 0.0,
                      .squeeze = chance.In(0.01, 0.08),
                      .isColumn = round % 4 == 3};
        pile.pitch = pile.width * chance.In(1.02, 1.12);
        for (const int substeps : substepCounts) {
            SCOPED_TRACE(testing::Message() << round << ": " << pile.rows << " rows squeezed by " << pile.squeeze
                                            << " m, " << substeps << " sub-steps");
            const Rise rise = LetRise(pile, substeps);
            EXPECT_LT(rise.speed, 1.0);
            EXPECT_LT(rise.shift, substeps < 4 ? 0.1 : 0.05);  // two are less than any mark has
            EXPECT_LT(std::abs(rise.lacks), 0.01 * pile.height * pile.rows);
        }
    }
}

/// In free space the centre of mass stays, and nothing moves once all are apart.
TEST(InitialOverlap, TwoBodiesPartWithoutSpeed) {
    Chance chance(22);
    for (int round = 0; round < 30; ++round) {
        const double angle = chance.In(0.0, 6.0), width = chance.In(0.3, 1.5),
                     density = std::pow(10.0, chance.In(-1, 2));
        const Point at{chance.In(-0.3, 0.3), chance.In(-0.3, 0.3)};
        for (const int substeps : substepCounts) {
            Lab<Ours> lab(0.0);
            Body* a = AddBrick(lab, 0.0, 0.0, 1.0, 1.0);
            Body* b = lab.Dynamic(at.x, at.y, angle);
            AttachBox<Ours>(b, 0.5 * width, 0.4, {density, 0.3});
            const auto centre = [&] {
                const double mA = double{a->GetMass()}, mB = double{b->GetMass()};
                return (1.0 / (mA + mB)) * (mA * Centre(a) + mB * Centre(b));
            };
            const Point before = centre();
            for (int i = 0; i < stepRate; ++i) {
                lab.world.Step(static_cast<float>(h), substeps);
                ASSERT_LT(Length(Speed(a)) + Length(Speed(b)), 0.05) << round << " " << substeps << " " << i;
            }
            EXPECT_LT(Length(centre() - before), 1e-3) << round << " " << substeps;
            EXPECT_LT(lab.world.MeasureErrors().overlap, 0.01f) << round << " " << substeps;
        }
    }
}

/// A crowd on one spot is not shot out of its bin.
TEST(InitialOverlap, ACrowdStaysInItsBin) {
    Chance chance(23);
    for (const int substeps : substepCounts) {
        Lab<Ours> lab;
        Body* bin = lab.Static();
        for (const Point side : {Point{-6.0, 10.0}, Point{6.0, 10.0}}) {
            PolygonShape wall;
            wall.SetAsBox(0.5f, 12.0f, Lab<Ours>::At(side.x, side.y), 0.0f);
            bin->CreateFixture(&wall, 0.0f);
        }
        PolygonShape floor;
        floor.SetAsBox(8.0f, 0.5f, Lab<Ours>::At(0.0, -0.5), 0.0f);
        bin->CreateFixture(&floor, 0.0f);
        std::vector<Body*> bodies;
        for (int i = 0; i < 100; ++i) {
            const double size = chance.In(0.2, 0.6);
            bodies.push_back(AddBrick(lab, chance.In(-0.2, 0.2), 3.0 + chance.In(-0.2, 0.2), size, size));
        }
        double fastest = 0.0;
        for (int i = 0; i < 4 * stepRate; ++i) {
            lab.world.Step(static_cast<float>(h), substeps);
            for (const Body* body : bodies) fastest = std::max(fastest, Length(Speed(body)));
        }
        for (const Body* body : bodies) {
            EXPECT_LT(std::abs(Centre(body).x), 5.5) << substeps;
            EXPECT_GT(Centre(body).y, 0.0) << substeps;
        }
        EXPECT_LT(fastest, 15.0) << substeps;  // a fall from 10 m
    }
}

}  // namespace
}  // namespace scree::test
