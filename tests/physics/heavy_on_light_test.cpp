// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Loads on far lighter bodies under the soft step: the light ones hold them where they lie, whatever the ratio of
// masses, and alike with more sub-steps. Nothing gains or loses momentum where nobody holds it. Sizes, ratios, shapes
// and sub-steps vary at random.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

class Draw {
public:
    explicit Draw(unsigned seed) : m_engine(seed) {}
    double In(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_engine); }
    int Whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }
    /// A ratio of masses from 10 to a million.
    double Ratio() { return std::pow(10.0, In(1.0, 6.0)); }
    /// Two do not stop a load of a hundred thousand times on a column of several before it is through.
    int Substeps() { return Whole(3, 16); }

private:
    std::mt19937 m_engine;
};

Body* AddBox(Lab<Ours>& lab, double x, double y, double width, double height, double mass) {
    Body* body = lab.Dynamic(x, y);
    AttachBox<Ours>(body, 0.5 * width, 0.5 * height, {.density = mass / (width * height), .friction = 0.6});
    return body;
}
Body* AddBall(Lab<Ours>& lab, double x, double y, double radius, double mass) {
    Body* body = lab.Dynamic(x, y);
    AttachDisk<Ours>(body, radius, {.density = mass / (circleRatio * radius * radius), .friction = 0.6});
    return body;
}
void AddFloor(Lab<Ours>& lab) { AttachBox<Ours>(lab.Static(0.0, -1.0), 40.0, 1.0, {.friction = 0.6}); }
void RunFor(Lab<Ours>& lab, int substeps, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * stepRate); ++i) lab.world.Step(static_cast<float>(h), substeps);
}

constexpr double sunkAtMost = 0.012;  ///< of a load by each body below it, m

TEST(HeavyOnLight, ColumnsBearIt) {
    Draw draw(1);
    for (int round = 0; round < 24; ++round) {
        Lab<Ours> lab;
        AddFloor(lab);
        const int count = draw.Whole(1, 6), substeps = draw.Substeps();
        const double width = draw.In(0.6, 1.5), ratio = draw.Ratio();
        double top = 0.0;
        for (int i = 0; i < count; ++i) {
            const double height = draw.In(0.3, 1.0);
            AddBox(lab, 0.0, top + 0.5 * height, width, height, draw.In(0.3, 1.0));
            top += height;
        }
        const double drop = draw.In(0.0, 0.3);
        Body* load = AddBox(lab, 0.0, top + 0.4 + drop, width, 0.8, ratio);
        RunFor(lab, substeps, 4.0);
        EXPECT_NEAR(Centre(load).y, top + 0.4, sunkAtMost * count) << count << " below " << ratio << ", " << substeps;
        EXPECT_LT(Length(Speed(load)), 0.01) << count << " below " << ratio << ", " << substeps;
    }
}

TEST(HeavyOnLight, LegsBearATable) {
    Draw draw(2);
    for (int round = 0; round < 16; ++round) {
        Lab<Ours> lab;
        AddFloor(lab);
        const int legs = draw.Whole(2, 5), substeps = draw.Substeps();
        const double height = draw.In(0.3, 1.0), ratio = draw.Ratio(), apart = draw.In(0.5, 1.0);
        for (int i = 0; i < legs; ++i) {
            AddBox(lab, apart * (i - 0.5 * (legs - 1)), 0.5 * height, 0.3, height, draw.In(0.5, 1.0));
        }
        Body* load = AddBox(lab, 0.0, height + 0.2 + draw.In(0.0, 0.2), apart * legs, 0.4, ratio);
        RunFor(lab, substeps, 3.0);
        EXPECT_NEAR(Centre(load).y, height + 0.2, sunkAtMost) << legs << " below " << ratio << ", " << substeps;
        EXPECT_NEAR(Angle(load), 0.0, 0.02) << legs << " below " << ratio << ", " << substeps;
    }
}

/// A ball below a slab that slides: both go on together, or the ball rolls.
TEST(HeavyOnLight, MomentumIsKeptWithoutGround) {
    Draw draw(3);
    for (int round = 0; round < 24; ++round) {
        Lab<Ours> lab;
        const int substeps = draw.Substeps();
        const double ratio = draw.Ratio(), speed = draw.In(1.0, 5.0);
        Body* light = AddBox(lab, draw.In(-0.2, 0.2), 0.0, 0.5, 0.5, 1.0);
        Body* load = AddBox(lab, 0.0, 0.8, 1.0, 1.0, ratio);
        load->SetLinearVelocity(Lab<Ours>::At(draw.In(-1.0, 1.0), -speed));
        const auto momentum = [&] {
            const double m = double{light->GetMass()}, heavy = double{load->GetMass()};
            return m * Speed(light) + heavy * Speed(load);
        };
        const Point before = momentum();
        RunFor(lab, substeps, 0.25);
        const double mass = double{light->GetMass()} + double{load->GetMass()}, time = std::floor(0.25 * stepRate) * h;
        const Point after = momentum() - mass * Point{0.0, -g * time};
        const double scale = Length(before);
        EXPECT_NEAR(after.x, before.x, 1e-3 * scale) << ratio << ", " << substeps;
        EXPECT_NEAR(after.y, before.y, 1e-3 * scale) << ratio << ", " << substeps;
        EXPECT_LT(Centre(light).y, Centre(load).y - 0.5) << "it lies still below the load";
    }
}

TEST(HeavyOnLight, RollersBearASlabAndLetItRoll) {
    Draw draw(4);
    for (int round = 0; round < 12; ++round) {
        Lab<Ours> lab;
        AddFloor(lab);
        const int substeps = draw.Whole(4, 16);
        const double ratio = draw.Ratio(), radius = draw.In(0.2, 0.4), speed = draw.In(0.5, 2.0);
        for (int i = -1; i <= 1; ++i) AddBall(lab, 1.5 * i, radius, radius, 1.0);
        Body* load = AddBox(lab, 0.0, 2.0 * radius + 0.2, 5.0, 0.4, ratio);
        load->SetLinearVelocity(Lab<Ours>::At(speed, 0.0));
        RunFor(lab, substeps, 0.5);
        EXPECT_NEAR(Centre(load).y, 2.0 * radius + 0.2, sunkAtMost) << ratio << ", " << substeps;
        // Rollers take a share of the order of their masses.
        EXPECT_GT(Speed(load).x, (1.0 - 6.0 / ratio) * speed - 0.02 * speed) << ratio << ", " << substeps;
        EXPECT_LT(Speed(load).x, 1.001 * speed) << ratio << ", " << substeps;
    }
}

}  // namespace
}  // namespace scree::test
