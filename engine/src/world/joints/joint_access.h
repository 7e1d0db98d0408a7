// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What the files of the joint handles share: rows and bodies behind a handle, setters as a chain of checks, and the
// measures of a sliding joint.

#pragma once

#include <utility>

#include "world/guard.h"
#include "world/world_state.h"

namespace scree {

/// Calls may look at it before they find that the joint is dead, which is then refused. A world that went back to a
/// time before the joint has no row for it.
template <typename Row>
Row& RowOf(WorldState* state, JointRow row) {
    auto& rows = state->joints.Store<Row>().rows;
    if (rows.Has(row)) return rows[row];
    thread_local Row none;
    return none = {};
}

/// A setter: checks the handle and the value, then stores it. Usage: `return JointEdit(m_state, this,
/// "WheelJoint::SetDamping").Amount(damping, "damping").Set(Row().damping, damping);`
class JointEdit {
public:
    JointEdit(WorldState* state, const Joint* joint, const char* function)
        : m_state(*state), m_joint(joint), m_guard(*state, function) {
        m_guard.Require(Owns(*state, joint), ErrorCode::foreignHandle, "this", "use a joint that was not destroyed");
    }
    JointEdit& Finite(float value, const char* field) { return m_guard.Finite(value, field), *this; }
    JointEdit& Finite(Vec2 value, const char* field) { return m_guard.Finite(value, field), *this; }
    /// Not negative, but it may be infinite.
    JointEdit& Bound(float value, const char* field) {
        return m_guard.Require(value >= 0.0f, ErrorCode::outOfRange, field, "give a number of at least 0"), *this;
    }
    /// Finite and not negative.
    JointEdit& Amount(float value, const char* field) { return m_guard.Amount(value, field), *this; }
    JointEdit& Require(bool holds, const char* field, const char* cure) {
        return m_guard.Require(holds, ErrorCode::outOfRange, field, cure), *this;
    }

    [[nodiscard]] bool Failed() const { return m_guard.Failed(); }
    [[nodiscard]] ErrorCode Code() const { return m_guard.Code(); }
    /// Of a call that changes the joint's row.
    template <typename... Arguments>
    [[nodiscard]] Recording Record(const Arguments&... arguments) const {
        return m_guard.RecordMotion(m_joint->GetIndex(), arguments...);
    }
    /// Of one that changes what all types have.
    template <typename... Arguments>
    [[nodiscard]] Recording RecordDefinition(const Arguments&... arguments) const {
        return m_guard.Record(m_joint->GetIndex(), arguments...);
    }

    /// Stores without waking.
    template <typename T>
    ErrorCode Set(T& target, T value) {
        if (Failed() || !Allows(target, value)) return Code();
        const Recording recording = Record(value);
        target = value;
        return Code();
    }
    /// Stores and wakes both bodies if the value is new.
    template <typename T>
    ErrorCode SetAndWake(T& target, T value) {
        if (Failed() || target == value || !Allows(target, value)) return Code();
        const Recording recording = Record(value);
        WakeBodies();
        target = value;
        return Code();
    }
    /// Whether the world may use what the joint would use with this value.
    template <typename T>
    bool Allows(T& target, T value) {
        const T before = std::exchange(target, value);
        AllowsNow();
        target = before;
        return !Failed();
    }
    /// The same with the values that it has.
    bool AllowsNow() { return !m_guard.Uses(FeaturesOfJoint(m_state.joints, IndexOf(*m_joint))).Failed(); }
    void WakeBodies() {
        const JointInfo& info = m_state.joints.info[IndexOf(*m_joint)];
        m_state.bodies.Wake(info.bodyA);
        m_state.bodies.Wake(info.bodyB);
    }

private:
    WorldState& m_state;
    const Joint* m_joint;
    Guard m_guard;
};

/// The setters of limits, motors and springs, equal for all joints that have them.
ErrorCode EnableLimit(JointEdit edit, LimitState& limit, bool flag);
ErrorCode SetLimits(JointEdit edit, LimitState& limit, float lower, float upper);
ErrorCode EnableSpring(JointEdit edit, SpringState& spring, bool flag);
ErrorCode SetSpring(JointEdit edit, SpringState& spring, float stiffness, float damping);

/// A point of each body and an axis in A, in body coordinates.
struct SlideFrame {
    Vec2 localAnchorA, localAnchorB, localAxisA;
};
/// From A's anchor to B's, m.
Vec2 GetAnchorGap(const Joint& joint, Vec2 localAnchorA, Vec2 localAnchorB);
/// Way from A's anchor to B's along the axis, m, and how fast it grows, m/s.
float GetSlide(const Joint& joint, const SlideFrame& frame);
float GetSlideSpeed(const Joint& joint, const SlideFrame& frame);
/// The axis of a definition at length 1; zero if it is too short or too long for floats.
Vec2 UnitAxis(Vec2 axis);

}  // namespace scree
