// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the geometry tests share: a seeded source of shapes and placements, their twins in Box2D 2.4.1, and a tally of
// how often two manifolds agree. Box2D is the oracle for types, counts, feature ids and local coordinates.

#pragma once

#include <box2d/box2d.h>

#include <cmath>
#include <cstring>
#include <iostream>
#include <string>

#include "scree/collision.h"
#include "tests/geometry/source.h"

namespace scree::test {

inline b2Vec2 ToBox2d(Vec2 v) { return {v.x, v.y}; }

inline b2Transform ToBox2d(const Transform& xf) {
    // Sine and cosine are copied, so that both engines see the same placement to the last bit.
    b2Transform out;
    out.p = ToBox2d(xf.p);
    out.q.s = xf.q.s;
    out.q.c = xf.q.c;
    return out;
}

inline b2CircleShape ToBox2d(const CircleShape& circle) {
    b2CircleShape out;
    out.m_p = ToBox2d(circle.m_p);
    out.m_radius = circle.m_radius;
    return out;
}

inline b2EdgeShape ToBox2d(const EdgeShape& edge) {
    b2EdgeShape out;
    out.m_vertex0 = ToBox2d(edge.m_vertex0);
    out.m_vertex1 = ToBox2d(edge.m_vertex1);
    out.m_vertex2 = ToBox2d(edge.m_vertex2);
    out.m_vertex3 = ToBox2d(edge.m_vertex3);
    out.m_oneSided = edge.m_oneSided;
    return out;
}

inline b2PolygonShape ToBox2d(const PolygonShape& polygon) {
    b2PolygonShape out;
    out.m_count = polygon.m_count;
    out.m_centroid = ToBox2d(polygon.m_centroid);
    for (int i = 0; i < polygon.m_count; ++i) {
        out.m_vertices[i] = ToBox2d(polygon.m_vertices[i]);
        out.m_normals[i] = ToBox2d(polygon.m_normals[i]);
    }
    return out;
}

inline CircleShape RandomCircle(Source& source) {
    CircleShape circle;
    circle.m_radius = source.Between(0.05f, 1.0f);
    circle.m_p = source.Chance(2) ? Vec2{0.0f, 0.0f} : source.InSquare(1.0f);
    return circle;
}

/// Boxes, regular polygons and hulls of random points, about 1 m across.
inline PolygonShape RandomPolygon(Source& source) {
    PolygonShape polygon;
    const int kind = source.Below(4);
    if (kind == 0) {
        polygon.SetAsBox(0.5f, 0.5f);
    } else if (kind == 1) {
        const float hx = source.Between(0.1f, 1.0f);
        const float hy = source.Between(0.1f, 1.0f);
        polygon.SetAsBox(hx, hy, source.InSquare(0.5f), source.Between(-4.0f, 4.0f));
    } else if (kind == 2) {
        const int count = 3 + source.Below(6);
        Vec2 points[maxPolygonVertices];
        for (int i = 0; i < count; ++i) {
            const Rot q(2.0f * pi * static_cast<float>(i) / static_cast<float>(count));
            points[i] = 0.7f * q.GetXAxis();
        }
        if (!polygon.Set(points, count)) polygon.SetAsBox(0.5f, 0.5f);
    } else {
        const int count = 3 + source.Below(6);
        Vec2 points[maxPolygonVertices];
        do {
            for (int i = 0; i < count; ++i) points[i] = source.InSquare(1.0f);
        } while (!polygon.Set(points, count));
    }
    return polygon;
}

/// One- and two-sided edges; half of the one-sided ones continue a chain that bends gently, as ground does.
inline EdgeShape RandomEdge(Source& source) {
    EdgeShape edge;
    const Vec2 v1 = source.InSquare(1.5f);
    const Vec2 v2 = source.InSquare(1.5f);
    if (source.Chance(3)) {
        edge.SetTwoSided(v1, v2);
    } else if (source.Chance(2)) {
        edge.SetOneSided(source.InSquare(1.5f), v1, v2, source.InSquare(1.5f));
    } else {
        const float left = source.Between(-0.3f, 0.3f);
        edge.SetOneSided({2.0f, left}, {1.0f, 0.0f}, {-1.0f, 0.0f}, {-2.0f, source.Chance(3) ? 0.0f : left});
    }
    return edge;
}

/// Two placements of shapes about 1 m across.
struct Placement {
    Transform a, b;
};

/// Free poses. Poses on a grid of halves and eighths of a turn, where faces line up, vertices lie on edges and
/// separations tie. The same with gaps around the skin. Coincident shapes, and poses a kilometre from the origin.
inline Placement RandomPlacement(Source& source) {
    constexpr float eighth = 0.25f * pi;
    Placement out;
    const int kind = source.Below(5);
    if (kind <= 1) {
        out.a.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        out.b.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
    } else if (kind <= 3) {
        const float step = source.Chance(2) ? eighth : 2.0f * eighth;
        const auto onGrid = [&] {
            return Vec2{0.5f * static_cast<float>(source.Below(5) - 2), 0.5f * static_cast<float>(source.Below(5) - 2)};
        };
        out.a.Set(onGrid(), source.Chance(2) ? 0.0f : step * static_cast<float>(source.Below(8)));
        Vec2 p = onGrid();
        if (kind == 3) p += source.InSquare(4.0f * polygonRadius);
        out.b.Set(p, step * static_cast<float>(source.Below(8)));
    } else {
        out.a.Set(source.InSquare(1.0f), source.Between(-7.0f, 7.0f));
        out.b = out.a;
    }
    if (source.Chance(8)) {
        const Vec2 far{1000.0f, -700.0f};
        out.a.p += far;
        out.b.p += far;
    }
    return out;
}

/// Moves B along the line between the shapes until they barely touch in Box2D's eyes, then off again by up to two
/// skins: the cases where a rounding error decides. `count(b)` is the oracle's number of points with B at the placement
/// b.
template <typename Count>
void BringNearTouching(Source& source, Placement& placement, Count count) {
    const Vec2 direction = Rot(source.Between(-pi, pi)).GetXAxis();
    float touching = 0.0f;
    float apart = 8.0f;
    placement.b.p = placement.a.p;
    Transform b = placement.b;
    for (int i = 0; i < 16; ++i) {
        const float middle = 0.5f * (touching + apart);
        b.p = placement.a.p + middle * direction;
        (count(b) > 0 ? touching : apart) = middle;
    }
    const float jitter = source.Chance(2) ? 2.0f * polygonRadius : 1.0e-5f;
    placement.b.p = placement.a.p + (touching + source.Between(-jitter, jitter)) * direction;
}

inline bool SameBits(Vec2 a, b2Vec2 b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// How far two vectors differ, m or unitless.
inline float Gap(Vec2 a, b2Vec2 b) { return std::fmax(std::fabs(a.x - b.x), std::fabs(a.y - b.y)); }

/// Counts agreement over many configurations.
class Tally {
public:
    explicit Tally(std::string name) : m_name(std::move(name)) {}
    ~Tally() { Print(); }
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;

    void Add(const Manifold& ours, const b2Manifold& theirs) {
        ++m_trials;
        ++m_byCount[theirs.pointCount];
        if (ours.pointCount != theirs.pointCount) {
            ++m_differing;
            return;
        }
        if (theirs.pointCount == 0) return;
        bool sameFeatures = static_cast<int>(ours.type) == static_cast<int>(theirs.type);
        bool sameBits = SameBits(ours.localPoint, theirs.localPoint) && SameBits(ours.localNormal, theirs.localNormal);
        float gap = Max(Gap(ours.localPoint, theirs.localPoint), Gap(ours.localNormal, theirs.localNormal));
        for (int i = 0; i < ours.pointCount; ++i) {
            const b2ContactFeature& id = theirs.points[i].id.cf;
            const ContactFeature& cf = ours.points[i].id.cf;
            sameFeatures = sameFeatures && cf.indexA == id.indexA && cf.indexB == id.indexB && cf.typeA == id.typeA &&
                           cf.typeB == id.typeB;
            sameBits = sameBits && SameBits(ours.points[i].localPoint, theirs.points[i].localPoint);
            gap = Max(gap, Gap(ours.points[i].localPoint, theirs.points[i].localPoint));
        }
        if (!sameFeatures || !std::isfinite(gap)) {
            ++m_differing;
            return;
        }
        if (!sameBits) ++m_otherBits;
        m_largestGap = Max(m_largestGap, gap);
    }

    [[nodiscard]] int Trials() const { return m_trials; }
    [[nodiscard]] int WithPoints(int count) const { return m_byCount[count]; }
    /// Share of trials whose type, point count or feature ids differ.
    [[nodiscard]] double DifferingShare() const { return static_cast<double>(m_differing) / m_trials; }
    /// Largest difference of a local coordinate among manifolds with equal features.
    [[nodiscard]] float LargestGap() const { return m_largestGap; }

private:
    void Print() const {
        std::cout << m_name << ": " << m_trials << " configurations, " << m_byCount[1] << " with one and "
                  << m_byCount[2] << " with two points; " << m_differing << " differ in type, count or ids, "
                  << m_otherBits << " only in bits, largest gap " << m_largestGap << "\n";
    }

    std::string m_name;
    int m_trials = 0;
    int m_byCount[3] = {0, 0, 0};
    int m_differing = 0;
    int m_otherBits = 0;
    float m_largestGap = 0.0f;
};

#if defined(__x86_64__)
// Both libraries evaluate the same expressions in plain single precision: nothing may differ.
inline constexpr double allowedShare = 0.0;
inline constexpr float allowedGap = 0.0f;
#else
// Elsewhere the compiler may have fused Box2D's multiply-adds: ties fall either way, coordinates differ by rounding.
// Local coordinates are below 4 m, placements below 1.3 km; a clip point carries a few roundings of 6e-5 m.
inline constexpr double allowedShare = 0.01;
inline constexpr float allowedGap = 1.0e-3f;
#endif

}  // namespace scree::test
