// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Heavy loads that fall on bridges and ladders of light planks. No energy comes of it and joints hold with any number
// of sub-steps, also where a load breaks through. From the mark of games on bridges bear loads, the better the more
// sub-steps there are. Lengths, loads and heights vary at random.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

constexpr double plankLength = 0.5, plankHeight = 0.125;  ///< m

struct Fall {
    int planks;
    double load;    ///< masses of a plank
    double height;  ///< of the fall, m
    double turn;    ///< of the load, rad
    int strands = 1;
    bool isWelded = false;
};

Fall DrawFall(std::mt19937& engine, int strands, bool isWelded) {
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    return {static_cast<int>(in(5.0, 40.0)),
            std::pow(10.0, in(1.0, 3.0)),
            in(0.0, 1.0),
            in(0.0, 1.0) < 0.5 ? 0.0 : in(-0.3, 0.3),
            strands,
            isWelded};
}

struct Worst {
    double gain = 0.0;  ///< of energy, in weights of the load times a metre
    double gap = 0.0;   ///< of a joint, m
    double sunk = 0.0;  ///< the load at the end, below where it touched, m
};

Worst LetFall(const Fall& fall, int substeps) {
    Lab<Ours> lab;
    std::vector<Body*> bodies;
    std::vector<Pin<Ours>> pins;
    const double length = plankLength * fall.planks;
    Body* anchors[] = {lab.Static(), lab.Static(length)};
    const auto hold = [&](Body* a, Body* b, double x, double y) {
        if (!fall.isWelded) return pins.push_back(lab.Hinge(a, b, x, y));
        WeldJointDef def;
        def.Initialize(a, b, Lab<Ours>::At(x, y));
        lab.world.CreateJoint(&def);
    };
    std::vector<Body*> above;
    for (int strand = 0; strand < fall.strands; ++strand) {
        const double y = -0.5 * strand;
        std::vector<Body*> row;
        Body* last = anchors[0];
        for (int i = 0; i < fall.planks; ++i) {
            const double x = plankLength * (i + 0.5);
            Body* plank = lab.Dynamic(x, y);
            AttachBox<Ours>(plank, 0.5 * plankLength, 0.5 * plankHeight, {.friction = 0.6});
            hold(last, plank, plankLength * i, y);
            if (strand > 0) {  // a rod to the plank above
                DistanceJointDef def;
                def.Initialize(above[static_cast<size_t>(i)], plank, Lab<Ours>::At(x, y + 0.5), Lab<Ours>::At(x, y));
                def.minLength = def.maxLength = def.length;
                lab.world.CreateJoint(&def);
            }
            row.push_back(last = plank);
        }
        hold(last, anchors[1], length, y);
        bodies.insert(bodies.end(), row.begin(), row.end());
        above = row;
    }
    Body* load = lab.Dynamic(0.5 * length, 0.5 * plankHeight + 0.75 + fall.height, fall.turn);
    AttachBox<Ours>(load, 0.75, 0.5, {.density = fall.load * plankLength * plankHeight / 1.5, .friction = 0.6});
    bodies.push_back(load);
    const auto energy = [&] {
        double sum = 0.0;
        for (const Body* b : bodies) {
            const double w = Spin(b), m = double{b->GetMass()};
            sum += m * (0.5 * Dot(Speed(b), Speed(b)) + g * Centre(b).y) + 0.5 * double{b->GetInertia()} * w * w;
        }
        return sum;
    };
    const double start = energy(), unit = g * double{load->GetMass()};
    Worst worst;
    for (int i = 0; i < 2 * stepRate; ++i) {
        lab.world.Step(static_cast<float>(h), substeps);
        worst.gain = std::max(worst.gain, (energy() - start) / unit);
        for (const Pin<Ours>& pin : pins) worst.gap = std::max(worst.gap, pin.Gap());
    }
    worst.sunk = 0.5 * plankHeight + 0.5 - Centre(load).y;
    return worst;
}

void ExpectNoGain(unsigned seed, int rounds, int strands, bool isWelded) {
    std::mt19937 engine(seed);
    for (int round = 0; round < rounds; ++round) {
        const Fall fall = DrawFall(engine, strands, isWelded);
        for (const int substeps : {1, 2, 4, 8, 10, 16}) {
            const Worst worst = LetFall(fall, substeps);
            EXPECT_LT(worst.gain, 1e-3) << fall.planks << " planks, load " << fall.load << ", " << substeps;
            EXPECT_LT(worst.gap, 2e-3) << fall.planks << " planks, load " << fall.load << ", " << substeps;
        }
    }
}

TEST(Bridges, BearALoadTheBetterTheMoreSubsteps) {
    std::mt19937 engine(4);
    for (int round = 0; round < 12; ++round) {
        Fall fall = DrawFall(engine, 1, false);
        fall.load = std::pow(fall.load, 0.8), fall.turn = 0.0;  // 6 to 250 planks
        double before = 0.3;
        for (const int substeps : {4, 8, 16}) {
            const double sunk = LetFall(fall, substeps).sunk;
            EXPECT_LT(sunk, before + 0.01) << fall.planks << " planks, load " << fall.load << ", " << substeps;
            before = sunk;
        }
    }
}

TEST(Bridges, GainNoEnergyFromALoad) { ExpectNoGain(1, 12, 1, false); }
TEST(Bridges, WeldedOnesGainNone) { ExpectNoGain(2, 6, 1, true); }
TEST(Bridges, LaddersGainNone) { ExpectNoGain(3, 6, 2, false); }

}  // namespace
}  // namespace scree::test
