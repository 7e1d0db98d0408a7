// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of area.h.

#include "testbed/input/area.h"

#include <cstddef>

#include "scenes/outline.h"

namespace testbed {

using scenes::ShapeType;

void AreaSums::Add(const AreaSums& one, double density) {
    area += density * one.area;
    x += density * one.x;
    y += density * one.y;
    moment += density * one.moment;
}

AreaSums SumsOf(std::span<const scenes::Vec2> v) {
    AreaSums sums;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double ax = v[i].x, ay = v[i].y;
        const double bx = v[(i + 1) % v.size()].x, by = v[(i + 1) % v.size()].y;
        const double cross = ax * by - ay * bx;
        sums.area += 0.5 * cross;
        sums.x += cross * (ax + bx) / 6.0;
        sums.y += cross * (ay + by) / 6.0;
        sums.moment += cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12.0;
    }
    return sums;
}

AreaSums SumsOf(const scenes::Scene& scene, const scenes::Shape& shape) {
    if (shape.type == ShapeType::edge || shape.type == ShapeType::chain) return {};
    if (shape.type == ShapeType::circle) {
        const double r2 = static_cast<double>(shape.radius) * shape.radius, area = 3.14159265358979 * r2;
        const double x = shape.center.x, y = shape.center.y;
        return {area, area * x, area * y, area * (0.5 * r2 + x * x + y * y)};
    }
    if (shape.type == ShapeType::polygon) return SumsOf(shape.Vertices());
    if (shape.type == ShapeType::box) {
        const double hx = shape.halfExtents.x, hy = shape.halfExtents.y, area = 4.0 * hx * hy;
        const double x = shape.center.x, y = shape.center.y;
        return {area, area * x, area * y, area * ((hx * hx + hy * hy) / 3.0 + x * x + y * y)};
    }
    return SumsOf(scenes::PolygonInstead(scene, shape).Vertices());
}

}  // namespace testbed
