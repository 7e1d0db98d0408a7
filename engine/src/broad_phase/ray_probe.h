// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// "May this ray hit this box?" for walks over trees and lists (Ericson, Real-Time Collision Detection, §5.3.3, in 2D).
// The box of the ray's remaining part must overlap, and the normal of the ray must not separate the box from it. A
// margin of a few roundings keeps grazing hits. A wider one for inner nodes makes a node pass whenever one of its boxes
// does.

#pragma once

#include "broad_phase/bounds.h"
#include "broad_phase/broad_phase.h"
#include "scree/shape.h"

namespace scree::broadphase {

/// What to do after a visitor's answer.
enum class RayStep : uint8_t { goOn, stop };

class RayProbe {
public:
    explicit RayProbe(const RayCastInput& input) : m_input(input) {
        Vec2 direction = input.p2 - input.p1;
        direction.Normalize();
        m_normal = direction.Skew();
        m_absNormal = Abs(m_normal);
        Clip(input.maxFraction);
    }

    [[nodiscard]] bool MayHitLeaf(const AABB& box) const { return MayHit(box, 1.0e-6f); }
    [[nodiscard]] bool MayHitNode(const AABB& box) const { return MayHit(box, 3.0e-6f); }

    /// Calls the visitor and shortens the ray by its answer: 0 ends the cast, a negative one changes nothing.
    RayStep Visit(RayVisitor visit, uint32_t fixture) {
        const float answer = visit(m_input, fixture);
        if (answer == 0.0f) return RayStep::stop;
        if (answer > 0.0f) Clip(answer);
        return RayStep::goOn;
    }

private:
    void Clip(float maxFraction) {
        m_input.maxFraction = maxFraction;
        const Vec2 end = m_input.p1 + maxFraction * (m_input.p2 - m_input.p1);
        m_box = {Min(m_input.p1, end), Max(m_input.p1, end)};
    }

    [[nodiscard]] bool MayHit(const AABB& box, float relativeMargin) const {
        if (!TestOverlap(m_box, box)) return false;
        const Vec2 c = box.GetCenter();
        const Vec2 h = box.GetExtents();
        const float size = Abs(m_input.p1.x) + Abs(m_input.p1.y) + Abs(c.x) + Abs(c.y) + h.x + h.y;
        return Abs(Dot(m_normal, m_input.p1 - c)) <= Dot(m_absNormal, h) + relativeMargin * size;
    }

    RayCastInput m_input;
    Vec2 m_normal, m_absNormal;
    AABB m_box;
};

}  // namespace scree::broadphase
