// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Piles at rest: what each interface of a column and each row of a pyramid carries, how far bodies sink, how still and
// how symmetric they are.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/physics/lab.h"

namespace scree::test {
namespace {

constexpr double side = 1.0;  ///< of the boxes, m
/// Of two centres at rest: two skins of 1 cm less one slop, or, in the soft step, outlines that touch.
double Apart() { return runsSoftStep ? 0.0 : 0.015; }
double RestDistance() { return side + Apart(); }
/// Of two centres that just touch.
double TouchDistance() { return side + (runsSoftStep ? 0.0 : 0.02); }
constexpr int window = 30;  ///< steps over which forces are averaged

/// Sums what contacts whose upper body is at level k carry over `window` steps; mean forces in N.
template <class E>
std::vector<double> MeanForces(Lab<E>& lab, int levels) {
    std::vector<double> force(static_cast<size_t>(levels), 0.0);
    for (int i = 0; i < window; ++i) {
        lab.Step();
        for (auto* c = lab.world.GetContactList(); c; c = c->GetNext()) {
            const double upper = std::max(Centre(c->GetFixtureA()->GetBody()).y, Centre(c->GetFixtureB()->GetBody()).y);
            const auto level = static_cast<size_t>(std::lround((upper - 0.5 * side) / RestDistance()));
            const auto given = c->GetManifold();
            const auto manifold = [&] {
                if constexpr (std::is_pointer_v<decltype(given)>) {
                    return *given;
                } else {
                    return given;
                }
            }();
            for (int p = 0; p < manifold.pointCount; ++p)
                force.at(level) += static_cast<double>(manifold.points[p].normalImpulse) / h / window;
        }
    }
    return force;
}

/// Root mean square speed over a second.
template <class E>
double Unrest(Lab<E>& lab, const std::vector<typename E::Body*>& bodies) {
    double sum = 0.0;
    for (int i = 0; i < stepRate; ++i) {
        lab.Step();
        for (const auto* body : bodies) sum += Dot(Speed(body), Speed(body));
    }
    return std::sqrt(sum / (static_cast<double>(bodies.size()) * stepRate));
}

struct Pile {
    double force = 0.0, bottom = 0.0, overlap = 0.0, asymmetry = 0.0, unrest = 0.0;
};

template <class E>
Pile StandColumn(int count) {
    Lab<E> lab;
    lab.Ground();
    std::vector<typename E::Body*> boxes;
    for (int i = 0; i < count; ++i) {
        boxes.push_back(lab.Dynamic(0.0, 0.5 * side + Apart() + RestDistance() * i));
        AttachBox<E>(boxes.back(), 0.5 * side, 0.5 * side);
    }
    lab.Step(2 * stepRate);
    const std::vector<double> forces = MeanForces<E>(lab, count);
    const double weight = static_cast<double>(boxes.front()->GetMass()) * g;
    Pile pile;
    for (int i = 0; i < count; ++i) {
        const double carried = weight * (count - i);
        pile.force = std::max(pile.force, std::abs(forces[static_cast<size_t>(i)] - carried) / carried);
    }
    for (size_t i = 1; i < boxes.size(); ++i)
        pile.overlap = std::max(pile.overlap, TouchDistance() - (Centre(boxes[i]).y - Centre(boxes[i - 1]).y));
    for (const auto* box : boxes) pile.asymmetry = std::max(pile.asymmetry, std::abs(Centre(box).x));
    pile.unrest = Unrest<E>(lab, boxes);
    return pile;
}

TEST(PileLaws, AColumnOfTenCarriesItsWeight) {
    const auto pile = Measure([]<class E>(E) { return StandColumn<E>(10); });
    Judge({"column of 10: worst interface force after 2 s, relative error", 0.0, 0.02, 1e-4}, Pick(pile, &Pile::force));
    Judge({"column of 10: worst overlap, m", 0.0, 0.010, 1e-5}, Pick(pile, &Pile::overlap));
    // Clipping rounds the two contact points of a face apart and a column adds this up: 1e-4 m is that level.
    Judge({"column of 10: worst sideways shift, m", 0.0, 1e-3, 1e-4}, Pick(pile, &Pile::asymmetry));
    Judge({"column of 10: v_rms after 2.5 s, m/s", 0.0, 1e-2, 1e-5}, Pick(pile, &Pile::unrest));
}

template <class E>
Pile StandPyramid(int base) {
    Lab<E> lab;
    lab.Ground();
    std::vector<std::vector<typename E::Body*>> rows(static_cast<size_t>(base));
    std::vector<typename E::Body*> boxes;
    for (int r = 0; r < base; ++r) {
        for (int i = 0; i < base - r; ++i) {
            const double x = 1.125 * (i - 0.5 * (base - r - 1));
            boxes.push_back(lab.Dynamic(x, 0.5 * side + Apart() + RestDistance() * r));
            AttachBox<E>(boxes.back(), 0.5 * side, 0.5 * side, {1.0, 0.6});
            rows[static_cast<size_t>(r)].push_back(boxes.back());
        }
    }
    lab.Step(10 * stepRate);
    const std::vector<double> forces = MeanForces<E>(lab, base);
    const double weight = static_cast<double>(boxes.front()->GetMass()) * g;
    Pile pile;
    for (int r = 0; r < base; ++r) {
        const double carried = weight * 0.5 * (base - r) * (base - r + 1);
        const double error = std::abs(forces[static_cast<size_t>(r)] - carried) / carried;
        pile.force = std::max(pile.force, error);
        if (r == 0) pile.bottom = error;
        const auto& row = rows[static_cast<size_t>(r)];
        for (size_t i = 0; i < row.size(); ++i) {
            const Point left = Centre(row[i]), right = Centre(row[row.size() - 1 - i]);
            pile.asymmetry = std::max(pile.asymmetry, Length({left.x + right.x, left.y - right.y}));
            if (r > 0) {
                const double below = Centre(rows[static_cast<size_t>(r) - 1][i]).y;
                pile.overlap = std::max(pile.overlap, TouchDistance() - (left.y - below));
            }
        }
    }
    pile.unrest = Unrest<E>(lab, boxes);
    return pile;
}

TEST(PileLaws, APyramidOfBaseTenCarriesItsWeightSymmetricallyAndIsStill) {
    const auto pile = Measure([]<class E>(E) { return StandPyramid<E>(10); });
    Judge({"pyramid of base 10: worst row force after 10 s, relative error", 0.0, 0.02, 1e-4},
          Pick(pile, &Pile::force));
    Judge({"pyramid of base 10: force on the ground, relative error", 0.0, 0.02, 1e-4}, Pick(pile, &Pile::bottom));
    Judge({"pyramid of base 10: worst overlap, m", 0.0, 0.010, 1e-5}, Pick(pile, &Pile::overlap));
    Judge({"pyramid of base 10: worst asymmetry of positions, m", 0.0, unbounded, 1e-5}, Pick(pile, &Pile::asymmetry));
    Judge({"pyramid of base 10: v_rms after 10 s, m/s", 0.0, 1e-2, 1e-5}, Pick(pile, &Pile::unrest));
}

/// 8/3 leaves an overlap of a slop alone: either end of a row may lie lower by that for each row below it. The soft
/// step leaves none. Sizes are below and above those from which contacts are solved side by side.
TEST(PileLaws, PyramidsLeanByNoMoreThanTheirSlops) {
    for (int base = 3; base <= 20; ++base) {
        const Pile pile = StandPyramid<Ours>(base);
        EXPECT_LE(pile.asymmetry, linearSlop * (base - 1)) << base;
        EXPECT_LE(pile.force, 0.02) << base;
        EXPECT_LE(pile.overlap, 0.01) << base;
        EXPECT_LE(pile.unrest, 0.01) << base;
    }
}

}  // namespace
}  // namespace scree::test
