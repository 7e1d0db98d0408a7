// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Gift wrapping (R. A. Jarvis, Information Processing Letters 2, 1973): a handful of points → their convex outline.
// With few points it is faster than anything that sorts. Choosing each corner with the same cross product as Box2D
// 2.4's hull gives the same corners in the same order.

#include "geometry/hull.h"

namespace scree {
namespace {

int MergeClosePoints(const Vec2* points, int count, Vec2* merged) {
    constexpr float weldDistance = 0.5f * linearSlop;
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        bool fresh = true;
        for (int j = 0; j < kept && fresh; ++j) {
            fresh = !(DistanceSquared(points[i], merged[j]) < weldDistance * weldDistance);
        }
        if (fresh) merged[kept++] = points[i];
    }
    return kept;
}

/// The point after `from`: no other lies to the right of the line to it, and it is the farthest on that line.
int NextCorner(const Vec2* points, int count, int from) {
    int best = from == 0 ? 1 : 0;
    for (int i = best + 1; i < count; ++i) {
        if (i == from) continue;
        const Vec2 toBest = points[best] - points[from];
        const Vec2 toPoint = points[i] - points[from];
        const float turn = Cross(toBest, toPoint);
        if (turn < 0.0f || (turn == 0.0f && toPoint.LengthSquared() > toBest.LengthSquared())) best = i;
    }
    return best;
}

}  // namespace

int ConvexHull(const Vec2* points, int count, Vec2* hull) {
    Vec2 merged[maxConvexVertices];
    const int pointCount = MergeClosePoints(points, count, merged);
    if (pointCount < 3) return 0;

    int start = 0;
    for (int i = 1; i < pointCount; ++i) {
        const Vec2 p = merged[i];
        const Vec2 best = merged[start];
        if (p.x > best.x || (p.x == best.x && p.y < best.y)) start = i;
    }

    int corners = 0;
    int current = start;
    do {
        // Rounding can send the walk past its start when points are nearly collinear; that is no usable outline.
        if (corners == pointCount) return 0;
        hull[corners++] = merged[current];
        current = NextCorner(merged, pointCount, current);
    } while (current != start);
    return corners < 3 ? 0 : corners;
}

}  // namespace scree
