// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A row of samples at a time: each edge of a triangle bounds the row's span by one integer division.

#include "testbed/picture/rasterizer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace testbed {

namespace {

/// Inside is a·x + b·y + c ≥ 0 at the centre of sample (x, y).
struct Edge {
    int64_t a, b, c;
};

int64_t DivideDown(int64_t numerator, int64_t denominator) {
    const int64_t quotient = numerator / denominator;
    return numerator % denominator < 0 ? quotient - 1 : quotient;
}

/// The edge from p to q of a triangle whose inside is on its right as seen with y down (clockwise on the screen).
Edge MakeEdge(const FixedPoint& p, const FixedPoint& q) {
    const int64_t dx = q.x - p.x;
    const int64_t dy = q.y - p.y;
    // A sample on an edge belongs to the triangle if that is a left or a top edge. So two triangles with a common edge
    // share no sample and leave none out.
    const bool isTopOrLeft = dy < 0 || (dy == 0 && dx > 0);
    constexpr int64_t half = fixedPointOne / 2;
    return {-dy * fixedPointOne, dx * fixedPointOne, dx * (half - p.y) - dy * (half - p.x) - (isTopOrLeft ? 0 : 1)};
}

void RasterizeTriangle(const Triangle& triangle, Image& image) {
    FixedPoint b = triangle.b;
    FixedPoint c = triangle.c;
    const FixedPoint& a = triangle.a;
    const int64_t area = static_cast<int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<int64_t>(b.y - a.y) * (c.x - a.x);
    if (area == 0) return;
    if (area < 0) std::swap(b, c);
    const std::array<Edge, 3> edges{MakeEdge(a, b), MakeEdge(b, c), MakeEdge(c, a)};

    const auto [minX, maxX] = std::minmax({a.x, b.x, c.x});
    const auto [minY, maxY] = std::minmax({a.y, b.y, c.y});
    const int64_t firstX = std::max(minX / fixedPointOne, 0);
    const int64_t lastX = std::min(maxX / fixedPointOne, image.width - 1);
    const int firstY = std::max(minY / fixedPointOne, 0);
    const int lastY = std::min(maxY / fixedPointOne, image.height - 1);
    for (int y = firstY; y <= lastY; ++y) {
        int64_t begin = firstX;
        int64_t end = lastX;
        for (const Edge& edge : edges) {
            const int64_t rest = edge.b * y + edge.c;
            if (edge.a > 0) {
                begin = std::max(begin, -DivideDown(rest, edge.a));
            } else if (edge.a < 0) {
                end = std::min(end, DivideDown(rest, -edge.a));
            } else if (rest < 0) {
                end = -1;
            }
        }
        if (begin <= end)
            std::fill(&image.At(static_cast<int>(begin), y), &image.At(static_cast<int>(end), y) + 1, triangle.color);
    }
}

}  // namespace

void RasterizeTriangles(std::span<const Triangle> triangles, Image& image) {
    for (const Triangle& triangle : triangles) RasterizeTriangle(triangle, image);
}

}  // namespace testbed
