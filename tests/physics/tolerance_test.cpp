// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Steps with a tolerance hold what the mark of games holds: pyramids shift no more and columns lean no more, and they
// end with less overlap than asked. Sizes and tolerances vary at random.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

struct End {
    double shift = 0.0;    ///< of any body to the side, m
    double fall = 0.0;     ///< of any body, m
    double overlap = 0.0;  ///< in the last step, m
};

/// Lets bodies rest that stand as they were built. A tolerance of 0: at the mark of games.
End Rest(Lab<Ours>& lab, const std::vector<Body*>& bodies, double seconds, double tolerance) {
    lab.world.SetMeasureErrors(true);
    std::vector<Point> built;
    for (const Body* body : bodies) built.push_back(Centre(body));
    End end;
    for (int i = 0; i < static_cast<int>(seconds * stepRate); ++i) {
        const auto step = static_cast<float>(h);
        const auto asked = static_cast<float>(tolerance);
        const StepReport report =
            tolerance > 0.0 ? lab.world.Step(step, Tolerance{.overlap = asked}) : lab.world.Step(step, Accuracy::game);
        end.overlap = double{report.errors.overlap};
    }
    for (size_t i = 0; i < bodies.size(); ++i) {
        const Point now = Centre(bodies[i]);
        end.shift = std::max(end.shift, std::abs(now.x - built[i].x));
        end.fall = std::max(end.fall, built[i].y - now.y);
    }
    return end;
}

End BuildPyramid(int rows, double pitch, double height, double tolerance) {
    Lab<Ours> lab;
    lab.Ground(0.6);
    std::vector<Body*> bricks;
    for (int r = 0; r < rows; ++r) {
        for (int i = 0; i < rows - r; ++i) {
            Body* brick = lab.Dynamic(pitch * (i - 0.5 * (rows - 1 - r)), height * (r + 0.5));
            AttachBox<Ours>(brick, 0.5, 0.5 * height, {.friction = 0.6});
            bricks.push_back(brick);
        }
    }
    return Rest(lab, bricks, 3.0, tolerance);
}

/// As the house of cards of the extremes, all just touching.
End BuildCards(int levels, double tolerance) {
    Lab<Ours> lab;
    lab.Ground(0.9);
    std::vector<Body*> cards;
    const double half = 0.5, thick = 0.02, lean = 0.35;
    const double rise = half * std::cos(lean) + thick * std::sin(lean);
    const double reach = half * std::sin(lean) + thick * std::cos(lean);
    const auto add = [&](double x, double y, double hx, double hy, double angle) {
        cards.push_back(lab.Dynamic(x, y, angle));
        AttachBox<Ours>(cards.back(), hx, hy, {.friction = 0.9});
    };
    for (int level = 0; level < levels; ++level) {
        const double bottom = level * (2.0 * rise + 2.0 * thick);
        for (int pair = 0; pair < levels - level; ++pair) {
            const double x = (pair - 0.5 * (levels - level - 1)) * 4.0 * reach;
            add(x - reach, bottom + rise, thick, half, -lean), add(x + reach, bottom + rise, thick, half, lean);
            if (pair > 0) add(x - 2.0 * reach, bottom + 2.0 * rise + thick, 2.2 * reach, thick, 0.0);
        }
    }
    return Rest(lab, cards, 5.0, tolerance);
}

TEST(Tolerance, ShiftsPyramidsNoMoreThanGames) {
    std::mt19937 engine(1);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    for (int round = 0; round < 5; ++round) {
        const int rows = static_cast<int>(in(30.0, 60.0));
        const double pitch = in(1.02, 1.2), height = in(0.7, 0.9), tolerance = in(0.007, 0.01);
        const End game = BuildPyramid(rows, pitch, height, 0.0);
        const End tolerant = BuildPyramid(rows, pitch, height, tolerance);
        EXPECT_LT(tolerant.shift, 1.1 * game.shift) << rows << " " << pitch << " " << tolerance;
        EXPECT_LT(tolerant.overlap, tolerance) << rows << " " << pitch;
    }
}

