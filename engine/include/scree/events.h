// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What happened in a step, as arrays: a program that reads these needs no listener. Events name objects by ids;
// World::Find tells whether an object still exists.

#pragma once

#include <cstdint>
#include <span>

#include "scree/ids.h"
#include "scree/math.h"

namespace scree {

/// What a fixture reports (FixtureDef::reports, Fixture::SetReports), as bits. A contact is reported if at least one of
/// its two fixtures reports it. A world in which no fixture reports pays nothing.
struct Report {
    static constexpr uint8_t contacts = 1;  ///< contacts that begin and end; for sensors, overlaps that do
    static constexpr uint8_t hits = 2;      ///< hits of at least World::GetHitSpeed
    static constexpr uint8_t all = contacts | hits;
};

/// Two fixtures began or stopped touching.
struct ContactEvent {
    FixtureId fixtureA, fixtureB;
};

/// A fixture began or stopped overlapping a sensor. Overlaps with sleeping bodies stay as they are, like contacts. If
/// both fixtures are sensors, fixture A of the contact is `sensor`.
struct SensorEvent {
    FixtureId sensor, visitor;
};

/// Two touching fixtures approached each other fast. This can happen more than once while a contact lasts.
struct HitEvent {
    FixtureId fixtureA, fixtureB;
    Vec2 point;   ///< where the approach was fastest, m
    Vec2 normal;  ///< unit, from A to B
    float speed;  ///< of the approach along the normal, before it was solved, m/s
};

/// A body was simulated in the step.
struct MoveEvent {
    BodyId body;
    bool fellAsleep;
};

/// The reaction of a joint was above one of its thresholds (JointDef::forceThreshold, torqueThreshold).
struct JointEvent {
    JointId joint;
    float force;   ///< mean over the step, N; infinite if no number holds it
    float torque;  ///< N·m; likewise
    bool broke;    ///< the joint was destroyed (JointDef::breaks)
};

/// Events of the last step, in the order in which they happened, which does not depend on the number of threads. Ends
/// include those of objects that were destroyed between the previous step and this one. Valid until the next step.
struct Events {
    std::span<const ContactEvent> contactsBegun, contactsEnded;
    std::span<const SensorEvent> sensorsEntered, sensorsLeft;
    std::span<const HitEvent> hits;
    std::span<const JointEvent> joints;
    std::span<const MoveEvent> moved;  ///< only with World::SetReportMoves; those that fell asleep come last
};

}  // namespace scree
