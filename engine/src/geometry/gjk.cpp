// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// GJK in 2D on the Minkowski difference B − A: a simplex of at most three of its vertices walks towards the origin.
// Source: Gilbert, Johnson, Keerthi, "A Fast Procedure for Computing the Distance Between Complex Objects in
// Three-Dimensional Space" (1988). The nearest point of a segment and of a triangle is found by signed areas, as in
// Ericson, "Real-Time Collision Detection" (2005), §5.1. The warm start from the last simplex is Box2D 2.4's idea. All
// is done in A's frame, which spares half of the rotations and keeps precision far from the world's origin.

#include "geometry/gjk.h"

namespace scree {

namespace {

// Two to five rounds are usual. Only rounding could go on for longer, and by then the distance is exact to rounding.
constexpr int maxRounds = 32;
constexpr float floatEpsilon = 1.1920929e-7f;

/// A vertex of the Minkowski difference, with the vertices it comes from.
struct Corner {
    Vec2 w;
    uint8_t indexA, indexB;
};

inline Corner MakeCorner(const Core& a, const Core& b, const Transform& xfB, int indexA, int indexB) {
    return {Mul(xfB, b.At(indexB)) - a.At(indexA), static_cast<uint8_t>(indexA), static_cast<uint8_t>(indexB)};
}

struct Simplex {
    Corner corners[3];
    int count;
    /// Points from the simplex to the origin, any length. Across a segment it is the perpendicular, which is exact
    /// even when the origin is close by.
    Vec2 towards;
};

/// Reduces a segment to the part nearest to the origin.
inline void SolveSegment(Simplex& s) {
    const Vec2 w0 = s.corners[0].w, w1 = s.corners[1].w;
    const Vec2 e = w1 - w0;
    const float past0 = -Dot(w0, e);  // how far the origin lies beyond corner 0, along e
    const float past1 = Dot(w1, e);
    if (past0 <= 0.0f) {
        s.count = 1;
        s.towards = -w0;
    } else if (past1 <= 0.0f) {
        s.corners[0] = s.corners[1];
        s.count = 1;
        s.towards = -w1;
    } else {
        s.count = 2;
        s.towards = Cross(w0, e) > 0.0f ? e.Skew() : -e.Skew();
    }
}

/// Squared distance of the origin from a simplex of one or two corners.
inline float DistanceSquared(const Simplex& s) {
    const float along = Dot(s.corners[0].w, s.towards);
    const float squared = s.towards.LengthSquared();
    return squared > 0.0f ? along * along / squared : 0.0f;
}

/// Reduces a triangle to the part nearest to the origin; it stays whole if it contains the origin.
void SolveTriangle(Simplex& s) {
    const Corner c0 = s.corners[0], c1 = s.corners[1], c2 = s.corners[2];
    const float area = Cross(c1.w - c0.w, c2.w - c0.w);
    // Parts of the area seen from the origin: part i belongs to the edge that faces corner i.
    const float sign = area > 0.0f ? 1.0f : -1.0f;
    const float part0 = sign * Cross(c1.w, c2.w);
    const float part1 = sign * Cross(c2.w, c0.w);
    const float part2 = sign * Cross(c0.w, c1.w);
    if (area != 0.0f && part0 >= 0.0f && part1 >= 0.0f && part2 >= 0.0f) {
        s.count = 3;
        s.towards = vec2Zero;
        return;
    }
    // The nearest of the edges that the origin lies outside of; all three if the triangle is flat.
    bool found = false;
    float nearest = 0.0f;
    const auto consider = [&](float part, const Corner& from, const Corner& to) {
        if (area != 0.0f && part >= 0.0f) return;
        Simplex edge;
        edge.corners[0] = from;
        edge.corners[1] = to;
        SolveSegment(edge);
        const float squared = DistanceSquared(edge);
        if (found && squared >= nearest) return;
        found = true;
        nearest = squared;
        s = edge;
    };
    consider(part2, c0, c1);
    consider(part1, c2, c0);
    consider(part0, c1, c2);
    if (!found) {  // not finite
        s.count = 1;
        s.towards = -c0.w;
    }
}

void LoadCache(Simplex& s, const Core& a, const Core& b, const Transform& xfB, const SimplexCache& cache) {
    bool usable = cache.count >= 1 && cache.count <= 3;
    for (int i = 0; usable && i < cache.count; ++i) {
        usable = cache.indexA[i] < a.count && cache.indexB[i] < b.count;
        if (usable) s.corners[i] = MakeCorner(a, b, xfB, cache.indexA[i], cache.indexB[i]);
    }
    s.count = usable ? cache.count : 1;
    if (!usable) s.corners[0] = MakeCorner(a, b, xfB, 0, 0);
}

void Solve(Simplex& s) {
    if (s.count == 3) {
        SolveTriangle(s);
    } else if (s.count == 2) {
        SolveSegment(s);
    } else {
        s.towards = -s.corners[0].w;
    }
}

inline bool Contains(const Simplex& s, int indexA, int indexB) {
    for (int i = 0; i < s.count; ++i) {
        if (s.corners[i].indexA == indexA && s.corners[i].indexB == indexB) return true;
    }
    return false;
}

/// Adds the vertex that reaches farthest towards the origin. False if none comes nearer than the simplex is.
inline bool Extend(Simplex& s, const Core& a, const Core& b, const Transform& xfB) {
    const int indexA = FindExtreme(a, -s.towards);
    const int indexB = FindExtreme(b, MulT(xfB.q, s.towards));
    if (Contains(s, indexA, indexB)) return false;
    const Corner next = MakeCorner(a, b, xfB, indexA, indexB);
    const Vec2 size = Abs(next.w) + Abs(s.corners[0].w);
    const Vec2 step = Abs(s.towards);
    // A gain below the rounding of the corners themselves is none, and taking it could go round in circles.
    if (Dot(next.w - s.corners[0].w, s.towards) <= floatEpsilon * (size.x * step.x + size.y * step.y)) return false;
    s.corners[s.count++] = next;
    return true;
}

Nearest Finish(const Simplex& s, int iterations, SimplexCache& cache) {
    Nearest out;
    out.count = s.count;
    out.iterations = iterations;
    cache.count = static_cast<uint16_t>(s.count);
    for (int i = 0; i < s.count; ++i) {
        out.corners[i] = s.corners[i].w;
        cache.indexA[i] = out.indexA[i] = s.corners[i].indexA;
        cache.indexB[i] = out.indexB[i] = s.corners[i].indexB;
    }
    if (s.count == 3) {
        out.distance = 0.0f;
        out.normal = {1.0f, 0.0f};
        cache.metric = Cross(out.corners[1] - out.corners[0], out.corners[2] - out.corners[0]);
        return out;
    }
    const float length = s.towards.Length();
    const float inv = length > 0.0f ? 1.0f / length : 0.0f;
    out.normal = length > 0.0f ? -inv * s.towards : Vec2{1.0f, 0.0f};
    out.distance = s.count == 1 ? length : Abs(Dot(out.corners[0], s.towards)) * inv;
    // The perpendicular of a segment is as long as the segment.
    cache.metric = s.count == 1 ? 0.0f : length;
    return out;
}

}  // namespace

Nearest FindNearest(const Core& a, const Core& b, const Transform& xfB, SimplexCache& cache) {
    Simplex s;
    LoadCache(s, a, b, xfB, cache);
    Solve(s);
    int iterations = 0;
    while (iterations < maxRounds && s.count < 3 && (s.towards.x != 0.0f || s.towards.y != 0.0f)) {
        ++iterations;
        if (!Extend(s, a, b, xfB)) break;
        Solve(s);
    }
    return Finish(s, iterations, cache);
}

NearestPoints FindNearestPoints(const Core& a, const Core& b, const Transform& xfB, const Nearest& nearest) {
    float weight[3] = {1.0f, 0.0f, 0.0f};
    const Vec2 w0 = nearest.corners[0], w1 = nearest.corners[1], w2 = nearest.corners[2];
    if (nearest.count == 2) {
        const Vec2 e = w1 - w0;
        weight[1] = -Dot(w0, e) / Dot(e, e);
        weight[0] = 1.0f - weight[1];
    } else if (nearest.count == 3) {
        const float inv = 1.0f / Cross(w1 - w0, w2 - w0);
        weight[0] = inv * Cross(w1, w2);
        weight[1] = inv * Cross(w2, w0);
        weight[2] = inv * Cross(w0, w1);
    }
    NearestPoints out{vec2Zero, vec2Zero};
    for (int i = 0; i < nearest.count; ++i) {
        out.onA += weight[i] * a.At(nearest.indexA[i]);
        out.onB += weight[i] * b.At(nearest.indexB[i]);
    }
    out.onB = nearest.count == 3 ? out.onA : Mul(xfB, out.onB);
    return out;
}

}  // namespace scree
