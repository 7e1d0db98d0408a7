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

}  // namespace
}  // namespace scree::test
