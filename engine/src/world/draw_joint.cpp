// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints as segments, points and dials. Distance, revolute, prismatic and wheel joints show their limits: lower green,
// upper red.

#include "world/draw_joint.h"

#include <cmath>
#include <limits>

#include "scree/body.h"
#include "scree/distance_joint.h"
#include "scree/mouse_joint.h"
#include "scree/prismatic_joint.h"
#include "scree/pulley_joint.h"
#include "scree/revolute_joint.h"
#include "scree/settings.h"
#include "scree/wheel_joint.h"

namespace scree {

namespace {

const Color grey{0.7f, 0.7f, 0.7f};
const Color green{0.3f, 0.9f, 0.3f};
const Color red{0.9f, 0.3f, 0.3f};
const Color blue{0.3f, 0.3f, 0.9f};
const Color darkGrey{0.4f, 0.4f, 0.4f};
const Color cyan{0.5f, 0.8f, 0.8f};
constexpr float endSize = 5.0f;  ///< of a point at an anchor, pixels

/// From body to anchor to anchor to body.
void DrawLinks(const Joint& joint, Draw& draw) {
    const Vec2 a = joint.GetAnchorA();
    const Vec2 b = joint.GetAnchorB();
    draw.DrawSegment(joint.GetBodyA()->GetPosition(), a, cyan);
    draw.DrawSegment(a, b, cyan);
    draw.DrawSegment(joint.GetBodyB()->GetPosition(), b, cyan);
}

void DrawDistance(const DistanceJoint& joint, Draw& draw) {
    const Vec2 a = joint.GetAnchorA();
    const Vec2 b = joint.GetAnchorB();
    Vec2 axis = b - a;
    axis.Normalize();
    draw.DrawSegment(a, b, darkGrey);
    constexpr float restSize = 8.0f, limitSize = 4.0f;  // pixels
    draw.DrawPoint(a + joint.GetLength() * axis, restSize, grey);
    if (joint.GetMinLength() == joint.GetMaxLength()) return;
    if (joint.GetMinLength() > linearSlop) draw.DrawPoint(a + joint.GetMinLength() * axis, limitSize, green);
    if (joint.GetMaxLength() < std::numeric_limits<float>::max())
        draw.DrawPoint(a + joint.GetMaxLength() * axis, limitSize, red);
}

void DrawRevolute(const RevoluteJoint& joint, Draw& draw) {
    const Vec2 a = joint.GetAnchorA();
    const Vec2 b = joint.GetAnchorB();
    draw.DrawPoint(a, endSize, blue);
    draw.DrawPoint(b, endSize, darkGrey);
    constexpr float dialRadius = 0.5f;  // m
    const auto hand = [&](float angle, const Color& color) {
        draw.DrawSegment(b, b + dialRadius * Rot(angle).GetXAxis(), color);
    };
    hand(joint.GetJointAngle(), grey);
    draw.DrawCircle(b, dialRadius, grey);
    if (joint.IsLimitEnabled()) {
        hand(joint.GetLowerLimit(), green);
        hand(joint.GetUpperLimit(), red);
    }
    DrawLinks(joint, draw);
}

/// Prismatic and wheel joints: a rail through the anchor on A.
template <typename SlidingJoint>
void DrawRail(const SlidingJoint& joint, Draw& draw) {
    const Vec2 a = joint.GetAnchorA();
    const Vec2 b = joint.GetAnchorB();
    const Vec2 axis = joint.GetBodyA()->GetWorldVector(joint.GetLocalAxisA());
    draw.DrawSegment(a, b, darkGrey);
    if (joint.IsLimitEnabled()) {
        const Vec2 lower = a + joint.GetLowerLimit() * axis;
        const Vec2 upper = a + joint.GetUpperLimit() * axis;
        const Vec2 halfStop = 0.5f * axis.Skew();
        draw.DrawSegment(lower, upper, grey);
        draw.DrawSegment(lower - halfStop, lower + halfStop, green);
        draw.DrawSegment(upper - halfStop, upper + halfStop, red);
    } else {
        draw.DrawSegment(a - axis, a + axis, grey);
    }
    draw.DrawPoint(a, endSize, grey);
    draw.DrawPoint(b, endSize, blue);
}

void DrawPulley(const PulleyJoint& joint, Draw& draw) {
    const Vec2 groundA = joint.GetGroundAnchorA();
    const Vec2 groundB = joint.GetGroundAnchorB();
    draw.DrawSegment(groundA, joint.GetAnchorA(), cyan);
    draw.DrawSegment(groundB, joint.GetAnchorB(), cyan);
    draw.DrawSegment(groundA, groundB, cyan);
}

void DrawMouse(const MouseJoint& joint, Draw& draw) {
    const Color endColor{0.0f, 1.0f, 0.0f};
    constexpr float size = 4.0f;  // pixels
    draw.DrawPoint(joint.GetAnchorA(), size, endColor);
    draw.DrawPoint(joint.GetAnchorB(), size, endColor);
    draw.DrawSegment(joint.GetAnchorA(), joint.GetAnchorB(), {0.8f, 0.8f, 0.8f});
}

}  // namespace

void DrawJoint(const Joint& joint, Draw& draw) {
    switch (joint.GetType()) {
        case e_distanceJoint:
            return DrawDistance(static_cast<const DistanceJoint&>(joint), draw);
        case e_revoluteJoint:
            return DrawRevolute(static_cast<const RevoluteJoint&>(joint), draw);
        case e_prismaticJoint:
            return DrawRail(static_cast<const PrismaticJoint&>(joint), draw);
        case e_wheelJoint:
            return DrawRail(static_cast<const WheelJoint&>(joint), draw);
        case e_pulleyJoint:
            return DrawPulley(static_cast<const PulleyJoint&>(joint), draw);
        case e_mouseJoint:
            return DrawMouse(static_cast<const MouseJoint&>(joint), draw);
        default:
            return DrawLinks(joint, draw);
    }
}

}  // namespace scree
