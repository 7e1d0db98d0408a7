// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pulley joint: definition and handle.

#include "scree/pulley_joint.h"

#include "state/frames.h"
#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

namespace {

float RopeLength(Body* body, Vec2 localAnchor, Vec2 groundAnchor) {
    const BodyTable& bodies = body->GetWorld()->GetState().bodies;
    const Vec2 frame = FrameOf(bodies, IndexOf(*body), IndexOf(*body));
    return Distance(Mul(TransformIn(frame, bodies, IndexOf(*body)), localAnchor), groundAnchor - frame);
}

}  // namespace

PulleyRow& PulleyJoint::Row() const { return RowOf<PulleyRow>(m_state, m_row); }

void PulleyJointDef::Initialize(Body* a, Body* b, const PulleyPoints& points, float pulleyRatio) {
    bodyA = a;
    bodyB = b;
    groundAnchorA = points.groundAnchorA;
    groundAnchorB = points.groundAnchorB;
    lengthA = Distance(points.anchorA, points.groundAnchorA);
    lengthB = Distance(points.anchorB, points.groundAnchorB);
    ratio = pulleyRatio;
    if (a == nullptr || b == nullptr) return;  // CreateJoint says so
    localAnchorA = a->GetLocalPoint(points.anchorA);
    localAnchorB = b->GetLocalPoint(points.anchorB);
}

void Check(const PulleyJointDef& def, Guard& guard) {
    guard.Finite(def.groundAnchorA, "PulleyJointDef::groundAnchorA")
        .Finite(def.groundAnchorB, "PulleyJointDef::groundAnchorB")
        .Finite(def.localAnchorA, "PulleyJointDef::localAnchorA")
        .Finite(def.localAnchorB, "PulleyJointDef::localAnchorB")
        .Amount(def.lengthA, "PulleyJointDef::lengthA")
        .Amount(def.lengthB, "PulleyJointDef::lengthB")
        .Finite(def.ratio, "PulleyJointDef::ratio")
        .Require(def.ratio != 0.0f, ErrorCode::outOfRange, "PulleyJointDef::ratio", "give a ratio other than 0");
}

PulleyRow MakeRow(const PulleyJointDef& def) {
    return {.groundAnchorA = def.groundAnchorA,
            .groundAnchorB = def.groundAnchorB,
            .localAnchorA = def.localAnchorA,
            .localAnchorB = def.localAnchorB,
            .lengthA = def.lengthA,
            .lengthB = def.lengthB,
            .ratio = def.ratio,
            .constant = def.lengthA + def.ratio * def.lengthB};
}

Vec2 PulleyJoint::GetAnchorA() const {
    return Lives("PulleyJoint::GetAnchorA") ? GetBodyA()->GetWorldPoint(Row().localAnchorA) : vec2Zero;
}
Vec2 PulleyJoint::GetAnchorB() const {
    return Lives("PulleyJoint::GetAnchorB") ? GetBodyB()->GetWorldPoint(Row().localAnchorB) : vec2Zero;
}
Vec2 PulleyJoint::GetReactionForce(float inverseDt) const {
    return Lives("PulleyJoint::GetReactionForce") ? (inverseDt * Row().impulse) * Row().axis : vec2Zero;
}
float PulleyJoint::GetReactionTorque(float) const {
    (void)Lives("PulleyJoint::GetReactionTorque");
    return 0.0f;
}
Vec2 PulleyJoint::GetGroundAnchorA() const {
    return Lives("PulleyJoint::GetGroundAnchorA") ? Row().groundAnchorA : vec2Zero;
}
Vec2 PulleyJoint::GetGroundAnchorB() const {
    return Lives("PulleyJoint::GetGroundAnchorB") ? Row().groundAnchorB : vec2Zero;
}
float PulleyJoint::GetLengthA() const { return Lives("PulleyJoint::GetLengthA") ? Row().lengthA : 0.0f; }
float PulleyJoint::GetLengthB() const { return Lives("PulleyJoint::GetLengthB") ? Row().lengthB : 0.0f; }
float PulleyJoint::GetRatio() const { return Lives("PulleyJoint::GetRatio") ? Row().ratio : 0.0f; }
float PulleyJoint::GetCurrentLengthA() const {
    return Lives("PulleyJoint::GetCurrentLengthA") ? RopeLength(GetBodyA(), Row().localAnchorA, Row().groundAnchorA)
                                                   : 0.0f;
}
float PulleyJoint::GetCurrentLengthB() const {
    return Lives("PulleyJoint::GetCurrentLengthB") ? RopeLength(GetBodyB(), Row().localAnchorB, Row().groundAnchorB)
                                                   : 0.0f;
}

}  // namespace scree
