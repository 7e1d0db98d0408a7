// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One plain row per joint type: what the definition gave, the impulses that warm-start the next step, and the axes
// that reactions are reported along. `Fields` lists the row and `DefinitionFields` what its definition adds to
// JointDef, each once for whatever walks over them (base/field_list.h).

#pragma once

#include <limits>

#include "base/field_list.h"
#include "scree/distance_joint.h"
#include "scree/friction_joint.h"
#include "scree/gear_joint.h"
#include "scree/motor_joint.h"
#include "scree/mouse_joint.h"
#include "scree/prismatic_joint.h"
#include "scree/pulley_joint.h"
#include "scree/revolute_joint.h"
#include "scree/weld_joint.h"
#include "scree/wheel_joint.h"
#include "state/indices.h"

namespace scree {

/// A range of a joint coordinate with the impulses that keep it inside, both ≥ 0.
struct LimitState {
    bool enabled = false;
    float lower = 0.0f, upper = 0.0f;
    float lowerImpulse = 0.0f, upperImpulse = 0.0f;

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [enabled, lower, upper, lowerImpulse, upperImpulse] = row;
        visit(enabled, lower, upper, lowerImpulse, upperImpulse);
    }
};

/// A drive of a joint coordinate towards a speed, bounded by a force or torque.
struct MotorState {
    bool enabled = false;
    float speed = 0.0f, maximum = 0.0f;
    float impulse = 0.0f;

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [enabled, speed, maximum, impulse] = row;
        visit(enabled, speed, maximum, impulse);
    }
};

/// A spring that drives a joint coordinate towards a target, bounded by a force or torque.
struct SpringState {
    bool enabled = false;
    float stiffness = 0.0f, damping = 0.0f;
    float target = 0.0f;
    float maximum = std::numeric_limits<float>::infinity();
    float impulse = 0.0f;

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [enabled, stiffness, damping, target, maximum, impulse] = row;
        visit(enabled, stiffness, damping, target, maximum, impulse);
    }
};

struct RevoluteRow {
    using Definition = RevoluteJointDef;
    using Handle = RevoluteJoint;
    static constexpr JointType type = e_revoluteJoint;

    Vec2 localAnchorA, localAnchorB;
    float referenceAngle;
    LimitState limit;
    MotorState motor;
    SpringState spring;        ///< of the joint angle
    Vec2 impulse{0.0f, 0.0f};  ///< of the shared point, N·s

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [localAnchorA, localAnchorB, referenceAngle, limit, motor, spring, impulse] = row;
        visit(localAnchorA, localAnchorB, referenceAngle, impulse, limit, motor, spring);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.localAnchorA, def.localAnchorB, def.referenceAngle, def.enableLimit,
                           def.lowerAngle, def.upperAngle, def.enableMotor, def.motorSpeed, def.maxMotorTorque,
                           def.enableSpring, def.stiffness, def.damping, def.targetAngle, def.maxSpringTorque);
    }
};

struct PrismaticRow {
    using Definition = PrismaticJointDef;
    using Handle = PrismaticJoint;
    static constexpr JointType type = e_prismaticJoint;

    Vec2 localAnchorA, localAnchorB, localAxisA;
    float referenceAngle;
    LimitState limit;
    MotorState motor;
    SpringState spring;        ///< of the translation
    Vec2 impulse{0.0f, 0.0f};  ///< across the axis, N·s, and against turning, N·m·s
    Vec2 axis{0.0f, 0.0f};     ///< in world coordinates in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [localAnchorA, localAnchorB, localAxisA, referenceAngle, limit, motor, spring, impulse, axis] = row;
        visit(localAnchorA, localAnchorB, localAxisA, referenceAngle, impulse, axis, limit, motor, spring);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.localAnchorA, def.localAnchorB, def.localAxisA, def.referenceAngle,
                           def.enableLimit, def.lowerTranslation, def.upperTranslation, def.enableMotor,
                           def.maxMotorForce, def.motorSpeed, def.enableSpring, def.stiffness, def.damping,
                           def.targetTranslation, def.maxSpringForce);
    }
};

