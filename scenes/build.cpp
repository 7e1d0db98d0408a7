// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Shapes, bodies and fixtures appended to a scene, totals, and machine-independent sine, cosine and random numbers.

#include "scenes/build.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace scenes {

Shape Circle(double radius, Vec2 center) {
    Shape shape;
    shape.type = ShapeType::circle;
    shape.radius = static_cast<float>(radius);
    shape.center = center;
    return shape;
}

Shape Box(double halfWidth, double halfHeight, Vec2 center, double angle) {
    Shape shape;
    shape.type = ShapeType::box;
    shape.halfExtents = Point(halfWidth, halfHeight);
    shape.center = center;
    shape.angle = static_cast<float>(angle);
    return shape;
}

Shape Polygon(std::initializer_list<Vec2> vertices) {
    if (vertices.size() < 3 || vertices.size() > maxPolygonVertices) {
        throw std::invalid_argument("a polygon has 3 to 8 vertices, not " + std::to_string(vertices.size()));
    }
    Shape shape;
    shape.type = ShapeType::polygon;
    shape.vertexCount = static_cast<std::uint8_t>(vertices.size());
    std::copy(vertices.begin(), vertices.end(), shape.vertices.begin());
    return shape;
}

Shape Edge(Vec2 from, Vec2 to) {
    Shape shape;
    shape.type = ShapeType::edge;
    shape.vertexCount = 2;
    shape.vertices[0] = from;
    shape.vertices[1] = to;
    return shape;
}

Shape OneSidedEdge(Vec2 before, Vec2 from, Vec2 to, Vec2 after) {
    Shape shape;
    shape.type = ShapeType::edge;
    shape.vertexCount = 4;
    shape.vertices[0] = from;
    shape.vertices[1] = to;
    shape.vertices[2] = before;
    shape.vertices[3] = after;
    return shape;
}

Shape RegularPolygon(int count, double radius, Vec2 center) {
    if (count < 3 || count > maxPolygonVertices) {
        throw std::invalid_argument("a polygon has 3 to 8 vertices, not " + std::to_string(count));
    }
    Shape shape;
    shape.type = ShapeType::polygon;
    shape.vertexCount = static_cast<std::uint8_t>(count);
    for (int i = 0; i < count; ++i) {
        const auto [sin, cos] = SinCos(2.0 * pi * i / count);
        shape.vertices[static_cast<std::size_t>(i)] = Point(center.x + radius * cos, center.y + radius * sin);
    }
    return shape;
}

namespace {

Shape StoreChain(Scene& scene, std::span<const Vec2> vertices, std::size_t minimum) {
    if (vertices.size() < minimum) {
        throw std::invalid_argument("a chain has at least 2 vertices, a loop 3, not " +
                                    std::to_string(vertices.size()));
    }
    Shape shape;
    shape.type = ShapeType::chain;
    shape.firstChainVertex = static_cast<int>(scene.chainVertices.size());
    shape.chainVertexCount = static_cast<int>(vertices.size());
    scene.chainVertices.insert(scene.chainVertices.end(), vertices.begin(), vertices.end());
    return shape;
}

// The point as far beyond `end` as `inner` is before it.
Vec2 Beyond(Vec2 inner, Vec2 end) {
    return Point(2.0 * end.x - static_cast<double>(inner.x), 2.0 * end.y - static_cast<double>(inner.y));
}

}  // namespace

Shape Chain(Scene& scene, std::span<const Vec2> vertices) {
    Shape shape = StoreChain(scene, vertices, 2);
    shape.vertexCount = 2;
    shape.vertices[0] = Beyond(vertices[1], vertices[0]);
    shape.vertices[1] = Beyond(vertices[vertices.size() - 2], vertices.back());
    return shape;
}

Shape Loop(Scene& scene, std::span<const Vec2> vertices) { return StoreChain(scene, vertices, 3); }

Shape Capsule(Vec2 from, Vec2 to, double radius) {
    Shape shape = Edge(from, to);
    shape.type = ShapeType::capsule;
    shape.radius = static_cast<float>(radius);
    return shape;
}

Shape RoundedPolygon(std::initializer_list<Vec2> vertices, double radius) {
    Shape shape = Polygon(vertices);
    shape.type = ShapeType::roundedPolygon;
    shape.radius = static_cast<float>(radius);
    return shape;
}

Shape LargePolygon(Scene& scene, std::span<const Vec2> vertices) {
    if (vertices.size() < 3 || vertices.size() > 64) {
        throw std::invalid_argument("a large polygon has 3 to 64 vertices, not " + std::to_string(vertices.size()));
    }
    Shape shape = StoreChain(scene, vertices, 3);
    shape.type = ShapeType::largePolygon;
    return shape;
}

