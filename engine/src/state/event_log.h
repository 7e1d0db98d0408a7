// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The events of a step for World::GetEvents, kept as they come. Ends that come between steps wait for the next step.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "scree/events.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"

namespace scree {

/// Ends between steps, for the next step.
struct LaterEnds {
    std::vector<ContactEvent> ended;
    std::vector<SensorEvent> left;

    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(ended, left); }
};

class EventLog {
public:
    explicit EventLog(const FixtureTable& fixtures) : m_fixtures(fixtures) {}

    float hitSpeed = 1.0f;      ///< m/s
    bool reportsMoves = false;  ///< which bodies were simulated

    void BeginStep() {
        m_inStep = true;
        if (m_hasEvents) Renew();
    }
    void EndStep() { m_inStep = false; }
    /// Whether a fixture of the pair reports this.
    [[nodiscard]] bool Wants(const ContactPair& pair, uint8_t report) const {
        return ((m_fixtures.info[pair.fixtureA].reports | m_fixtures.info[pair.fixtureB].reports) & report) != 0;
    }
    /// A contact has begun or ended.
    void NoteChange(const ContactPair& pair, bool isSensor, bool begins);
    /// `normal` from A to B.
    void NoteHit(const ContactPair& pair, Vec2 point, Vec2 normal, float speed);
    void NoteJoint(JointId joint, float force, float torque, bool broke) {
        m_hasEvents = true;
        m_joints.push_back({joint, force, torque, broke});
    }
    /// Once all are awake that the step is going to simulate.
    void NoteAsleep(const BodyTable& bodies);
    /// At its end, while what fell asleep in it is listed.
    void NoteMoves(const BodyTable& bodies);

    [[nodiscard]] Events Get() const;
    [[nodiscard]] const LaterEnds& GetLater() const { return m_later; }
    /// The world is another one now: forgets all events but these.
    void Restart(const LaterEnds& later);
    [[nodiscard]] size_t GetMemoryBytes() const {
        return m_later.GetMemoryBytes() +
               BytesOf(m_begun, m_ended, m_entered, m_left, m_hits, m_joints, m_moved, m_asleep);
    }

private:
    [[nodiscard]] FixtureId IdOf(FixtureIndex fixture) const {
        return {ToInt(fixture), m_fixtures.slots.GetGeneration(fixture)};
    }

    /// The arrays of a new step.
    void Renew();

    const FixtureTable& m_fixtures;
    bool m_inStep = false;
    bool m_hasEvents = false;  ///< some array may not be empty
    std::vector<ContactEvent> m_begun, m_ended;
    std::vector<SensorEvent> m_entered, m_left;
    LaterEnds m_later;
    std::vector<HitEvent> m_hits;
    std::vector<JointEvent> m_joints;
    std::vector<MoveEvent> m_moved;
    std::vector<BodyIndex> m_asleep;  ///< listed and not simulated, in order
};

}  // namespace scree
