// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What all joint handles have in common, and the setters and measures that several share.

#include "scree/joint.h"

#include "state/frames.h"
#include "world/joints/joint_access.h"

namespace scree {

namespace {

JointInfo& InfoOf(WorldState* s, JointIndex joint) { return s->joints.info[joint]; }
Body* BodyOf(WorldState* s, BodyIndex body) { return &s->bodies.handles[body]; }
Joint* JointOf(WorldState* s, JointIndex joint) { return IsNone(joint) ? nullptr : s->joints.handles[joint]; }

/// Frequency and damping ratio of a spring that acts on `amount` (a mass or an inertia) as stiffness and damping.
ErrorCode FrequencyToSpring(float amount, float frequencyHertz, float dampingRatio, float& stiffness, float& damping) {
    const float omega = 2.0f * pi * frequencyHertz;
    stiffness = amount * omega * omega;
    damping = 2.0f * amount * dampingRatio * omega;
    return ErrorCode::ok;
}

/// What two amounts of which only the difference of motion counts act like; one that is 0 cannot move.
float Reduced(float a, float b) {
    if (a > 0.0f && b > 0.0f) return a * b / (a + b);
    return a > 0.0f ? a : b;
}

ErrorCode CheckSpring(const char* function, float frequencyHertz, float dampingRatio, const Body* a, const Body* b) {
    if (a == nullptr || b == nullptr) return ErrorCode::nullArgument;  // no world whose handler could hear of it
    Guard guard(const_cast<Body*>(a)->GetWorld()->GetState(), function);
    return guard.Amount(frequencyHertz, "frequencyHertz").Amount(dampingRatio, "dampingRatio").Code();
}

}  // namespace

ErrorCode LinearStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio, const Body* bodyA,
                          const Body* bodyB) {
    const ErrorCode code = CheckSpring("LinearStiffness", frequencyHertz, dampingRatio, bodyA, bodyB);
    if (code != ErrorCode::ok) return code;
    return FrequencyToSpring(Reduced(bodyA->GetMass(), bodyB->GetMass()), frequencyHertz, dampingRatio, stiffness,
                             damping);
}

ErrorCode AngularStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio,
                           const Body* bodyA, const Body* bodyB) {
    const ErrorCode code = CheckSpring("AngularStiffness", frequencyHertz, dampingRatio, bodyA, bodyB);
    if (code != ErrorCode::ok) return code;
    return FrequencyToSpring(Reduced(bodyA->GetInertia(), bodyB->GetInertia()), frequencyHertz, dampingRatio, stiffness,
                             damping);
}

bool Joint::Lives(const char* accessor) const {
    if (Owns(*m_state, this)) return true;
    m_state->Refuse(ErrorCode::foreignHandle, accessor, "this", "use a joint that was not destroyed");
    return false;
}

JointType Joint::GetType() const { return Lives("Joint::GetType") ? InfoOf(m_state, m_index).type : e_unknownJoint; }
Body* Joint::GetBodyA() const {
    return Lives("Joint::GetBodyA") ? BodyOf(m_state, InfoOf(m_state, m_index).bodyA) : nullptr;
}
Body* Joint::GetBodyB() const {
    return Lives("Joint::GetBodyB") ? BodyOf(m_state, InfoOf(m_state, m_index).bodyB) : nullptr;
}
Body* Joint::GetOther(const Body* body) const {
    return Lives("Joint::GetOther") ? body == GetBodyA() ? GetBodyB() : GetBodyA() : nullptr;
}
bool Joint::GetCollideConnected() const {
    return Lives("Joint::GetCollideConnected") ? InfoOf(m_state, m_index).collideConnected : false;
}
JointUserData Joint::GetUserData() const {
    return Lives("Joint::GetUserData") ? InfoOf(m_state, m_index).userData : JointUserData{};
}
ErrorCode Joint::SetUserData(const JointUserData& data) {
    if (!Lives("Joint::SetUserData")) return ErrorCode::foreignHandle;
    m_state->definitions.Note();
    InfoOf(m_state, m_index).userData = data;
    return ErrorCode::ok;
}
ErrorCode Joint::SetThresholds(float force, float torque, bool breaks) {
    JointEdit edit(m_state, this, "Joint::SetThresholds");
    if (edit.Bound(force, "force").Bound(torque, "torque").Failed()) return edit.Code();
    JointInfo& info = InfoOf(m_state, m_index);
    const JointInfo before = info;
    info.forceThreshold = force;
    info.torqueThreshold = torque;
    info.breaks = breaks;
    if (!edit.AllowsNow()) {
        info = before;
        return edit.Code();
    }
    const Recording recording = edit.RecordDefinition(force, torque, breaks);
    m_state->joints.NoteThresholds(m_index);
    return ErrorCode::ok;
}
float Joint::GetForceThreshold() const {
    return Lives("Joint::GetForceThreshold") ? InfoOf(m_state, m_index).forceThreshold : 0.0f;
}
float Joint::GetTorqueThreshold() const {
    return Lives("Joint::GetTorqueThreshold") ? InfoOf(m_state, m_index).torqueThreshold : 0.0f;
}
bool Joint::BreaksAtThreshold() const {
    return Lives("Joint::BreaksAtThreshold") ? InfoOf(m_state, m_index).breaks : false;
}
bool Joint::IsEnabled() const {
    return Lives("Joint::IsEnabled") ? GetBodyA()->IsEnabled() && GetBodyB()->IsEnabled() : false;
}
Joint* Joint::GetNext() const {
    return Lives("Joint::GetNext") ? JointOf(m_state, InfoOf(m_state, m_index).listNext) : nullptr;
}
Joint* Joint::GetNext(const Body* body) const {
    if (!Lives("Joint::GetNext")) return nullptr;
    if (body != GetBodyA() && body != GetBodyB()) return nullptr;
    return JointOf(m_state, m_state->joints.NextOfBody(m_index, IndexOf(*body)));
}
void Joint::ShiftOrigin(Vec2 newOrigin) {
    JointEdit edit = JointEdit(m_state, this, "Joint::ShiftOrigin").Finite(newOrigin, "newOrigin");
    if (edit.Failed()) return;
    const Recording recording = edit.Record(newOrigin);
    JointTable::WithStore(m_state->joints, GetType(), [&](auto& store) { ShiftRow(store.rows[m_row], newOrigin); });
}