TEST(Tolerance, KeepsAHouseOfCards) {
    for (const int levels : {2, 3, 5}) EXPECT_LT(BuildCards(levels, 0.01).fall, 0.05) << levels;
}

/// Energy that a taut bridge gains at most while a load falls onto it, in shares of the load's.
double GainOfBridge(int planks, double mass, double tolerance) {
    Lab<Ours> lab;
    Body* ground = lab.Static();
    Body* last = ground;
    std::vector<Body*> bodies;
    for (int i = 0; i < planks; ++i) {
        Body* plank = lab.Dynamic(0.5 * (i + 0.5), 0.0);
        AttachBox<Ours>(plank, 0.25, 0.0625);
        lab.Hinge(last, plank, 0.5 * i, 0.0);
        bodies.push_back(last = plank);
    }
    lab.Hinge(last, ground, 0.5 * planks, 0.0);
    bodies.push_back(lab.Dynamic(0.25 * planks, 1.0));
    AttachBox<Ours>(bodies.back(), 0.75, 0.5, {.density = mass / 1.5});
    const auto energy = [&] {
        double sum = 0.0;
        for (const Body* b : bodies) {
            const double w = Spin(b), inertia = double{b->GetInertia()};
            sum += double{b->GetMass()} * (0.5 * Dot(Speed(b), Speed(b)) + g * Centre(b).y) + 0.5 * inertia * w * w;
        }
        return sum;
    };
    const double start = energy();
    double gain = 0.0;
    for (int i = 0; i < 4 * stepRate; ++i) {
        lab.world.Step(static_cast<float>(h), Tolerance{.overlap = static_cast<float>(tolerance)});
        gain = std::max(gain, energy() - start);
    }
    return gain / (mass * g);
}

/// The pull rises at once, and with it the number of sub-steps.
TEST(Tolerance, TautBridgesGainNoEnergy) {
    std::mt19937 engine(2);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    for (int round = 0; round < 8; ++round) {
        const int planks = static_cast<int>(in(20.0, 80.0));
        const double mass = in(5.0, 60.0), tolerance = in(0.007, 0.02);
        EXPECT_LT(GainOfBridge(planks, mass, tolerance), 0.01) << planks << " " << mass << " " << tolerance;
    }
}

/// Speed of the fastest ball after ten seconds, m/s. A net is at rest as it is made.
double SpeedOfNet(int width, int height, double gap) {
    Lab<Ours> lab;
    std::vector<Body*> above(static_cast<size_t>(width)), balls;
    for (Body*& anchor : above) anchor = lab.Static();
    for (int y = 1; y < height; ++y) {
        Body* left = nullptr;
        for (int x = 0; x < width; ++x) {
            Body* ball = lab.Dynamic(x, -y);
            AttachDisk<Ours>(ball, 0.25);
            lab.Hinge(above[static_cast<size_t>(x)], ball, x, 0.5 - y);
            if (left != nullptr) lab.Hinge(left, ball, x - 0.5, -y);
            balls.push_back(above[static_cast<size_t>(x)] = left = ball);
        }
    }
    const Tolerance tolerance{.jointGap = static_cast<float>(gap)};
    for (int i = 0; i < 10 * stepRate; ++i) lab.world.Step(static_cast<float>(h), tolerance);
    double speed = 0.0;
    for (const Body* ball : balls) speed = std::max(speed, Length(Speed(ball)));
    return speed;
}

/// Sub-steps must not go up and down for ever: each change moves what hangs.
TEST(Tolerance, NetsComeToRest) {
    std::mt19937 engine(3);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    for (int round = 0; round < 5; ++round) {
        const int width = static_cast<int>(in(5.0, 25.0)), height = static_cast<int>(in(10.0, 25.0));
        const double gap = in(0.0007, 0.002);
        EXPECT_LT(SpeedOfNet(width, height, gap), 0.05) << width << " " << height << " " << gap;
    }
}

}  // namespace
}  // namespace scree::test