struct WheelRow {
    using Definition = WheelJointDef;
    using Handle = WheelJoint;
    static constexpr JointType type = e_wheelJoint;

    Vec2 localAnchorA, localAnchorB, localAxisA;
    float stiffness, damping, maxSpringForce;
    LimitState limit;
    MotorState motor;
    float impulse = 0.0f;        ///< across the axis, N·s
    float springImpulse = 0.0f;  ///< along it
    Vec2 axis{0.0f, 0.0f};       ///< in world coordinates in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [localAnchorA, localAnchorB, localAxisA, stiffness, damping, maxSpringForce, limit, motor, impulse,
               springImpulse, axis] = row;
        visit(localAnchorA, localAnchorB, localAxisA, stiffness, damping, maxSpringForce, impulse, springImpulse, axis,
              limit, motor);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.localAnchorA, def.localAnchorB, def.localAxisA, def.enableLimit,
                           def.lowerTranslation, def.upperTranslation, def.enableMotor, def.maxMotorTorque,
                           def.motorSpeed, def.stiffness, def.damping, def.maxSpringForce);
    }
};

struct DistanceRow {
    using Definition = DistanceJointDef;
    using Handle = DistanceJoint;
    static constexpr JointType type = e_distanceJoint;

    Vec2 localAnchorA, localAnchorB;
    float length, stiffness, damping, maxSpringForce;
    float shortest;         ///< what length and limits are at least: linearSlop times WorldDef::lengthScale, m
    LimitState limit;       ///< of the length; always enabled
    float impulse = 0.0f;   ///< of the spring or rod, N·s
    Vec2 axis{0.0f, 0.0f};  ///< from A to B in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [localAnchorA, localAnchorB, length, stiffness, damping, maxSpringForce, shortest, limit, impulse, axis] =
            row;
        visit(localAnchorA, localAnchorB, length, stiffness, damping, maxSpringForce, shortest, impulse, axis, limit);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.localAnchorA, def.localAnchorB, def.length, def.minLength, def.maxLength,
                           def.stiffness, def.damping, def.maxSpringForce);
    }
};

struct PulleyRow {
    using Definition = PulleyJointDef;
    using Handle = PulleyJoint;
    static constexpr JointType type = e_pulleyJoint;

    Vec2 groundAnchorA, groundAnchorB, localAnchorA, localAnchorB;
    float lengthA, lengthB, ratio;
    float constant;         ///< lengthA + ratio·lengthB, m
    float impulse = 0.0f;   ///< tension in A's part of the rope, N·s
    Vec2 axis{0.0f, 0.0f};  ///< from B's ground anchor to B in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [groundAnchorA, groundAnchorB, localAnchorA, localAnchorB, lengthA, lengthB, ratio, constant, impulse,
               axis] = row;
        visit(groundAnchorA, groundAnchorB, localAnchorA, localAnchorB, lengthA, lengthB, ratio, constant, impulse,
              axis);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.groundAnchorA, def.groundAnchorB, def.localAnchorA, def.localAnchorB,
                           def.lengthA, def.lengthB, def.ratio);
    }
};

struct MouseRow {
    using Definition = MouseJointDef;
    using Handle = MouseJoint;
    static constexpr JointType type = e_mouseJoint;

    Vec2 target, localAnchorB;
    float maxForce, stiffness, damping;
    Vec2 impulse{0.0f, 0.0f};  ///< N·s

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [target, localAnchorB, maxForce, stiffness, damping, impulse] = row;
        visit(target, localAnchorB, maxForce, stiffness, damping, impulse);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.target, def.maxForce, def.stiffness, def.damping);
    }
};

/// One side of a gear: the body that a revolute or prismatic joint moves, against that joint's other body.
struct GearSide {
    JointIndex joint = JointIndex::none;                          ///< index of the revolute or prismatic joint
    BodyIndex body = BodyIndex::none, against = BodyIndex::none;  ///< its body B and body A
    bool slides = false;                                          ///< prismatic
    Vec2 localAnchor{0.0f, 0.0f}, againstAnchor{0.0f, 0.0f}, againstAxis{0.0f, 0.0f};
    float referenceAngle = 0.0f;
    Vec2 axis{0.0f, 0.0f};  ///< of the push on `body` per unit of impulse in the last step
    float arm = 0.0f;       ///< of the turn

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [joint, body, against, slides, localAnchor, againstAnchor, againstAxis, referenceAngle, axis, arm] = row;
        visit(joint, body, against, slides, localAnchor, againstAnchor, againstAxis, referenceAngle, axis, arm);
    }
};

