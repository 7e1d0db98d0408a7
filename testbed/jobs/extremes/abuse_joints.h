// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A bad number in each field of each kind of joint, over the names of one engine.

#pragma once

namespace testbed {

/// Calls tryOne(what, definition) with a definition of every kind for each of its numbers, good but for that one, which
/// is x. `a` and `b` are dynamic bodies; `revolute` and `prismatic` are joints for gears.
template <class E, class Body, class Joint, class Try>
void SpoilJoints(float x, Body* a, Body* b, Joint* revolute, Joint* prismatic, Try&& tryOne) {
    using Vec = typename E::Vec;
    const auto spoil = [&](const char* what, const auto& good, auto... members) {
        const auto one = [&](auto member) {
            auto def = good;
            if constexpr (requires { def.*member = Vec(x, x); }) {
                def.*member = Vec(x, 0.5f);
            } else {
                def.*member = x;
            }
            def.bodyA = a;
            def.bodyB = b;
            tryOne(what, def);
        };
        (one(members), ...);
    };
    using Revolute = typename E::RevoluteDef;
    Revolute hinge;
    hinge.enableLimit = hinge.enableMotor = true;
    spoil("revolute joint", hinge, &Revolute::localAnchorA, &Revolute::localAnchorB, &Revolute::referenceAngle,
          &Revolute::lowerAngle, &Revolute::upperAngle, &Revolute::motorSpeed, &Revolute::maxMotorTorque);
    using Prismatic = typename E::PrismaticDef;
    Prismatic slide;
    slide.enableLimit = slide.enableMotor = true;
    spoil("prismatic joint", slide, &Prismatic::localAnchorA, &Prismatic::localAnchorB, &Prismatic::localAxisA,
          &Prismatic::referenceAngle, &Prismatic::lowerTranslation, &Prismatic::upperTranslation,
          &Prismatic::maxMotorForce, &Prismatic::motorSpeed);
    using Distance = typename E::DistanceDef;
    Distance rod;
    rod.length = rod.minLength = rod.maxLength = 1.0f;
    spoil("distance joint", rod, &Distance::localAnchorA, &Distance::localAnchorB, &Distance::length,
          &Distance::minLength, &Distance::maxLength, &Distance::stiffness, &Distance::damping);
    using Pulley = typename E::PulleyDef;
    Pulley rope;
    rope.lengthA = rope.lengthB = 1.0f;
    spoil("pulley joint", rope, &Pulley::groundAnchorA, &Pulley::groundAnchorB, &Pulley::localAnchorA,
          &Pulley::localAnchorB, &Pulley::lengthA, &Pulley::lengthB, &Pulley::ratio);
    using Mouse = typename E::MouseDef;
    Mouse pull;
    pull.maxForce = 10.0f;
    pull.stiffness = 1.0f;
    spoil("mouse joint", pull, &Mouse::target, &Mouse::maxForce, &Mouse::stiffness, &Mouse::damping);
    using Gear = typename E::GearDef;
    Gear gear;
    gear.joint1 = revolute;
    gear.joint2 = prismatic;
    spoil("gear joint", gear, &Gear::ratio);
    using Wheel = typename E::WheelDef;
    Wheel wheel;
    wheel.enableLimit = wheel.enableMotor = true;
    spoil("wheel joint", wheel, &Wheel::localAnchorA, &Wheel::localAnchorB, &Wheel::localAxisA,
          &Wheel::lowerTranslation, &Wheel::upperTranslation, &Wheel::maxMotorTorque, &Wheel::motorSpeed,
          &Wheel::stiffness, &Wheel::damping);
    using Weld = typename E::WeldDef;
    spoil("weld joint", Weld(), &Weld::localAnchorA, &Weld::localAnchorB, &Weld::referenceAngle, &Weld::stiffness,
          &Weld::damping);
    using Friction = typename E::FrictionDef;
    spoil("friction joint", Friction(), &Friction::localAnchorA, &Friction::localAnchorB, &Friction::maxForce,
          &Friction::maxTorque);
    using Motor = typename E::MotorDef;
    spoil("motor joint", Motor(), &Motor::linearOffset, &Motor::angularOffset, &Motor::maxForce, &Motor::maxTorque,
          &Motor::correctionFactor);
}

}  // namespace testbed
