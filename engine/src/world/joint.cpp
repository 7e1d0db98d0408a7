// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joint handles.

#include "scree/joint.h"

#include "scree/body.h"
#include "scree/revolute_joint.h"
#include "world/world_state.h"

namespace scree {

namespace {

JointInfo& InfoOf(WorldState* s, int joint) { return s->joints.info[static_cast<size_t>(joint)]; }
RevoluteRow& RevoluteOf(WorldState* s, int joint) {
    return s->joints.revolute[static_cast<size_t>(InfoOf(s, joint).row)];
}
Body* BodyOf(WorldState* s, int body) { return &s->bodies.handles[static_cast<size_t>(body)]; }

void WakeBodies(WorldState* s, int joint) {
    s->bodies.Wake(InfoOf(s, joint).bodyA);
    s->bodies.Wake(InfoOf(s, joint).bodyB);
}

}  // namespace

JointType Joint::GetType() const { return InfoOf(m_state, m_index).type; }
Body* Joint::GetBodyA() { return BodyOf(m_state, InfoOf(m_state, m_index).bodyA); }
Body* Joint::GetBodyB() { return BodyOf(m_state, InfoOf(m_state, m_index).bodyB); }
bool Joint::GetCollideConnected() const { return InfoOf(m_state, m_index).collideConnected; }
JointUserData& Joint::GetUserData() { return InfoOf(m_state, m_index).userData; }
Joint* Joint::GetNext() {
    const int next = InfoOf(m_state, m_index).listNext;
    return next < 0 ? nullptr : m_state->joints.handles[static_cast<size_t>(next)].get();
}

void RevoluteJointDef::Initialize(Body* a, Body* b, Vec2 anchor) {
    bodyA = a;
    bodyB = b;
    localAnchorA = a->GetLocalPoint(anchor);
    localAnchorB = b->GetLocalPoint(anchor);
    referenceAngle = b->GetAngle() - a->GetAngle();
}

Vec2 RevoluteJoint::GetAnchorA() const {
    return BodyOf(m_state, InfoOf(m_state, m_index).bodyA)->GetWorldPoint(GetLocalAnchorA());
}
Vec2 RevoluteJoint::GetAnchorB() const {
    return BodyOf(m_state, InfoOf(m_state, m_index).bodyB)->GetWorldPoint(GetLocalAnchorB());
}
Vec2 RevoluteJoint::GetReactionForce(float inverseDt) const { return inverseDt * RevoluteOf(m_state, m_index).impulse; }
float RevoluteJoint::GetReactionTorque(float inverseDt) const {
    const RevoluteRow& row = RevoluteOf(m_state, m_index);
    return inverseDt * (row.motorImpulse + row.lowerImpulse - row.upperImpulse);
}
Vec2 RevoluteJoint::GetLocalAnchorA() const { return RevoluteOf(m_state, m_index).localAnchorA; }
Vec2 RevoluteJoint::GetLocalAnchorB() const { return RevoluteOf(m_state, m_index).localAnchorB; }
float RevoluteJoint::GetReferenceAngle() const { return RevoluteOf(m_state, m_index).referenceAngle; }
float RevoluteJoint::GetJointAngle() const {
    const JointInfo& info = InfoOf(m_state, m_index);
    return BodyOf(m_state, info.bodyB)->GetAngle() - BodyOf(m_state, info.bodyA)->GetAngle() - GetReferenceAngle();
}
float RevoluteJoint::GetJointSpeed() const {
    const JointInfo& info = InfoOf(m_state, m_index);
    return BodyOf(m_state, info.bodyB)->GetAngularVelocity() - BodyOf(m_state, info.bodyA)->GetAngularVelocity();
}

bool RevoluteJoint::IsLimitEnabled() const { return RevoluteOf(m_state, m_index).enableLimit; }
ErrorCode RevoluteJoint::EnableLimit(bool flag) {
    RevoluteRow& row = RevoluteOf(m_state, m_index);
    if (row.enableLimit == flag) return ErrorCode::ok;
    WakeBodies(m_state, m_index);
    row.enableLimit = flag;
    row.lowerImpulse = row.upperImpulse = 0.0f;
    return ErrorCode::ok;
}
float RevoluteJoint::GetLowerLimit() const { return RevoluteOf(m_state, m_index).lowerAngle; }
float RevoluteJoint::GetUpperLimit() const { return RevoluteOf(m_state, m_index).upperAngle; }
ErrorCode RevoluteJoint::SetLimits(float lower, float upper) {
    const char* name = "RevoluteJoint::SetLimits";
    if (!std::isfinite(lower)) return m_state->Refuse(ErrorCode::nonFinite, name, "lower", "give a finite angle");
    if (!std::isfinite(upper)) return m_state->Refuse(ErrorCode::nonFinite, name, "upper", "give a finite angle");
    if (lower > upper) return m_state->Refuse(ErrorCode::outOfRange, name, "lower", "keep it at or below upper");
    RevoluteRow& row = RevoluteOf(m_state, m_index);
    if (row.lowerAngle == lower && row.upperAngle == upper) return ErrorCode::ok;
    WakeBodies(m_state, m_index);
    row.lowerAngle = lower;
    row.upperAngle = upper;
    row.lowerImpulse = row.upperImpulse = 0.0f;
    return ErrorCode::ok;
}

bool RevoluteJoint::IsMotorEnabled() const { return RevoluteOf(m_state, m_index).enableMotor; }
ErrorCode RevoluteJoint::EnableMotor(bool flag) {
    RevoluteRow& row = RevoluteOf(m_state, m_index);
    if (row.enableMotor == flag) return ErrorCode::ok;
    WakeBodies(m_state, m_index);
    row.enableMotor = flag;
    return ErrorCode::ok;
}
ErrorCode RevoluteJoint::SetMotorSpeed(float speed) {
    if (!std::isfinite(speed))
        return m_state->Refuse(ErrorCode::nonFinite, "RevoluteJoint::SetMotorSpeed", "speed", "give a finite speed");
    RevoluteRow& row = RevoluteOf(m_state, m_index);
    if (row.motorSpeed == speed) return ErrorCode::ok;
    WakeBodies(m_state, m_index);
    row.motorSpeed = speed;
    return ErrorCode::ok;
}
float RevoluteJoint::GetMotorSpeed() const { return RevoluteOf(m_state, m_index).motorSpeed; }
ErrorCode RevoluteJoint::SetMaxMotorTorque(float torque) {
    const char* name = "RevoluteJoint::SetMaxMotorTorque";
    if (!std::isfinite(torque)) return m_state->Refuse(ErrorCode::nonFinite, name, "torque", "give a finite torque");
    if (torque < 0.0f) return m_state->Refuse(ErrorCode::outOfRange, name, "torque", "give at least 0");
    RevoluteRow& row = RevoluteOf(m_state, m_index);
    if (row.maxMotorTorque == torque) return ErrorCode::ok;
    WakeBodies(m_state, m_index);
    row.maxMotorTorque = torque;
    return ErrorCode::ok;
}
float RevoluteJoint::GetMaxMotorTorque() const { return RevoluteOf(m_state, m_index).maxMotorTorque; }
float RevoluteJoint::GetMotorTorque(float inverseDt) const {
    return inverseDt * RevoluteOf(m_state, m_index).motorImpulse;
}

}  // namespace scree
