// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Events into their arrays.

#include "state/event_log.h"

#include <algorithm>

namespace scree {

void EventLog::Renew() {
    m_hasEvents = !m_later.ended.empty() || !m_later.left.empty();
    m_begun.clear(), m_entered.clear(), m_hits.clear(), m_joints.clear(), m_moved.clear();
    m_ended.swap(m_later.ended), m_later.ended.clear();
    m_left.swap(m_later.left), m_later.left.clear();
}

void EventLog::Restart(const LaterEnds& later) {
    m_later.ended.clear(), m_later.left.clear();
    Renew();
    m_later = later;
    m_hasEvents = !later.ended.empty() || !later.left.empty();
}

void EventLog::NoteChange(const ContactPair& pair, bool isSensor, bool begins) {
    if (!Wants(pair, Report::contacts)) return;
    m_hasEvents = true;
    const FixtureId a = IdOf(pair.fixtureA), b = IdOf(pair.fixtureB);
    if (!isSensor) {
        (begins ? m_begun : m_inStep ? m_ended : m_later.ended).push_back({a, b});
        return;
    }
    const bool isA = m_fixtures.isSensor[pair.fixtureA] != 0;
    (begins ? m_entered : m_inStep ? m_left : m_later.left).push_back({isA ? a : b, isA ? b : a});
}

void EventLog::NoteHit(const ContactPair& pair, Vec2 point, Vec2 normal, float speed) {
    m_hasEvents = true;
    m_hits.push_back({IdOf(pair.fixtureA), IdOf(pair.fixtureB), point, normal, speed});
}

void EventLog::NoteAsleep(const BodyTable& bodies) {
    m_asleep.clear();
    if (!reportsMoves) return;
    for (const BodyIndex body : bodies.Listed()) {
        if (!bodies.IsActive(body)) m_asleep.push_back(body);
    }
    std::sort(m_asleep.begin(), m_asleep.end());
}

/// Who falls asleep, or is put to sleep by a callback, is still listed. So is who was woken for it, by an impact
/// perhaps.
void EventLog::NoteMoves(const BodyTable& bodies) {
    if (!reportsMoves) return;
    const auto note = [&](BodyIndex body, bool fellAsleep) {
        m_hasEvents = true;
        m_moved.push_back({{ToInt(body), bodies.slots.GetGeneration(body)}, fellAsleep});
    };
    for (const BodyIndex body : bodies.Listed()) {
        if (bodies.IsActive(body)) note(body, false);
    }
    for (const BodyIndex body : bodies.Listed()) {
        if (bodies.Has(body, BodyFlag::awake)) continue;
        if (!std::binary_search(m_asleep.begin(), m_asleep.end(), body)) note(body, true);
    }
}

Events EventLog::Get() const { return {m_begun, m_ended, m_entered, m_left, m_hits, m_joints, m_moved}; }

}  // namespace scree