ErrorCode EnableLimit(JointEdit edit, LimitState& limit, bool flag) {
    if (edit.Failed() || limit.enabled == flag || !edit.Allows(limit.enabled, flag)) return edit.Code();
    const Recording recording = edit.Record(flag);
    edit.WakeBodies();
    limit.enabled = flag;
    limit.lowerImpulse = limit.upperImpulse = 0.0f;
    return edit.Code();
}

ErrorCode SetLimits(JointEdit edit, LimitState& limit, float lower, float upper) {
    edit.Finite(lower, "lower").Finite(upper, "upper").Require(lower <= upper, "lower", "keep it at or below upper");
    if (edit.Failed() || (limit.lower == lower && limit.upper == upper)) return edit.Code();
    const Recording recording = edit.Record(lower, upper);
    edit.WakeBodies();
    limit.lower = lower;
    limit.upper = upper;
    limit.lowerImpulse = limit.upperImpulse = 0.0f;
    return edit.Code();
}

ErrorCode EnableSpring(JointEdit edit, SpringState& spring, bool flag) { return edit.SetAndWake(spring.enabled, flag); }

ErrorCode SetSpring(JointEdit edit, SpringState& spring, float stiffness, float damping) {
    edit.Amount(stiffness, "stiffness").Amount(damping, "damping");
    if (edit.Failed() || (spring.stiffness == stiffness && spring.damping == damping)) return edit.Code();
    if (!edit.Allows(spring.stiffness, stiffness)) return edit.Code();
    const Recording recording = edit.Record(stiffness, damping);
    edit.WakeBodies();
    spring.stiffness = stiffness;
    spring.damping = damping;
    return edit.Code();
}

Vec2 GetAnchorGap(const Joint& joint, Vec2 localAnchorA, Vec2 localAnchorB) {
    Body& a = *joint.GetBodyA();
    return GapBetween(a.GetWorld()->GetState().bodies, IndexOf(a), localAnchorA, IndexOf(*joint.GetBodyB()),
                      localAnchorB);
}

float GetSlide(const Joint& joint, const SlideFrame& frame) {
    const Body& a = *joint.GetBodyA();
    const Vec2 gap = GetAnchorGap(joint, frame.localAnchorA, frame.localAnchorB);
    return Dot(gap, a.GetWorldVector(frame.localAxisA));
}

float GetSlideSpeed(const Joint& joint, const SlideFrame& frame) {
    const Body& a = *joint.GetBodyA();
    const Body& b = *joint.GetBodyB();
    const Vec2 axis = a.GetWorldVector(frame.localAxisA);
    const Vec2 gap = GetAnchorGap(joint, frame.localAnchorA, frame.localAnchorB);
    const Vec2 speed =
        b.GetLinearVelocityFromLocalPoint(frame.localAnchorB) - a.GetLinearVelocityFromLocalPoint(frame.localAnchorA);
    return Dot(axis, speed) + Dot(gap, Cross(a.GetAngularVelocity(), axis));
}

Vec2 UnitAxis(Vec2 axis) {
    const float length = axis.Normalize();
    return length > 0.0f && std::isfinite(length) ? axis : vec2Zero;
}

}  // namespace scree
