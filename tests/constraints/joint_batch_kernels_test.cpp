// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the kernels of the direct joint solve say of each body, against the same in plain numbers.

#include "constraints/joint_batch_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace scree {

namespace {

/// Bodies without joints, so that each is a root.
class LooseBodies {
public:
    explicit LooseBodies(int count)
        : velocity(Rows(count)),
          aimed(Rows(count)),
          mass(Rows(count)),
          shift(Rows(count)),
          impulse(Rows(count)),
          left(Rows(count) / jointLanes),
          roots(Rows(count)) {
        for (size_t i = 0; i < roots.size(); ++i) roots[i] = static_cast<int32_t>(i);
    }
    JointBatchTask Task(double h) {
        JointBatchTask task{};
        task.bodyCount = static_cast<int32_t>(velocity.size());
        task.velocity = velocity.data(), task.aimed = aimed.data(), task.mass = mass.data();
        task.shift = shift.data(), task.impulse = impulse.data(), task.left = left.data();
        task.roots = roots.data(), task.rootCount = task.bodyCount;
        task.h = h;
        return task;
    }

    std::vector<BodyRow> velocity, aimed, mass, shift, impulse;
    std::vector<LaneRow> left;
    std::vector<int32_t> roots;

private:
    static size_t Rows(int count) { return static_cast<size_t>((count + jointLanes - 1) / jointLanes * jointLanes); }
};

/// What an aim leaves of an error is the turn that it changed, of the body itself, times the turn that comes of it.
TEST(JointBatchKernels, AnAimTellsWhatTheTurnOfEachBodyLeaves) {
    std::mt19937 random(std::random_device{}());
    const auto draw = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
    for (int round = 0; round < 100; ++round) {
        LooseBodies bodies(std::uniform_int_distribution<int>(1, 40)(random));
        for (size_t i = 0; i < bodies.velocity.size(); ++i) {
            bodies.velocity[i] = {{draw(-9.0, 9.0), draw(-9.0, 9.0), draw(-9.0, 9.0), 0.0}};
            bodies.aimed[i] = {{draw(-9.0, 9.0), draw(-9.0, 9.0), draw(-9.0, 9.0), 0.0}};
            bodies.mass[i] = {{draw(0.0, 2.0), draw(0.0, 2.0), draw(0.0, 2.0), 1.0}};
        }
        const std::vector<BodyRow> before = bodies.aimed;
        const double h = draw(1e-3, 2e-2);
        const double largest = GetJointBatchKernels().aim(bodies.Task(h));
        double expectedLargest = 0.0;
        for (size_t i = 0; i < before.size(); ++i) {
            const double spin = bodies.velocity[i].v[2], turn = std::abs(spin - before[i].v[2]);
            const double expected = h * h * turn * (std::abs(spin) + turn);
            const double left = bodies.left[i / jointLanes].v[i % jointLanes];
            ASSERT_NEAR(left, expected, 1e-12 * expected) << "body " << i << " of " << before.size();
            ASSERT_EQ(bodies.aimed[i].v[2], spin);
            expectedLargest = std::max(expectedLargest, expected);
        }
        ASSERT_NEAR(largest, expectedLargest, 1e-12 * expectedLargest);
    }
}

}  // namespace

}  // namespace scree
