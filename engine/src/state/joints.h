// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of joints: what all have in common, a table per type, and which joints hang on which body.

#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/slots.h"
#include "scree/body.h"
#include "scree/joint.h"
#include "scree/revolute_joint.h"

namespace scree {

/// State of a revolute joint: its definition and the impulses that warm-start the next step.
struct RevoluteRow {
    Vec2 localAnchorA, localAnchorB;
    float referenceAngle;
    float lowerAngle, upperAngle;
    float motorSpeed, maxMotorTorque;
    bool enableLimit, enableMotor;
    Vec2 impulse;        ///< N·s
    float motorImpulse;  ///< N·m·s
    float lowerImpulse, upperImpulse;
};

/// What every joint has.
struct JointInfo {
    JointType type = e_unknownJoint;
    bool collideConnected = false;
    int bodyA = -1, bodyB = -1;
    int row = -1;  ///< in the table of its type
    int listPrev = -1, listNext = -1;
    JointUserData userData;
};

struct JointTable {
    Slots slots;
    std::vector<JointInfo> info;
    std::vector<std::unique_ptr<Joint>> handles;
    Slots revoluteSlots;
    std::vector<RevoluteRow> revolute;
    int listHead = -1;

    int AddRevolute(WorldState* state, const RevoluteJointDef& def);
    void Remove(int joint);
    /// Joints of a body, newest first. Valid until joints are added or removed.
    std::span<const int> OfBody(int body);
    /// False if a joint forbids the two bodies to collide.
    bool MayCollide(int bodyA, int bodyB);

private:
    void EnsureAdjacency();

    bool m_adjacencyValid = false;
    std::vector<int> m_first;  ///< per body up to the last one with a joint: start in m_entries; one more at the end
    std::vector<int> m_entries;
};

}  // namespace scree
