// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Revolute joints with random springs, motors and limits, and all bits of what they and their bodies do.

#pragma once

#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "tests/world/fixtures.h"

namespace scree::test {

/// Draws of a structure.
class Draws {
public:
    explicit Draws(uint32_t seed) : m_random(seed) {}
    float Any(float low, float high) { return std::uniform_real_distribution<float>(low, high)(m_random); }
    uint32_t Below(uint32_t count) { return m_random() % count; }
    bool OneIn(uint32_t count) { return Below(count) == 0; }

private:
    std::mt19937 m_random;
};

/// Gives a hinge between two bodies some of limits, a motor and a spring.
inline void GiveRange(RevoluteJointDef& def, Draws& draw) {
    def.enableLimit = !draw.OneIn(4);
    def.lowerAngle = draw.Any(-1.0f, 0.1f);
    def.upperAngle = def.lowerAngle + (draw.OneIn(5) ? 0.0f : draw.Any(0.0f, 1.0f));
    def.enableMotor = draw.OneIn(3);
    def.motorSpeed = draw.Any(-4.0f, 4.0f);
    def.maxMotorTorque = draw.Any(0.0f, 5.0f);
    def.enableSpring = draw.OneIn(3);
    AngularStiffness(def.stiffness, def.damping, draw.Any(1.0f, 6.0f), 0.5f, def.bodyA, def.bodyB);
    def.targetAngle = draw.Any(-0.5f, 0.5f);
    if (draw.OneIn(2)) def.maxSpringTorque = draw.Any(0.1f, 5.0f);
}

/// A box that its like do not touch.
inline Body* AddLimb(World& world, Vec2 place, float heaviest, Draws& draw) {
    Body* limb = AddBody(world, dynamicBody, place, draw.Any(-0.5f, 0.5f));
    const float halfWidth = draw.Any(0.2f, 0.5f), halfHeight = draw.Any(0.1f, 0.2f);
    Filter filter;
    filter.groupIndex = -1;
    AddBox(limb, halfWidth, halfHeight, draw.Any(0.5f, heaviest))->SetFilterData(filter);
    limb->SetAngularVelocity(draw.Any(-4.0f, 4.0f));
    return limb;
}

inline std::vector<uint32_t> GetBits(const std::vector<Body*>& bodies, const std::vector<RevoluteJoint*>& joints) {
    std::vector<uint32_t> bits;
    const auto add = [&bits](float x) { bits.push_back(std::bit_cast<uint32_t>(x)); };
    for (const Body* body : bodies) {
        add(body->GetPosition().x), add(body->GetPosition().y), add(body->GetAngle());
        add(body->GetLinearVelocity().x), add(body->GetLinearVelocity().y), add(body->GetAngularVelocity());
    }
    for (const RevoluteJoint* joint : joints) {
        const Vec2 force = joint->GetReactionForce(60.0f);
        add(force.x), add(force.y), add(joint->GetReactionTorque(60.0f)), add(joint->GetMotorTorque(60.0f));
    }
    return bits;
}

/// Hinges that are out of their range, or within a milliradian of an end.
inline int CountAtLimits(const std::vector<RevoluteJoint*>& joints) {
    int count = 0;
    for (const RevoluteJoint* joint : joints) {
        const float at = joint->GetJointAngle();
        const float room = Min(at - joint->GetLowerLimit(), joint->GetUpperLimit() - at);
        if (joint->IsLimitEnabled() && room < 0.001f) ++count;
    }
    return count;
}

}  // namespace scree::test
