// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// From a definition to a joint: one check and one row maker per type, and the creation and removal of any joint.

#pragma once

#include "world/guard.h"
#include "world/world_state.h"

namespace scree {

/// Finds the first wrong field, the bodies apart.
void Check(const RevoluteJointDef& def, Guard& guard);
void Check(const PrismaticJointDef& def, Guard& guard);
void Check(const DistanceJointDef& def, Guard& guard);
void Check(const PulleyJointDef& def, Guard& guard);
void Check(const MouseJointDef& def, Guard& guard);
void Check(const WheelJointDef& def, Guard& guard);
void Check(const WeldJointDef& def, Guard& guard);
void Check(const FrictionJointDef& def, Guard& guard);
void Check(const MotorJointDef& def, Guard& guard);
/// Its two joints stand in for the bodies.
void CheckGear(const GearJointDef& def, const WorldState& state, Guard& guard);

/// The row of a valid definition.
RevoluteRow MakeRow(const RevoluteJointDef& def);
PrismaticRow MakeRow(const PrismaticJointDef& def);
/// `slop`: what its lengths are at least, m.
DistanceRow MakeRow(const DistanceJointDef& def, float slop);
PulleyRow MakeRow(const PulleyJointDef& def);
MouseRow MakeRow(const MouseJointDef& def);
WheelRow MakeRow(const WheelJointDef& def);
WeldRow MakeRow(const WeldJointDef& def);
FrictionRow MakeRow(const FrictionJointDef& def);
MotorRow MakeRow(const MotorJointDef& def);
GearRow MakeGearRow(const GearJointDef& def, const WorldState& state);

/// Checks the definition and makes the joint; null and an error for a bad one.
Joint* AddJoint(WorldState& state, const JointDef& def);
/// The bodies of a gear, which are in an island with all that it moves.
struct GearBodies {
    BodyIndex a, b;
    bool operator==(const GearBodies&) const = default;
};
GearBodies BodiesOfGear(const GearRow& gear, const BodyTable& bodies);
/// After types of bodies have changed, or were read: gears get the bodies that they are to have.
void RehangGears(WorldState& state);

/// A gear that uses this joint, −1 if none does. Gears go before their joints.
JointIndex FindGearOf(const WorldState& state, JointIndex joint);
/// Takes a joint out of the world, after the gears that use it.
void RemoveJointWithGears(WorldState& state, JointIndex joint);
/// At the end of a step: tells of the joints above a threshold, and takes out those that break.
void BreakStrainedJoints(WorldState& state);
/// Takes a joint that no gear uses out of the world and wakes its bodies.
void RemoveJoint(WorldState& state, JointIndex joint);

}  // namespace scree
