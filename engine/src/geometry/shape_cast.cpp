// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Linear cast of one convex shape against another at rest: placements and a translation → time and place of the first
// touch. The distance of convex cores is convex along a translation. So going on by (distance − target) / approach
// speed, with GJK's normal, is Newton's method from the safe side: it never passes the touch. Source of the idea: van
// den Bergen, "Ray Casting against General Convex Objects with Application to Continuous Collision Detection" (2004).
// Thickness, tolerance and the answers for shapes that start in touch follow Box2D 2.4's rules.

#include "geometry/distance.h"

namespace scree {

namespace {

// Three to six rounds are usual. A grazing path, where Newton's method halves its steps, needs about twenty.
constexpr int maxRounds = 48;
constexpr float tolerance = 0.5f * linearSlop;

/// Why a cast ends, or that it goes on.
enum class Step : uint8_t { goesOn, misses, arrives };

/// Goes on along the path until the separation along `normal`, now `gap` beyond the target, is used up.
Step Approach(Vec2 normal, float gap, Vec2 path, float& lambda) {
    const float speed = -Dot(normal, path);
    if (!(speed > 0.0f)) return Step::misses;
    const float next = lambda + gap / speed;
    if (!(next <= 1.0f)) return Step::misses;
    if (next == lambda) return Step::arrives;  // too small a step for a float
    lambda = next;
    return Step::goesOn;
}

void WriteHit(ShapeCastOutput& output, const PlacedCores& placed, const Nearest& nearest, const Transform& xfA,
              float radiusA) {
    const Vec2 onA = FindNearestPoints(placed.a, placed.b, placed.xfB, nearest).onA + radiusA * nearest.normal;
    output.point = Mul(xfA, onA + placed.a.origin);
    output.normal = Mul(xfA.q, nearest.normal);
}

}  // namespace

bool ShapeCast(ShapeCastOutput* output, const ShapeCastInput* input) {
    *output = {vec2Zero, vec2Zero, 1.0f, 0};
    if (input->proxyA.m_count < 1 || input->proxyB.m_count < 1) return false;
    const float radiusA = Max(input->proxyA.m_radius, polygonRadius);
    const float radiusB = Max(input->proxyB.m_radius, polygonRadius);
    const float target = Max(polygonRadius, radiusA + radiusB - polygonRadius);

    PlacedCores placed = PlaceCores(input->proxyA, input->transformA, input->proxyB, input->transformB);
    const Vec2 start = placed.xfB.p;
    const Vec2 path = MulT(input->transformA.q, input->translationB);
    float lambda = 0.0f;

    // The line between the vertices that lead the motion is a first guess at the axis, and cheaper than GJK.
    const int leadA = FindExtreme(placed.a, -path);
    const int leadB = FindExtreme(placed.b, MulT(placed.xfB.q, path));
    Vec2 axis = Mul(placed.xfB, placed.b.At(leadB)) - placed.a.At(leadA);
    if (axis.Normalize() <= target + tolerance) return false;
    const float reach = FindReach(placed.b, -MulT(placed.xfB.q, axis)) + FindReach(placed.a, axis);
    const float gap = Dot(axis, start) - reach - target;
    if (gap > tolerance && Approach(axis, gap, path, lambda) == Step::misses) return false;

    SimplexCache cache;
    for (int round = 0; round < maxRounds; ++round) {
        placed.xfB.p = start + lambda * path;
        const Nearest nearest = FindNearest(placed.a, placed.b, placed.xfB, cache);
        output->iterations += 1;
        if (lambda == 0.0f && nearest.distance == 0.0f) return false;
        bool arrives = nearest.distance <= target + tolerance;
        if (!arrives) {
            const Step step = Approach(nearest.normal, nearest.distance - target, path, lambda);
            if (step == Step::misses) return false;
            arrives = step == Step::arrives;
        }
        if (arrives) {
            WriteHit(*output, placed, nearest, input->transformA, radiusA);
            output->lambda = lambda;
            return true;
        }
    }
    return false;
}

}  // namespace scree
