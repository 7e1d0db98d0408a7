// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A turn by t about a centre at distance r takes a point along a chord of at most r·min(t, 2). It takes it off that
// chord by at most r·(1 − cos(t/2)), which is less than r·t²/8.

#include "geometry/swept_box.h"

#include "geometry/reach.h"

namespace scree {

AABB SweptBox(const Shape& shape, const Sweep& sweep, const Transform& end) {
    AABB box, start;
    shape.ComputeAABB(&box, end);
    Transform xf = end;
    if (sweep.a0 != sweep.a) xf.q.Set(sweep.a0);
    xf.p = sweep.c0 - Mul(xf.q, sweep.localCenter);
    shape.ComputeAABB(&start, xf);
    box.Combine(start);
    const float turn = Abs(sweep.a - sweep.a0);
    if (turn > 0.0f) {
        const float reach = Reach(shape, sweep.localCenter);
        const float bulge = turn < pi ? reach * (1.0f - SinCos(0.5f * turn).cos) : 2.0f * reach;
        box.lowerBound -= Vec2{bulge, bulge};
        box.upperBound += Vec2{bulge, bulge};
    }
    return box;
}

QuickSweep::QuickSweep(Vec2 from, Vec2 to, float turn, float margin)
    : m_from(from), m_way(to - from), m_margin(margin) {
    const float most = Abs(turn);
    m_perReach = Min(most, 2.0f) + (most < pi ? 0.125f * most * most : 2.0f);
}

AABB QuickSweep::Cover(const AABB& start) const {
    float wider = m_margin;
    if (m_perReach > 0.0f) {
        const Vec2 low = m_from - start.lowerBound, high = start.upperBound - m_from;
        const Vec2 corner{Max(Abs(low.x), Abs(high.x)), Max(Abs(low.y), Abs(high.y))};
        wider += m_perReach * (corner.Length() + m_margin);
    }
    const Vec2 all{wider, wider};
    return {start.lowerBound + Min(m_way, vec2Zero) - all, start.upperBound + Max(m_way, vec2Zero) + all};
}

}  // namespace scree
