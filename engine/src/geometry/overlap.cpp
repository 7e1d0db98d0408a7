// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Do two shapes overlap, their radii included? The distance of their cores against the sum of the radii: what a sensor
// and an overlap query ask.

#include "geometry/collide.h"
#include "geometry/distance.h"

namespace scree {

namespace {

// Box2D 2.4's rule: a gap of a few roundings still counts as a touch.
constexpr float largestGap = 10.0f * 1.1920929e-7f;

}  // namespace

OverlapResult FindOverlap(const DistanceProxy& proxyA, const Transform& xfA, const DistanceProxy& proxyB,
                          const Transform& xfB) {
    if (proxyA.m_count < 1 || proxyB.m_count < 1) return {false, 0};
    const PlacedCores placed = PlaceCores(proxyA, xfA, proxyB, xfB);
    SimplexCache cache;
    const Nearest nearest = FindNearest(placed.a, placed.b, placed.xfB, cache);
    return {nearest.distance - (proxyA.m_radius + proxyB.m_radius) < largestGap, nearest.iterations};
}

bool TestOverlap(const Shape* shapeA, int indexA, const Shape* shapeB, int indexB, const Transform& xfA,
                 const Transform& xfB) {
    DistanceProxy proxyA, proxyB;
    proxyA.Set(shapeA, indexA);
    proxyB.Set(shapeB, indexB);
    return FindOverlap(proxyA, xfA, proxyB, xfB).overlaps;
}

bool TestOverlap(const Shape& shapeA, const Transform& xfA, const Shape& shapeB, const Transform& xfB) {
    return TestOverlap(&shapeA, 0, &shapeB, 0, xfA, xfB);
}

}  // namespace scree
