// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Bodies seen from near one of them. A float has seven digits, of which a position far from the origin leaves none for
// what happens there. So positions far away have a low-order part (BodyTable::rest). Whatever compares two bodies does
// it in a frame at a point near them, in which both parts fit into one float. In worlds without far bodies the frame is
// the world's, and the plain rows are what is seen: same bits, same speed.

#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "base/two_sum.h"
#include "state/bodies.h"

namespace scree {

/// Where the frame for two bodies lies: at the one that is farther away, since the shapes of the other one reach there.
inline Vec2 FrameOf(const BodyTable& bodies, BodyIndex a, BodyIndex b) {
    if (!bodies.IsFar()) return vec2Zero;
    const auto reach = [](Vec2 c) { return Max(Abs(c.x), Abs(c.y)); };
    const Vec2 cA = bodies.position[a].c, cB = bodies.position[b].c;
    return reach(cA) > reach(cB) ? cA : cB;
}

/// Centre of mass.
inline Vec2 CentreIn(Vec2 frame, const BodyTable& bodies, BodyIndex body) {
    if (!bodies.IsFar()) return bodies.position[body].c;
    return (bodies.position[body].c - frame) + bodies.rest[body].end;
}
/// The same at the start of the step.
inline Vec2 StartIn(Vec2 frame, const BodyTable& bodies, BodyIndex body) {
    if (!bodies.IsFar()) return bodies.startPosition[body].c;
    return (bodies.startPosition[body].c - frame) + bodies.rest[body].start;
}

/// Centre of mass and angle, to be changed and stored again.
inline Position PositionIn(Vec2 frame, const BodyTable& bodies, BodyIndex body) {
    Position p = bodies.position[body];
    if (bodies.IsFar()) p.c = CentreIn(frame, bodies, body);
    return p;
}
/// Far from the origin the rest takes what has changed, so that nothing else of the position does.
inline void StorePosition(Vec2 frame, const Position& changed, BodyIndex body, BodyTable& bodies) {
    Position& p = bodies.position[body];
    const Vec2 c = p.c, way = bodies.IsFar() ? changed.c - CentreIn(frame, bodies, body) : vec2Zero;
    p = changed;
    if (!bodies.IsFar()) return;
    p.c = c;
    bodies.rest[body].end += way;
}

inline Transform TransformIn(Vec2 frame, const BodyTable& bodies, BodyIndex body) {
    const Transform& xf = bodies.transform[body];
    if (!bodies.IsFar()) return xf;
    return {CentreIn(frame, bodies, body) - Mul(xf.q, bodies.mass[body].localCenter), xf.q};
}

/// From a point of body A to one of body B.
inline Vec2 GapBetween(const BodyTable& bodies, BodyIndex a, Vec2 localA, BodyIndex b, Vec2 localB) {
    const Vec2 frame = FrameOf(bodies, a, b);
    return Mul(TransformIn(frame, bodies, b), localB) - Mul(TransformIn(frame, bodies, a), localA);
}

/// The largest float below a finite one.
inline float FloatBelow(float x) {
    if (x == 0.0f) return -std::numeric_limits<float>::denorm_min();
    return std::bit_cast<float>(std::bit_cast<int32_t>(x) + (x > 0.0f ? -1 : 1));
}
/// The largest float that is not above a + b.
inline float SumBelow(float a, float b) {
    const RoundedSum s = TwoSum(a, b);
    return s.rest < 0.0f ? FloatBelow(s.sum) : s.sum;
}
/// The smallest box of floats around a box that is given in a frame.
inline AABB ToWorld(Vec2 frame, const AABB& box) {
    return {{SumBelow(frame.x, box.lowerBound.x), SumBelow(frame.y, box.lowerBound.y)},
            {-SumBelow(-frame.x, -box.upperBound.x), -SumBelow(-frame.y, -box.upperBound.y)}};
}

/// Where one body is, in a frame near it.
struct BodyPlace {
    BodyPlace(const BodyTable& bodies, BodyIndex body)
        : frame(FrameOf(bodies, body, body)), xf(TransformIn(frame, bodies, body)), isFar(bodies.IsFar()) {}
    /// What is given in the world, in the frame.
    [[nodiscard]] Transform In(const Transform& other) const { return {other.p - frame, other.q}; }
    /// A world box that contains the box in the frame.
    [[nodiscard]] AABB OutOf(const AABB& box) const { return isFar ? ToWorld(frame, box) : box; }

    Vec2 frame;
    Transform xf;
    bool isFar;
};

}  // namespace scree
