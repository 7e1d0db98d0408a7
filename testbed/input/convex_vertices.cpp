// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of convex_vertices.h.

#include "testbed/input/convex_vertices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace testbed {

using scenes::Vec2;

// Andrew's monotone chain.
std::vector<Vec2> HullOf(std::vector<Vec2> points) {
    const auto turn = [](Vec2 a, Vec2 b, Vec2 c) {
        return (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
    };
    std::ranges::sort(points, [](Vec2 a, Vec2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    std::vector<Vec2> hull;
    for (const bool isUpper : {false, true}) {
        const std::size_t base = hull.size();
        for (const Vec2 point : points) {
            while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back();
        if (!isUpper) std::ranges::reverse(points);
    }
    return hull;
}

void Weld(std::vector<Vec2>& vertices) {
    std::vector<Vec2> kept;
    for (const Vec2 vertex : vertices) {
        const auto isNear = [&](Vec2 other) {
            return std::hypot(double{vertex.x} - other.x, double{vertex.y} - other.y) <= 0.5 * double{linearSlop};
        };
        if (std::ranges::none_of(kept, isNear)) kept.push_back(vertex);
    }
    vertices = std::move(kept);
}

bool IsConvex(const std::vector<Vec2>& v) {
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vec2 a = v[i], b = v[(i + 1) % v.size()];
        for (std::size_t k = 0; k < v.size(); ++k) {
            if (k == i || k == (i + 1) % v.size()) continue;
            if ((double{b.x} - a.x) * (double{v[k].y} - a.y) <= (double{b.y} - a.y) * (double{v[k].x} - a.x)) {
                return false;
            }
        }
    }
    return v.size() >= 3;
}

}  // namespace testbed