Shape Ellipse(double semiAxisX, double semiAxisY, Vec2 center, double angle) {
    Shape shape = Box(semiAxisX, semiAxisY, center, angle);
    shape.type = ShapeType::ellipse;
    return shape;
}

Shape Sector(double radius, double opening, Vec2 tip, double angle) {
    Shape shape = Circle(radius, tip);
    shape.type = ShapeType::sector;
    shape.opening = static_cast<float>(opening);
    shape.angle = static_cast<float>(angle);
    return shape;
}

Shape Supported(SupportFunction support, double bound) {
    Shape shape = Circle(bound);
    shape.type = ShapeType::supported;
    shape.support = support;
    return shape;
}

Shape ChildOf(const Scene& scene, const Shape& shape, int child) {
    if (shape.type != ShapeType::chain) return shape;
    const std::span<const Vec2> chain = scene.ChainVerticesOf(shape);
    const int count = shape.chainVertexCount;
    const auto vertex = [&](int i) {
        if (!shape.IsLoop() && i < 0) return shape.vertices[0];
        if (!shape.IsLoop() && i >= count) return shape.vertices[1];
        return chain[static_cast<std::size_t>((i + count) % count)];
    };
    return OneSidedEdge(vertex(child - 1), vertex(child), vertex(child + 1), vertex(child + 2));
}

void Reserve(Scene& scene, int bodies, int fixtures) {
    scene.bodies.reserve(static_cast<std::size_t>(bodies));
    scene.fixtures.reserve(static_cast<std::size_t>(fixtures));
}

Body& AddBody(Scene& scene, BodyType type, Vec2 position) {
    Body& body = scene.bodies.emplace_back();
    body.type = type;
    body.position = position;
    body.firstFixture = static_cast<int>(scene.fixtures.size());
    return body;
}

Fixture& AddFixture(Scene& scene, const Shape& shape, double density) {
    Fixture& fixture = scene.fixtures.emplace_back();
    fixture.shape = shape;
    fixture.density = static_cast<float>(density);
    ++scene.bodies.back().fixtureCount;
    return fixture;
}

Body& AddFlatGround(Scene& scene, double halfWidth) {
    Body& ground = AddBody(scene, BodyType::isStatic, {});
    AddFixture(scene, Edge(Point(-halfWidth, 0.0), Point(halfWidth, 0.0)));
    return ground;
}

SceneCounts Count(const Scene& scene) {
    SceneCounts counts;
    for (const Body& body : scene.bodies) {
        switch (body.type) {
            case BodyType::isStatic:
                ++counts.staticBodies;
                break;
            case BodyType::kinematic:
                ++counts.kinematicBodies;
                break;
            case BodyType::dynamic:
                ++counts.dynamicBodies;
                break;
        }
        (body.type == BodyType::isStatic ? counts.staticFixtures : counts.movingFixtures) += body.fixtureCount;
    }
    counts.joints = static_cast<int>(scene.joints.size());
    counts.spawns = static_cast<int>(scene.spawns.size());
    return counts;
}

SinCosValue SinCos(double angle) {
    // Cody and Waite's reduction: π/2 in two parts, the first with trailing zeros so that quadrant · high is exact.
    constexpr double twoOverPi = 0.63661977236758134308;
    constexpr double halfPiHigh = 0x1.921fb544p0;
    constexpr double halfPiLow = 0x1.0b4611a626331p-34;
    const double quadrant = std::floor(angle * twoOverPi + 0.5);
    const double r = (angle - quadrant * halfPiHigh) - quadrant * halfPiLow;

    // Taylor series on |r| ≤ π/4, where the first dropped terms are below 3e-18. `term` is r^k / k!, signs apart.
    double sum[2] = {1.0, r};  // even powers: cos, odd powers: sin
    double term = r;
    for (int k = 2; k <= 17; ++k) {
        term *= r / k;
        sum[k & 1] += (k & 2) != 0 ? -term : term;
    }
    switch (static_cast<std::int64_t>(quadrant) & 3) {
        case 0:
            return {sum[1], sum[0]};
        case 1:
            return {sum[0], -sum[1]};
        case 2:
            return {-sum[1], -sum[0]};
        default:
            return {-sum[0], sum[1]};
    }
}

namespace {
constexpr std::uint64_t pcgMultiplier = 6364136223846793005u;  // Knuth's MMIX, as in the PCG paper
constexpr std::uint64_t pcgIncrement = 1442695040888963407u;
}  // namespace

Random::Random(std::uint64_t seed) : m_state((seed + pcgIncrement) * pcgMultiplier + pcgIncrement) {}

std::uint32_t Random::Next() {
    const std::uint64_t old = m_state;
    m_state = old * pcgMultiplier + pcgIncrement;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    return std::rotr(mixed, static_cast<int>(old >> 59));
}

double Random::Uniform(double low, double high) { return low + (high - low) * (Next() * 0x1p-32); }

}  // namespace scenes
