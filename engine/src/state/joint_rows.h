// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One plain row per joint type: what the definition gave, the impulses that warm-start the next step, and the axes
// that reactions are reported along. `Fields` lists a row once for whatever walks over the state (hash, snapshot).

#pragma once

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

namespace scree {

/// A range of a joint coordinate with the impulses that keep it inside, both ≥ 0.
struct LimitState {
    bool enabled = false;
    float lower = 0.0f, upper = 0.0f;
    float lowerImpulse = 0.0f, upperImpulse = 0.0f;

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.enabled), visit(r.lower), visit(r.upper), visit(r.lowerImpulse), visit(r.upperImpulse);
    }
};

/// A drive of a joint coordinate towards a speed, bounded by a force or torque.
struct MotorState {
    bool enabled = false;
    float speed = 0.0f, maximum = 0.0f;
    float impulse = 0.0f;

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.enabled), visit(r.speed), visit(r.maximum), visit(r.impulse);
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
    Vec2 impulse{0.0f, 0.0f};  ///< of the shared point, N·s

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.localAnchorA), visit(r.localAnchorB), visit(r.referenceAngle), visit(r.impulse);
        LimitState::Fields(r.limit, visit), MotorState::Fields(r.motor, visit);
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
    Vec2 impulse{0.0f, 0.0f};  ///< across the axis, N·s, and against turning, N·m·s
    Vec2 axis{0.0f, 0.0f};     ///< in world coordinates in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.localAnchorA), visit(r.localAnchorB), visit(r.localAxisA), visit(r.referenceAngle);
        visit(r.impulse), visit(r.axis);
        LimitState::Fields(r.limit, visit), MotorState::Fields(r.motor, visit);
    }
};

struct WheelRow {
    using Definition = WheelJointDef;
    using Handle = WheelJoint;
    static constexpr JointType type = e_wheelJoint;

    Vec2 localAnchorA, localAnchorB, localAxisA;
    float stiffness, damping;
    LimitState limit;
    MotorState motor;
    float impulse = 0.0f;        ///< across the axis, N·s
    float springImpulse = 0.0f;  ///< along it
    Vec2 axis{0.0f, 0.0f};       ///< in world coordinates in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.localAnchorA), visit(r.localAnchorB), visit(r.localAxisA), visit(r.stiffness), visit(r.damping);
        visit(r.impulse), visit(r.springImpulse), visit(r.axis);
        LimitState::Fields(r.limit, visit), MotorState::Fields(r.motor, visit);
    }
};

struct DistanceRow {
    using Definition = DistanceJointDef;
    using Handle = DistanceJoint;
    static constexpr JointType type = e_distanceJoint;

    Vec2 localAnchorA, localAnchorB;
    float length, stiffness, damping;
    float shortest;         ///< what length and limits are at least: linearSlop times WorldDef::lengthScale, m
    LimitState limit;       ///< of the length; always enabled
    float impulse = 0.0f;   ///< of the spring or rod, N·s
    Vec2 axis{0.0f, 0.0f};  ///< from A to B in the last step

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.localAnchorA), visit(r.localAnchorB), visit(r.length), visit(r.stiffness), visit(r.damping);
        visit(r.shortest), visit(r.impulse), visit(r.axis);
        LimitState::Fields(r.limit, visit);
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
    static void Fields(Self& r, Visit&& visit) {
        visit(r.groundAnchorA), visit(r.groundAnchorB), visit(r.localAnchorA), visit(r.localAnchorB);
        visit(r.lengthA), visit(r.lengthB), visit(r.ratio), visit(r.constant), visit(r.impulse), visit(r.axis);
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
    static void Fields(Self& r, Visit&& visit) {
        visit(r.target), visit(r.localAnchorB), visit(r.maxForce), visit(r.stiffness), visit(r.damping),
            visit(r.impulse);
    }
};

/// One side of a gear: the body that a revolute or prismatic joint moves, against that joint's other body.
struct GearSide {
    int joint = -1;               ///< index of the revolute or prismatic joint
    int body = -1, against = -1;  ///< its body B and body A
    bool slides = false;          ///< prismatic
    Vec2 localAnchor{0.0f, 0.0f}, againstAnchor{0.0f, 0.0f}, againstAxis{0.0f, 0.0f};
    float referenceAngle = 0.0f;
    Vec2 axis{0.0f, 0.0f};  ///< of the push on `body` per unit of impulse in the last step
    float arm = 0.0f;       ///< of the turn

    template <typename Self, typename Visit>
    static void Fields(Self& r, Visit&& visit) {
        visit(r.joint), visit(r.body), visit(r.against), visit(r.slides), visit(r.localAnchor), visit(r.againstAnchor);
        visit(r.againstAxis), visit(r.referenceAngle), visit(r.axis), visit(r.arm);
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
    static void Fields(Self& r, Visit&& visit) {
        GearSide::Fields(r.side[0], visit), GearSide::Fields(r.side[1], visit);
        visit(r.ratio), visit(r.constant), visit(r.impulse);
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
    static void Fields(Self& r, Visit&& visit) {
        visit(r.localAnchorA), visit(r.localAnchorB), visit(r.referenceAngle), visit(r.stiffness), visit(r.damping);
        visit(r.impulse), visit(r.turnImpulse);
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
    static void Fields(Self& r, Visit&& visit) {
        visit(r.localAnchorA), visit(r.localAnchorB), visit(r.maxForce), visit(r.maxTorque);
        visit(r.impulse), visit(r.turnImpulse);
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
    static void Fields(Self& r, Visit&& visit) {
        visit(r.linearOffset), visit(r.angularOffset), visit(r.maxForce), visit(r.maxTorque), visit(r.correctionFactor);
        visit(r.impulse), visit(r.turnImpulse);
    }
};

/// Moves what a row keeps in world coordinates; most rows keep nothing.
template <typename Row>
void ShiftRow(Row&, Vec2 /*newOrigin*/) {}
inline void ShiftRow(MouseRow& row, Vec2 newOrigin) { row.target -= newOrigin; }
inline void ShiftRow(PulleyRow& row, Vec2 newOrigin) {
    row.groundAnchorA -= newOrigin;
    row.groundAnchorB -= newOrigin;
}

}  // namespace scree
