// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whatever a second thread gives, steps take little longer than they would in the better way; also if that changes, if
// the work changes, and if times are noisy.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/sharing_gauge.h"

namespace scree {
namespace {

/// Steps of a world on a machine whose second thread makes them `gain` times as fast.
class Machine {
public:
    Machine(uint32_t seed, double noise) : m_random(seed), m_noise(0.0, noise) {}

    /// Time of so many steps over that of the better way.
    double Run(int steps, double gain) {
        double taken = 0.0, best = 0.0;
        for (int i = 0; i < steps; ++i) {
            m_work = std::clamp(m_work * std::exp(0.05 * m_noise(m_random)), 100.0, 1e5);
            const bool isShared = m_gauge.Shares();
            // The first steps after a change find cold caches.
            const double cold = isShared == m_was ? 1.0 : 1.3;
            m_was = isShared;
            const double disturbed = m_random() % 50 == 0 ? 3.0 : 1.0;
            const double alone = m_work * std::exp(std::abs(m_noise(m_random)));
            const double time = (isShared ? alone / gain : alone) * cold;
            m_gauge.Note(time * disturbed, m_work);
            taken += time;
            best += std::min(alone, alone / gain);
        }
        return taken / best;
    }

private:
    SharingGauge m_gauge;
    std::mt19937 m_random;
    std::normal_distribution<double> m_noise;
    double m_work = 5000.0;
    bool m_was = true;
};

class Gains : public testing::TestWithParam<double> {};

TEST_P(Gains, StepsTakeLittleLongerThanInTheBetterWay) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        EXPECT_LT(Machine(seed, 0.0).Run(2000, GetParam()), 1.03) << seed;
        EXPECT_LT(Machine(seed, 0.1).Run(2000, GetParam()), 1.05) << seed;
    }
}

TEST_P(Gains, AreFoundAnewWhenTheyChange) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        Machine machine(seed, 0.05);
        machine.Run(3000, GetParam());
        const double slower = std::max(GetParam(), 1.0 / GetParam()), stepsToFind = 256.0;
        EXPECT_LT(machine.Run(2000, 1.0 / GetParam()), 1.04 + (slower - 1.0) * stepsToFind / 2000.0) << seed;
        EXPECT_LT(machine.Run(2000, 1.0 / GetParam()), 1.04) << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(OfASecondThread, Gains, testing::Values(0.4, 0.7, 0.9, 1.0, 1.1, 1.4, 1.9));

}  // namespace
}  // namespace scree
