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
#include <span>

#include "scenes/scene.h"

namespace scenes {

inline constexpr double pi = 3.14159265358979323846;

/// A point or vector from double formulas; each coordinate is rounded once.
[[nodiscard]] inline Vec2 Point(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

[[nodiscard]] Shape Circle(double radius, Vec2 center = {});
[[nodiscard]] Shape Box(double halfWidth, double halfHeight, Vec2 center = {}, double angle = 0.0);
/// Convex, counter-clockwise, 3 to 8 vertices; throws std::invalid_argument for another number.
[[nodiscard]] Shape Polygon(std::initializer_list<Vec2> vertices);
/// A regular polygon of `count` (3 to 8) vertices, the first to the right of the centre.
[[nodiscard]] Shape RegularPolygon(int count, double radius, Vec2 center = {});
/// Collides on both sides.
[[nodiscard]] Shape Edge(Vec2 from, Vec2 to);
/// Collides on the right of from → to; `before` and `after` are the far ends of its neighbours.
[[nodiscard]] Shape OneSidedEdge(Vec2 before, Vec2 from, Vec2 to, Vec2 after);
/// An open chain through at least 2 vertices, which are stored in the scene. It collides on the right of its direction;
/// the surface goes on straight beyond both ends.
[[nodiscard]] Shape Chain(Scene& scene, std::span<const Vec2> vertices);
/// A closed chain through at least 3 vertices: counter-clockwise ones collide outside, clockwise ones inside.
[[nodiscard]] Shape Loop(Scene& scene, std::span<const Vec2> vertices);

/// A segment grown by a radius > 0.
[[nodiscard]] Shape Capsule(Vec2 from, Vec2 to, double radius);
/// Convex, counter-clockwise, 3 to 8 vertices, grown by a radius > 0.
[[nodiscard]] Shape RoundedPolygon(std::initializer_list<Vec2> vertices, double radius);
/// Convex, counter-clockwise, 3 to 64 vertices, which are stored in the scene.
[[nodiscard]] Shape LargePolygon(Scene& scene, std::span<const Vec2> vertices);
[[nodiscard]] Shape Ellipse(double semiAxisX, double semiAxisY, Vec2 center = {}, double angle = 0.0);
/// A slice of a disk around `tip`: `opening` in 0.01…π rad, its middle in the direction `angle`.
[[nodiscard]] Shape Sector(double radius, double opening, Vec2 tip = {}, double angle = 0.0);
/// Any convex shape within `bound` m of the body's origin.
[[nodiscard]] Shape Supported(SupportFunction support, double bound);

/// Makes room, so that large scenes are not copied while they grow.
void Reserve(Scene& scene, int bodies, int fixtures);

/// Appends a body without fixtures and returns it; the reference holds until the next body is added.
Body& AddBody(Scene& scene, BodyType type, Vec2 position);

/// Appends a fixture to the body added last and returns it; the reference holds until the next fixture is added. The
/// density is ignored by engines where the body is static.
Fixture& AddFixture(Scene& scene, const Shape& shape, double density = 0.0);

/// The index of the body added last.
[[nodiscard]] inline int LastBody(const Scene& scene) { return static_cast<int>(scene.bodies.size()) - 1; }

/// A static body with a two-sided edge from (−halfWidth, 0) to (halfWidth, 0).
Body& AddFlatGround(Scene& scene, double halfWidth);

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
