// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Support functions in double, rounded once; directions from SinCos: the same points on every machine.

#include "scenes/outline.h"

#include <algorithm>
#include <cmath>

#include "scenes/build.h"

namespace scenes {

namespace {

double Along(Vec2 point, double x, double y) { return double{point.x} * x + double{point.y} * y; }

Vec2 FarthestOf(std::span<const Vec2> points, double x, double y) {
    return *std::ranges::max_element(points, {}, [&](Vec2 p) { return Along(p, x, y); });
}

Vec2 FarthestOfEllipse(const Shape& shape, double x, double y) {
    const auto [sin, cos] = SinCos(shape.angle);
    const double a = shape.halfExtents.x, b = shape.halfExtents.y;
    const double u = cos * x + sin * y, v = cos * y - sin * x;  // the direction in the ellipse's own axes
    const double length = std::sqrt(a * a * u * u + b * b * v * v);
    const double px = a * a * u / length, py = b * b * v / length;
    return Point(shape.center.x + cos * px - sin * py, shape.center.y + sin * px + cos * py);
}

/// The apex, a point of the arc, or one of the arc's ends.
Vec2 FarthestOfSector(const Shape& shape, double x, double y) {
    const auto rim = [&](double angle) {
        const auto [sin, cos] = SinCos(angle);
        return Point(shape.center.x + shape.radius * cos, shape.center.y + shape.radius * sin);
    };
    const auto [sin, cos] = SinCos(shape.angle);
    const double half = 0.5 * shape.opening;
    const bool isOnArc = cos * x + sin * y >= SinCos(half).cos;  // the direction lies within the opening
    if (isOnArc) return Point(shape.center.x + shape.radius * x, shape.center.y + shape.radius * y);
    const Vec2 corners[] = {shape.center, rim(shape.angle - half), rim(shape.angle + half)};
    return FarthestOf(corners, x, y);
}

std::span<const Vec2> OutlinePointsOf(const Scene& scene, const Shape& shape) {
    return shape.type == ShapeType::largePolygon ? scene.ChainVerticesOf(shape) : shape.Vertices();
}

}  // namespace

bool IsFurtherConvex(ShapeType type) {
    switch (type) {
        case ShapeType::capsule:
        case ShapeType::roundedPolygon:
        case ShapeType::largePolygon:
        case ShapeType::ellipse:
        case ShapeType::sector:
        case ShapeType::supported:
            return true;
        default:
            return false;
    }
}

Vec2 SupportPoint(const Shape& shape, std::span<const Vec2> points, Vec2 direction) {
    const double x = direction.x, y = direction.y;
    switch (shape.type) {
        case ShapeType::ellipse:
            return FarthestOfEllipse(shape, x, y);
        case ShapeType::sector:
            return FarthestOfSector(shape, x, y);
        case ShapeType::supported:
            return shape.support(direction);
        default: {
            const Vec2 corner = FarthestOf(points, x, y);
            return Point(corner.x + shape.radius * x, corner.y + shape.radius * y);
        }
    }
}

std::vector<Vec2> SampleOutline(const Scene& scene, const Shape& shape, int directions) {
    const std::span<const Vec2> points = OutlinePointsOf(scene, shape);
    std::vector<Vec2> outline;
    for (int i = 0; i < directions; ++i) {
        // Half a step aside, so that none is the normal of an upright side, where either end would do.
        const auto [sin, cos] = SinCos(2.0 * pi * (i + 0.5) / directions);
        const Vec2 point = SupportPoint(shape, points, Point(cos, sin));
        if (outline.empty() || (point != outline.back() && point != outline.front())) outline.push_back(point);
    }
    return outline;
}

Shape PolygonInstead(const Scene& scene, const Shape& shape) {
    const std::vector<Vec2> outline = SampleOutline(scene, shape, maxPolygonVertices);
    Shape polygon;
    polygon.type = ShapeType::polygon;
    polygon.vertexCount = static_cast<std::uint8_t>(outline.size());
    std::ranges::copy(outline, polygon.vertices.begin());
    return polygon;
}

}  // namespace scenes
