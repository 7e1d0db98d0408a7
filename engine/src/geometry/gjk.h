// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The one GJK of the engine, for convex cores without radius: two cores and B's placement in A's frame → the nearest
// features, their distance and the direction between them. Distance, shape cast, overlap and time of impact are built
// on it.

#pragma once

#include <bit>

#include "geometry/vectors4.h"
#include "scree/distance.h"

namespace scree {

/// The vertices of a proxy counted from `origin`, so that a shape far from its body's origin keeps its precision. Up to
/// eight are also held in lanes, where the search for an extreme takes no branch.
struct Core {
    const Vec2* vertices;
    int count;
    Vec2 origin;
    /// The first four vertices and the last four; they overlap when there are fewer than eight. With fewer than four,
    /// the last vertex fills both.
    Vector4 low, high;

    Core() = default;
    Core(const Vec2* verticesIn, int countIn, Vec2 originIn);

    [[nodiscard]] Vec2 At(int index) const { return vertices[index] - origin; }
};

inline Core::Core(const Vec2* verticesIn, int countIn, Vec2 originIn)
    : vertices(verticesIn), count(countIn), origin(originIn) {
    if (count >= 4) {
        const Vector4 shift = SplatVector4(origin);
        low = LoadVectors4(&vertices[0].x) - shift;
        high = LoadVectors4(&vertices[count - 4].x) - shift;
    } else {
        const Vec2 v0 = At(0), v1 = At(count > 1 ? 1 : 0), v2 = At(count - 1);
        low = {Set4(v0.x, v1.x, v2.x, v2.x), Set4(v0.y, v1.y, v2.y, v2.y)};
        high = low;
    }
}

/// The larger of lanes 0 and 2, 1 and 3, then of those.
inline float Largest(F4 v) {
    const F4 halves = Max4(v, SwapHalves4(v));
    return Max(GetLane4<0>(halves), GetLane4<1>(halves));
}

/// How far a core reaches along a direction.
inline float FindReach(const Core& core, Vec2 direction) {
    if (core.count == 1) return Dot(direction, {GetLane4<0>(core.low.x), GetLane4<0>(core.low.y)});
    const Vector4 d = SplatVector4(direction);
    float best = Largest(Max4(Dot4(d, core.low), Dot4(d, core.high)));
    for (int i = 4; i < core.count - 4; ++i) best = Max(best, Dot(direction, core.At(i)));
    return best;
}

/// The index of a vertex that reaches farthest along a direction.
inline int FindExtreme(const Core& core, Vec2 direction) {
    if (core.count == 1) return 0;
    const Vector4 d = SplatVector4(direction);
    const F4 low = Dot4(d, core.low), high = Dot4(d, core.high);
    float best = Largest(Max4(low, high));
    // Bits 0…3: the first four; bits 4…7: the last four. No bit is set if something is not a number.
    const uint32_t bits = Bits4(Equal4(low, Splat4(best))) | Bits4(Equal4(high, Splat4(best))) << 4;
    const int place = std::countr_zero(bits | 0x100u);
    int index = place < 4 ? (place < core.count ? place : core.count - 1) : (place < 8 ? core.count - 8 + place : 0);
    for (int i = 4; i < core.count - 4; ++i) {
        const float reach = Dot(direction, core.At(i));
        if (reach > best) {
            best = reach;
            index = i;
        }
    }
    return index;
}

/// Where two cores are nearest: a simplex with a corner per pair of vertices (indexA[i], indexB[i]).
struct Nearest {
    float distance;  ///< 0: the cores overlap or touch
    Vec2 normal;     ///< unit length, from A to B, in A's frame; any direction when distance is 0
    int count;       ///< corners: 1 vertex–vertex, 2 with an edge on A, B or both, 3 overlap
    int iterations;
    uint8_t indexA[3], indexB[3];
    Vec2 corners[3];  ///< from the vertex of A to that of B
};

/// Finds the nearest features of core A and of core B placed at xfB in A's frame. Starts from the cached simplex; a
/// cache with count 0 or with indices out of range starts afresh. The cache is updated.
Nearest FindNearest(const Core& a, const Core& b, const Transform& xfB, SimplexCache& cache);

/// The nearest points, in A's frame counted from A's origin; one common point when the cores overlap.
struct NearestPoints {
    Vec2 onA, onB;
};

NearestPoints FindNearestPoints(const Core& a, const Core& b, const Transform& xfB, const Nearest& nearest);

}  // namespace scree