struct GearRow {
    using Definition = GearJointDef;
    using Handle = GearJoint;
    static constexpr JointType type = e_gearJoint;

    GearSide side[2];
    float ratio, constant;
    float impulse = 0.0f;

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [side, ratio, constant, impulse] = row;
        visit(side, ratio, constant, impulse);
    }
    /// The two joints are written as indices.
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        NamesAllOf<JointDef>(def, def.joint1, def.joint2, def.ratio);
        visit(def.ratio), visit.LeftOut(def.joint1, def.joint2);
    }
};

struct WeldRow {
    using Definition = WeldJointDef;
    using Handle = WeldJoint;
    static constexpr JointType type = e_weldJoint;

    Vec2 localAnchorA, localAnchorB;
    float referenceAngle, stiffness, damping;
    Vec2 impulse{0.0f, 0.0f};  ///< N·s
    float turnImpulse = 0.0f;  ///< N·m·s

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [localAnchorA, localAnchorB, referenceAngle, stiffness, damping, impulse, turnImpulse] = row;
        visit(localAnchorA, localAnchorB, referenceAngle, stiffness, damping, impulse, turnImpulse);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.localAnchorA, def.localAnchorB, def.referenceAngle, def.stiffness,
                           def.damping);
    }
};

struct FrictionRow {
    using Definition = FrictionJointDef;
    using Handle = FrictionJoint;
    static constexpr JointType type = e_frictionJoint;

    Vec2 localAnchorA, localAnchorB;
    float maxForce, maxTorque;
    Vec2 impulse{0.0f, 0.0f};  ///< N·s
    float turnImpulse = 0.0f;  ///< N·m·s

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [localAnchorA, localAnchorB, maxForce, maxTorque, impulse, turnImpulse] = row;
        visit(localAnchorA, localAnchorB, maxForce, maxTorque, impulse, turnImpulse);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.localAnchorA, def.localAnchorB, def.maxForce, def.maxTorque);
    }
};

struct MotorRow {
    using Definition = MotorJointDef;
    using Handle = MotorJoint;
    static constexpr JointType type = e_motorJoint;

    Vec2 linearOffset;
    float angularOffset, maxForce, maxTorque, correctionFactor;
    Vec2 impulse{0.0f, 0.0f};  ///< N·s
    float turnImpulse = 0.0f;  ///< N·m·s

    template <typename Self, typename Visit>
    static void Fields(Self& row, Visit& visit) {
        auto& [linearOffset, angularOffset, maxForce, maxTorque, correctionFactor, impulse, turnImpulse] = row;
        visit(linearOffset, angularOffset, maxForce, maxTorque, correctionFactor, impulse, turnImpulse);
    }
    template <typename Self, typename Visit>
    static void DefinitionFields(Self& def, Visit& visit) {
        VisitOwn<JointDef>(def, visit, def.linearOffset, def.angularOffset, def.maxForce, def.maxTorque,
                           def.correctionFactor);
    }
};

/// All types, listed once. A new one is its row above, a name here, its file in constraints/ with its traits, and its
/// definition and handle in world/joints/.
template <template <typename...> typename Use>
using OfJointTypes =
    Use<RevoluteRow, PrismaticRow, DistanceRow, PulleyRow, MouseRow, GearRow, WheelRow, WeldRow, FrictionRow, MotorRow>;

/// Moves what a row keeps in world coordinates; most rows keep nothing.
template <typename Row>
void ShiftRow(Row&, Vec2 /*newOrigin*/) {}
inline void ShiftRow(MouseRow& row, Vec2 newOrigin) { row.target -= newOrigin; }
inline void ShiftRow(PulleyRow& row, Vec2 newOrigin) {
    row.groundAnchorA -= newOrigin;
    row.groundAnchorB -= newOrigin;
}

}  // namespace scree
