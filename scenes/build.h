// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What scene files build with: shapes, appending bodies and fixtures, and numbers that are the same on every machine.
//
// Arithmetic rule of all scenes: a coordinate is its closed formula evaluated in double, in the order written and
// without fused contraction, then rounded to float once. Sine and cosine come from SinCos below, random numbers from
// Random, because neither std::sin nor std::uniform_real_distribution is the same in every standard library.

#pragma once

#include <cstdint>
#include <initializer_list>

#include "scenes/scene.h"

namespace scenes {

/// A point or vector from double formulas; each coordinate is rounded once.
[[nodiscard]] inline Vec2 Point(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

[[nodiscard]] Shape Circle(double radius, Vec2 center = {});
[[nodiscard]] Shape Box(double halfWidth, double halfHeight, Vec2 center = {}, double angle = 0.0);
/// Convex, counter-clockwise, 3 to 8 vertices; throws std::invalid_argument for another number.
[[nodiscard]] Shape Polygon(std::initializer_list<Vec2> vertices);
[[nodiscard]] Shape Edge(Vec2 from, Vec2 to);

/// Makes room, so that large scenes are not copied while they grow.
void Reserve(Scene& scene, int bodies, int fixtures);

/// Appends a body without fixtures and returns it; the reference holds until the next body is added.
Body& AddBody(Scene& scene, BodyType type, Vec2 position);

/// Appends a fixture to the body added last. The density is ignored by engines where the body is static.
void AddFixture(Scene& scene, const Shape& shape, double density = 0.0);

/// The index of the body added last.
[[nodiscard]] inline int LastBody(const Scene& scene) { return static_cast<int>(scene.bodies.size()) - 1; }

struct SinCosValue {
    double sin, cos;
};

/// Sine and cosine by basic operations only, so bit-identical wherever double is IEEE 754; error below 1e-15 for
/// |angle| ≤ 1e6 rad.
[[nodiscard]] SinCosValue SinCos(double angle);

/// PCG-XSH-RR 64/32 (O'Neill, "PCG: a family of simple fast space-efficient statistically good algorithms for random
/// number generation", 2014): the same sequence from the same seed everywhere.
class Random {
public:
    explicit Random(std::uint64_t seed);

    std::uint32_t Next();

    /// Uniform in [low, high), on a lattice of 2^32 values.
    double Uniform(double low, double high);

private:
    std::uint64_t m_state;
};

}  // namespace scenes
