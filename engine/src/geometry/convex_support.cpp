// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A support function → a core of at most 64 vertices with curved sides. The sandwich algorithm with the chord rule (G.
// Rote, "The Convergence Rate of the Sandwich Algorithm for Approximating Convex Functions", Computing 48, 1992). The
// side with the largest distance between outline and chord is split where that distance is reached. That distance is
// exact, so the remaining error is known.

#include <initializer_list>
#include <vector>

#include "geometry/convex_build.h"

namespace scree {

namespace {

/// Nearer points are one vertex, and flatter arcs are straight; a share of the extent.
constexpr float rounding = 1.0e-5f;
/// No side is split for less than this share of the extent.
constexpr float fineness = 1.0e-4f;
/// How much a point may lie beyond what the support function said; a share of the extent.
constexpr float dishonesty = 1.0e-4f;

/// A point of the outline and a direction in which it is the outermost one.
struct Sample {
    Vec2 point, normal;
};

/// A sample and the best place to split the side that begins there.
struct Link {
    Sample start, split;
    float height;  ///< of the outline over the chord, m
};

class Sampler {
public:
    explicit Sampler(const SupportDef& def) : m_def(def) {}

    bool Run(ConvexShape& shape) {
        for (const Vec2 d : {Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}, Vec2{-1.0f, 0.0f}, Vec2{0.0f, -1.0f}}) {
            m_links.push_back({Take(d), {}, 0.0f});
        }
        if (!m_good) return false;
        m_extent = Max(m_links[0].start.point.x - m_links[2].start.point.x,
                       m_links[1].start.point.y - m_links[3].start.point.y);
        for (size_t i = 0; i < 4; ++i) Measure(i);
        while (m_good && m_links.size() < static_cast<size_t>(maxConvexVertices) && SplitHighest()) {
        }
        return m_good && IsHonest() && Fill(shape);
    }

private:
    Sample Take(Vec2 direction) {
        const Vec2 point = m_def.support(m_def.data, direction);
        m_good = m_good && point.IsValid() && point.Length() <= m_def.boundingRadius * (1.0f + rounding);
        return {point, direction};
    }

    [[nodiscard]] const Sample& After(size_t i) const { return m_links[i + 1 < m_links.size() ? i + 1 : 0].start; }

    void Measure(size_t i) {
        Link& link = m_links[i];
        link.height = 0.0f;
        Vec2 normal = Cross(After(i).point - link.start.point, 1.0f);
        if (normal.Normalize() <= rounding * m_extent) return;
        link.split = Take(normal);
        link.height = Max(Dot(normal, link.split.point - link.start.point), 0.0f);
    }

    bool SplitHighest() {
        size_t best = 0;
        for (size_t i = 1; i < m_links.size(); ++i) {
            if (m_links[i].height > m_links[best].height) best = i;
        }
        if (!(m_links[best].height > fineness * m_extent)) return false;
        m_links.insert(m_links.begin() + static_cast<std::ptrdiff_t>(best) + 1, {m_links[best].split, {}, 0.0f});
        Measure(best);
        Measure(best + 1);
        return true;
    }

    /// No sample may lie beyond the line that another one says is the outermost.
    [[nodiscard]] bool IsHonest() const {
        for (const Link& a : m_links) {
            for (const Link& b : m_links) {
                if (Dot(a.start.normal, b.start.point - a.start.point) > dishonesty * m_extent) return false;
            }
        }
        return true;
    }

    /// Where the tangents at both ends of a side meet, or half-way to it over the split if they meet elsewhere (an arc
    /// that ends in a corner).
    [[nodiscard]] Vec2 ControlPoint(const Sample& from, const Sample& to, const Link& link) const {
        const Vec2 middle = 0.5f * (from.point + to.point);
        const Vec2 plain = middle + 2.0f * link.height * link.split.normal;
        const Vec2 tangent = Cross(1.0f, from.normal);
        const float rate = Dot(to.normal, tangent);
        if (!(rate > FLT_EPSILON)) return plain;
        const Vec2 meet = from.point + Dot(to.normal, to.point - from.point) / rate * tangent;
        const float height = Dot(link.split.normal, meet - middle);
        // Over a smooth arc the outline lies half as high as the tangents' meeting point.
        return Abs(0.5f * height - link.height) <= 0.1f * link.height ? meet : plain;
    }

    bool Fill(ConvexShape& shape) const {
        const float near = rounding * m_extent;
        for (size_t i = 0; i < m_links.size(); ++i) {
            const Link& link = m_links[i];
            if (Distance(link.start.point, After(i).point) <= near) continue;
            const int side = shape.m_count++;
            shape.m_vertices[side] = link.start.point;
            shape.m_error = Max(shape.m_error, link.height);
            if (link.height <= near) continue;
            shape.m_curvedSides |= uint64_t{1} << side;
            shape.m_controls[side] = ControlPoint(link.start, After(i), link);
        }
        if (shape.m_count < 3) return false;
        FinishSides(shape);
        return true;
    }

    const SupportDef& m_def;
    std::vector<Link> m_links;
    float m_extent = 0.0f;
    bool m_good = true;
};

/// Integrates over the arcs, each as four chords.
MassData ArcMass(const ConvexShape& shape) {
    Vec2 points[4 * maxConvexVertices]{};
    int count = 0;
    for (int i = 0; i < shape.m_count; ++i) {
        const Vec2 v0 = shape.m_vertices[i], control = shape.m_controls[i];
        const Vec2 v2 = shape.m_vertices[i + 1 < shape.m_count ? i + 1 : 0];
        for (const float u : {0.0f, 0.25f, 0.5f, 0.75f}) {
            const Vec2 a = v0 + u * (control - v0), b = control + u * (v2 - control);
            points[count++] = a + u * (b - a);
            if (!shape.IsCurved(i)) break;
        }
    }
    return OutlineMass(points, count);
}

}  // namespace

ConvexShape MakeFromSupport(const SupportDef& def) {
    if (def.support == nullptr) return MakeBadConvex("SupportDef::support");
    if (!std::isfinite(def.boundingRadius) || !(def.boundingRadius > 0.0f))
        return MakeBadConvex("SupportDef::boundingRadius");
    ConvexShape shape;
    if (!Sampler(def).Run(shape)) return MakeBadConvex("SupportDef::support");
    shape.m_unitMass = ArcMass(shape);
    if (!(shape.m_unitMass.mass > FLT_EPSILON) || !shape.Validate()) return MakeBadConvex("SupportDef::support");
    if (def.mass == nullptr) return shape;
    shape.m_unitMass = def.mass(def.data);
    const MassData& mass = shape.m_unitMass;
    const bool isGood = std::isfinite(mass.mass) && mass.mass > 0.0f && mass.center.IsValid() &&
                        std::isfinite(mass.I) && mass.I > mass.mass * mass.center.LengthSquared();
    return isGood ? shape : MakeBadConvex("SupportDef::mass");
}

}  // namespace scree
