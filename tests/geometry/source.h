// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The seeded source of random numbers, points and sizes of tests that vary their parameters.

#pragma once

#include <cmath>
#include <random>

#include "scree/math.h"

namespace scree::test {

/// Random numbers that are the same with every standard library: only the engine's raw output is used.
class Source {
public:
    explicit Source(uint32_t seed) : m_engine(seed) {}
    float Between(float low, float high) {
        return low + (high - low) * (static_cast<float>(m_engine() >> 8) * 0x1p-24f);
    }
    int Below(int n) { return static_cast<int>(m_engine() % static_cast<uint32_t>(n)); }
    bool Chance(int oneIn) { return Below(oneIn) == 0; }
    Vec2 InSquare(float halfWidth) {
        const float x = Between(-halfWidth, halfWidth);
        return {x, Between(-halfWidth, halfWidth)};
    }
    /// Spread evenly over orders of magnitude.
    float Size(float low, float high) { return low * std::pow(high / low, Between(0.0f, 1.0f)); }
    Vec2 Direction() {
        const float angle = Between(-pi, pi);
        return {std::cos(angle), std::sin(angle)};
    }

private:
    std::mt19937 m_engine;
};

}  // namespace scree::test
