// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What is common to all joints.

#pragma once

#include <cstdint>

#include "scree/errors.h"
#include "scree/math.h"

namespace scree {

class Body;
struct WorldState;

enum JointType : uint8_t { e_unknownJoint = 0, e_revoluteJoint };

/// Application data of a joint.
struct JointUserData {
    uintptr_t pointer = 0;
};

/// Common input of all joint definitions.
struct JointDef {
    JointType type = e_unknownJoint;
    JointUserData userData;
    Body* bodyA = nullptr;          ///< required
    Body* bodyB = nullptr;          ///< required, not bodyA
    bool collideConnected = false;  ///< whether the two bodies may collide with each other

protected:
    explicit JointDef(JointType jointType) : type(jointType) {}
};

/// A thin, stable handle on a joint; made by World::CreateJoint.
class Joint {
public:
    virtual ~Joint() = default;
    [[nodiscard]] JointType GetType() const;
    [[nodiscard]] Body* GetBodyA();
    [[nodiscard]] Body* GetBodyB();
    [[nodiscard]] bool GetCollideConnected() const;
    [[nodiscard]] JointUserData& GetUserData();
    /// The next joint of the world, newest first; null at the end.
    [[nodiscard]] Joint* GetNext();
    /// Anchors in world coordinates.
    [[nodiscard]] virtual Vec2 GetAnchorA() const = 0;
    [[nodiscard]] virtual Vec2 GetAnchorB() const = 0;
    /// Force on body B at the anchor, N; `inverseDt` = 1 / time step.
    [[nodiscard]] virtual Vec2 GetReactionForce(float inverseDt) const = 0;
    /// Torque on body B, N·m.
    [[nodiscard]] virtual float GetReactionTorque(float inverseDt) const = 0;
    [[nodiscard]] int GetIndex() const { return m_index; }

    Joint(const Joint&) = delete;
    Joint& operator=(const Joint&) = delete;

protected:
    Joint(WorldState* state, int index) : m_state(state), m_index(index) {}
    WorldState* m_state;
    int m_index;
};

}  // namespace scree
