// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What all joints have in common: the base of definitions and of handles, and helpers for springs.

#pragma once

#include <cstdint>
#include <limits>

#include "scree/api.h"
#include "scree/errors.h"
#include "scree/math.h"

namespace scree {

class Body;
struct WorldState;
enum class JointIndex : int;  // state/indices.h
enum class JointRow : int;    // state/indices.h

/// The numbers are Box2D's. No joint has the type e_ropeJoint: a distance joint with a maximum length is a rope.
enum JointType : uint8_t {
    e_unknownJoint,
    e_revoluteJoint,
    e_prismaticJoint,
    e_distanceJoint,
    e_pulleyJoint,
    e_mouseJoint,
    e_gearJoint,
    e_wheelJoint,
    e_weldJoint,
    e_frictionJoint,
    e_ropeJoint,
    e_motorJoint
};

/// Application data of a joint.
struct JointUserData {
    uintptr_t pointer = 0;
};

/// Common input of all joint definitions.
struct JointDef {
    JointType type = e_unknownJoint;  ///< set by the concrete definition
    JointUserData userData;
    Body* bodyA = nullptr;          ///< required (a gear takes its bodies from its joints)
    Body* bodyB = nullptr;          ///< required, not bodyA
    bool collideConnected = false;  ///< whether the two bodies may collide with each other
    /// If the reaction in a step exceeds one of these, that is an event (Events::joints); N and N·m, ≥ 0.
    float forceThreshold = std::numeric_limits<float>::infinity();
    float torqueThreshold = std::numeric_limits<float>::infinity();
    bool breaks = false;  ///< the joint is then destroyed at the end of the step

protected:
    explicit JointDef(JointType jointType) : type(jointType) {}
};

/// Stiffness (N/m) and damping (N·s/m) of a spring between two bodies that oscillates at `frequencyHertz` with
/// `dampingRatio` (0 none, 1 critical). Refused: null bodies, negative or non-finite numbers; outputs do not change.
SCREE_API ErrorCode LinearStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio,
                                    const Body* bodyA, const Body* bodyB);
/// The same for a rotational spring: N·m/rad and N·m·s/rad.
SCREE_API ErrorCode AngularStiffness(float& stiffness, float& damping, float frequencyHertz, float dampingRatio,
                                     const Body* bodyA, const Body* bodyB);

/// A handle of a joint, created by World::CreateJoint. For a bad number, a setter returns an error and changes nothing.
/// If a joint is destroyed, the gear joints that use it are destroyed first. Every call of a destroyed joint reports an
/// error and returns 0, false or null.
class SCREE_API Joint {
public:
    virtual ~Joint() = default;
    [[nodiscard]] JointType GetType() const;
    [[nodiscard]] Body* GetBodyA() const;
    [[nodiscard]] Body* GetBodyB() const;
    /// The other one of the joint's two bodies.
    [[nodiscard]] Body* GetOther(const Body* body) const;
    [[nodiscard]] bool GetCollideConnected() const;
    [[nodiscard]] JointUserData GetUserData() const;
    ErrorCode SetUserData(const JointUserData& data);
    /// Reactions, N and N·m, ≥ 0, above which the joint reports an event (Events::joints), and whether it then breaks.
    /// Infinity: never. Refused in a world whose fixed features lack Feature::events.
    ErrorCode SetThresholds(float force, float torque, bool breaks);
    [[nodiscard]] float GetForceThreshold() const;
    [[nodiscard]] float GetTorqueThreshold() const;
    [[nodiscard]] bool BreaksAtThreshold() const;
    /// True if both bodies are enabled.
    [[nodiscard]] bool IsEnabled() const;
    /// The next joint of the world, newest first; null at the end.
    [[nodiscard]] Joint* GetNext() const;
    /// The next joint of one of its bodies, newest first; null at the end. Start at Body::GetJointList.
    [[nodiscard]] Joint* GetNext(const Body* body) const;
    /// Moves what the joint stores in world coordinates. World::ShiftOrigin does this for all joints.
    void ShiftOrigin(Vec2 newOrigin);
    /// Anchors in world coordinates.
    [[nodiscard]] virtual Vec2 GetAnchorA() const = 0;
    [[nodiscard]] virtual Vec2 GetAnchorB() const = 0;
    /// Force on body B at the anchor, N; `inverseDt` = 1 / time step.
    [[nodiscard]] virtual Vec2 GetReactionForce(float inverseDt) const = 0;
    /// Torque on body B, N·m.
    [[nodiscard]] virtual float GetReactionTorque(float inverseDt) const = 0;
    /// Number of this joint in its world, from 0; used again after destruction.
    [[nodiscard]] int GetIndex() const { return static_cast<int>(m_index); }

    Joint(const Joint&) = delete;
    Joint& operator=(const Joint&) = delete;

protected:
    friend struct JointTable;
    /// Whether the joint exists; if not, the error handler gets the name of the
    /// accessor.
    [[nodiscard]] bool Lives(const char* accessor) const;
    Joint(WorldState* state, JointIndex index, JointRow row) : m_state(state), m_index(index), m_row(row) {}
    WorldState* m_state;
    JointIndex m_index;
    JointRow m_row;  ///< in the table of its type
};

}  // namespace scree
