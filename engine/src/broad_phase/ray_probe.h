// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// "May this ray, or a box on its way along it, hit this box?" for walks over trees and lists (Ericson, Real-Time
// Collision Detection, §5.3.3, in 2D). The box of the ray's remaining part must overlap, and the normal of the ray must
// not separate the box from it. A margin of a few roundings keeps grazing hits. A wider one for inner nodes makes a
// node pass whenever one of its boxes does. Boxes are asked one by one, two by two (children), or in rows of four
// (leaves). All lengths are doubled, which saves the halves of centres and extents.

#pragma once

#include "broad_phase/bounds.h"
#include "broad_phase/broad_phase.h"
#include "scree/shape.h"

namespace scree::broadphase {

/// What to do after a visitor's answer.
enum class RayStep : uint8_t { goOn, stop };

/// Which of two boxes the ray may hit, and which it meets first.
struct RayFork {
    bool first, second;
    bool isSecondNearer;
};

/// Four boxes by coordinates, as FlatTree keeps them.
struct BoxRow {
    F4 lx, ly, nux, nuy;
};

class RayProbe {
public:
    /// Of a box of this half size whose centre goes along the ray: boxes that it meets are those that the ray meets
    /// when they are larger by as much.
    explicit RayProbe(const RayCastInput& input, Vec2 halfSize = vec2Zero) : m_input(input), m_halfSize(halfSize) {
        Vec2 direction = input.p2 - input.p1;
        direction.Normalize();
        const Vec2 normal = direction.Skew();
        m_direction = Pair(direction);
        m_normal = Pair(normal);
        m_absNormal = Abs4(m_normal);
        m_offset = Splat4(2.0f * Dot(normal, input.p1));
        m_extent = Splat4(2.0f * Dot(Abs(normal), halfSize));
        m_size = Splat4(2.0f * (Abs(input.p1.x) + Abs(input.p1.y) + halfSize.x + halfSize.y));
        Clip(input.maxFraction);
    }

    [[nodiscard]] bool MayHitLeaf(const AABB& box) const {
        const Bounds bounds = ToBounds(box);
        return Reaches(bounds) && (Bits4(MayCross(SplitPair(Load(bounds), Load(bounds)), leafMargin)) & 1u) != 0;
    }
    [[nodiscard]] bool MayHitNode(const Bounds& box) const {
        return Reaches(box) && (Bits4(MayCross(SplitPair(Load(box), Load(box)), nodeMargin)) & 1u) != 0;
    }
    /// Two nodes.
    [[nodiscard]] RayFork MayHitNodes(const Bounds& a, const Bounds& b) const {
        const Corners corners = SplitPair(Load(a), Load(b));
        const F4 along = SumPairs(m_direction * (corners.lower - corners.negatedUpper));
        const uint32_t crosses = Bits4(MayCross(corners, nodeMargin));
        return {(crosses & 1u) != 0 && Reaches(a), (crosses & 4u) != 0 && Reaches(b),
                (Bits4(Less4(SwapHalves4(along), along)) & 1u) != 0};
    }
    /// Four leaves: bit i for box i.
    [[nodiscard]] uint32_t MayHitLeaves(const BoxRow& row) const {
        const Mask4 reachesX =
            And4(LessEqual4(row.lx, SplatLane4<0>(m_reach)), LessEqual4(row.nux, SplatLane4<2>(m_reach)));
        const Mask4 reachesY =
            And4(LessEqual4(row.ly, SplatLane4<1>(m_reach)), LessEqual4(row.nuy, SplatLane4<3>(m_reach)));
        const F4 cx = row.lx - row.nux, cy = row.ly - row.nuy;
        const F4 hx = Negate4(row.lx + row.nux), hy = Negate4(row.ly + row.nuy);
        const F4 distance = SplatLane4<0>(m_normal) * cx + SplatLane4<1>(m_normal) * cy - m_offset;
        const F4 extent = SplatLane4<0>(m_absNormal) * hx + SplatLane4<1>(m_absNormal) * hy + m_extent;
        const F4 size = Abs4(cx) + hx + (Abs4(cy) + hy) + m_size;
        const Mask4 isApart = Greater4(Abs4(distance), extent + Splat4(leafMargin) * size);
        return Bits4(And4(And4(reachesX, reachesY), Not4(isApart)));
    }
    /// Whether the box of the ray's remaining part overlaps.
    [[nodiscard]] bool Reaches(const Bounds& box) const { return Overlaps(Load(box), m_reach); }

    /// Calls the visitor and shortens the ray by its answer: 0 ends the cast, a negative one changes nothing.
    RayStep Visit(RayVisitor visit, uint32_t fixture) {
        const float answer = visit(m_input, fixture);
        if (answer == 0.0f) return RayStep::stop;
        if (answer > 0.0f) Clip(answer);
        return RayStep::goOn;
    }

private:
    static constexpr float leafMargin = 1.0e-6f, nodeMargin = 3.0e-6f;

    /// {ax, ay, bx, by} of boxes a and b.
    struct Corners {
        F4 lower, negatedUpper;
    };
    static Corners SplitPair(F4 a, F4 b) { return {Shuffle4<0, 1, 0, 1>(a, b), Shuffle4<2, 3, 2, 3>(a, b)}; }
    static F4 Pair(Vec2 v) { return Set4(v.x, v.y, v.x, v.y); }
    /// {x + y, x + y} of both halves.
    static F4 SumPairs(F4 v) { return v + Shuffle4<1, 0, 3, 2>(v, v); }

    void Clip(float maxFraction) {
        m_input.maxFraction = maxFraction;
        const Vec2 end = m_input.p1 + maxFraction * (m_input.p2 - m_input.p1);
        m_reach = ProbeOf(Load(ToBounds({Min(m_input.p1, end) - m_halfSize, Max(m_input.p1, end) + m_halfSize})));
    }

    /// Lanes 0 and 1 for box a, 2 and 3 for b: the normal of the ray does not separate the box from its line.
    [[nodiscard]] Mask4 MayCross(const Corners& corners, float relativeMargin) const {
        const F4 centre = corners.lower - corners.negatedUpper;
        const F4 extent = Negate4(corners.lower + corners.negatedUpper);
        const F4 distance = Abs4(SumPairs(m_normal * centre) - m_offset);
        const F4 size = SumPairs(Abs4(centre) + extent) + m_size;
        return Not4(Greater4(distance, SumPairs(m_absNormal * extent) + m_extent + Splat4(relativeMargin) * size));
    }

    RayCastInput m_input;
    Vec2 m_halfSize;
    F4 m_direction, m_normal, m_absNormal;  ///< {x, y, x, y}
    F4 m_offset;                            ///< 2 · normal · p1 in all lanes
    F4 m_extent;                            ///< 2 · |normal| · half size in all lanes
    F4 m_size;                              ///< 2 · (|x| + |y|) of p1 and the half size in all lanes
    F4 m_reach;                             ///< ProbeOf the box of the remaining part
};

}  // namespace scree::broadphase
