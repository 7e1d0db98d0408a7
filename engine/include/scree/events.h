// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What happened in a step, as arrays: a program that reads these needs no listener. Objects are named by ids, which
// tell when one is gone (World::Find).

#pragma once

#include <cstdint>
#include <span>

#include "scree/ids.h"
#include "scree/math.h"

namespace scree {

/// What a fixture reports (FixtureDef::reports, Fixture::SetReports), as bits. A contact is reported if one of its two
/// fixtures reports it. Who does not use this does not pay for it.
struct Report {
    static constexpr uint8_t contacts = 1;  ///< contacts that begin and end; of sensors what enters and leaves
    static constexpr uint8_t hits = 2;      ///< blows of at least World::GetHitSpeed
    static constexpr uint8_t all = contacts | hits;
};

/// Two fixtures began to touch, or ceased to.
struct ContactEvent {
    FixtureId fixtureA, fixtureB;
};

/// A fixture began to overlap a sensor, or ceased to. Like contacts, overlaps with bodies that are asleep stay as they
/// were. Of two sensors A is the sensor.
struct SensorEvent {
    FixtureId sensor, visitor;
};

/// Two fixtures that touch came together fast. A contact may be hit more than once while it lasts.
struct HitEvent {
    FixtureId fixtureA, fixtureB;
    Vec2 point;   ///< where they did so fastest, m
    Vec2 normal;  ///< from A to B
    float speed;  ///< along the normal, before the blow was solved, m/s
};

/// A body was simulated in the step.
struct MoveEvent {
    BodyId body;
    bool fellAsleep;
};

/// The reaction of a joint was above one of its thresholds (JointDef::forceThreshold, torqueThreshold).
struct JointEvent {
    JointId joint;
    float force;   ///< mean over the step, N
    float torque;  ///< N·m
    bool broke;    ///< the joint is gone (JointDef::breaks)
};

/// Of the last step; in the order in which things happened, which is the same for any number of workers. Ends include
/// those of objects destroyed between the step before and this one. Valid until the next step.
struct Events {
    std::span<const ContactEvent> contactsBegun, contactsEnded;
    std::span<const SensorEvent> sensorsEntered, sensorsLeft;
    std::span<const HitEvent> hits;
    std::span<const JointEvent> joints;
    std::span<const MoveEvent> moved;  ///< only with World::SetReportMoves; those that fell asleep stand last
};

}  // namespace scree
