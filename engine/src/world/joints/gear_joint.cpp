// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Gear joint: definition and handle.

#include "scree/gear_joint.h"

#include "world/joints/joint_access.h"
#include "world/joints/joint_definitions.h"

namespace scree {

GearRow& GearJoint::Row() const { return RowOf<GearRow>(m_state, m_row); }

namespace {

bool IsGearable(const Joint* joint) {
    return joint->GetType() == e_revoluteJoint || joint->GetType() == e_prismaticJoint;
}

void CheckSide(const Joint* joint, const char* field, const WorldState& state, Guard& guard) {
    guard.NotNull(joint != nullptr, field, "set both joints");
    if (guard.Failed()) return;
    guard.Require(Owns(state, joint), ErrorCode::foreignHandle, field, "use a living joint of this world");
    if (guard.Failed()) return;
    guard.Require(IsGearable(joint), ErrorCode::outOfRange, field, "use a revolute or prismatic joint");
}

/// Copies what one joint measures; `coordinate` is its present value.
GearSide MakeSide(const Joint& joint, const WorldState& state, float& coordinate) {
    const JointInfo& info = state.joints.info[IndexOf(joint)];
    GearSide side;
    side.joint = IndexOf(joint);
    side.body = info.bodyB;
    side.against = info.bodyA;
    side.slides = info.type == e_prismaticJoint;
    if (side.slides) {
        const auto& prismatic = static_cast<const PrismaticJoint&>(joint);
        side.localAnchor = prismatic.GetLocalAnchorB();
        side.againstAnchor = prismatic.GetLocalAnchorA();
        side.againstAxis = prismatic.GetLocalAxisA();
        side.referenceAngle = prismatic.GetReferenceAngle();
        coordinate = prismatic.GetJointTranslation();
    } else {
        const auto& revolute = static_cast<const RevoluteJoint&>(joint);
        side.localAnchor = revolute.GetLocalAnchorB();
        side.againstAnchor = revolute.GetLocalAnchorA();
        side.referenceAngle = revolute.GetReferenceAngle();
        coordinate = revolute.GetJointAngle();
    }
    return side;
}

}  // namespace

void CheckGear(const GearJointDef& def, const WorldState& state, Guard& guard) {
    CheckSide(def.joint1, "GearJointDef::joint1", state, guard);
    CheckSide(def.joint2, "GearJointDef::joint2", state, guard);
    if (guard.Failed()) return;
    guard
        .Require(def.joint1->GetBodyB() != def.joint2->GetBodyB(), ErrorCode::outOfRange, "GearJointDef::joint2",
                 "use joints with different second bodies")
        .Finite(def.ratio, "GearJointDef::ratio")
        .Require(def.ratio != 0.0f, ErrorCode::outOfRange, "GearJointDef::ratio", "give a ratio other than 0");
}

GearRow MakeGearRow(const GearJointDef& def, const WorldState& state) {
    GearRow row;
    float coordinate1 = 0.0f, coordinate2 = 0.0f;
    row.side[0] = MakeSide(*def.joint1, state, coordinate1);
    row.side[1] = MakeSide(*def.joint2, state, coordinate2);
    row.ratio = def.ratio;
    row.constant = coordinate1 + def.ratio * coordinate2;
    return row;
}

GearBodies BodiesOfGear(const GearRow& gear, const BodyTable& bodies) {
    // A side's joint connects its two bodies. So it is enough to hang on the one that can be pushed, or else on the one
    // that moves.
    static_assert(staticBody < kinematicBody && kinematicBody < dynamicBody);
    const auto moverOf = [&bodies](const GearSide& side) {
        return bodies.type[side.against] > bodies.type[side.body] ? side.against : side.body;
    };
    const GearBodies movers{moverOf(gear.side[0]), moverOf(gear.side[1])};
    if (movers.a != movers.b) return movers;
    // One body moves on both sides: on one of them the other body stands in for it.
    if (movers.a == gear.side[0].body) return {movers.a, gear.side[1].body};
    return {gear.side[0].body, movers.b};
}

Vec2 GearJoint::GetAnchorA() const {
    if (!Lives("GearJoint::GetAnchorA")) return vec2Zero;
    return m_state->bodies.handles[Row().side[0].body].GetWorldPoint(Row().side[0].localAnchor);
}
Vec2 GearJoint::GetAnchorB() const {
    if (!Lives("GearJoint::GetAnchorB")) return vec2Zero;
    return m_state->bodies.handles[Row().side[1].body].GetWorldPoint(Row().side[1].localAnchor);
}
Vec2 GearJoint::GetReactionForce(float inverseDt) const {
    return Lives("GearJoint::GetReactionForce") ? (inverseDt * Row().impulse) * Row().side[0].axis : vec2Zero;
}
float GearJoint::GetReactionTorque(float inverseDt) const {
    return Lives("GearJoint::GetReactionTorque") ? inverseDt * Row().impulse * Row().side[0].arm : 0.0f;
}
Joint* GearJoint::GetJoint1() const {
    return Lives("GearJoint::GetJoint1") ? m_state->joints.handles[Row().side[0].joint] : nullptr;
}
Joint* GearJoint::GetJoint2() const {
    return Lives("GearJoint::GetJoint2") ? m_state->joints.handles[Row().side[1].joint] : nullptr;
}
ErrorCode GearJoint::SetRatio(float ratio) {
    return JointEdit(m_state, this, "GearJoint::SetRatio")
        .Finite(ratio, "ratio")
        .Require(ratio != 0.0f, "ratio", "give a ratio other than 0")
        .Set(Row().ratio, ratio);
}
float GearJoint::GetRatio() const { return Lives("GearJoint::GetRatio") ? Row().ratio : 0.0f; }

}  // namespace scree
