// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What World::GetEvents tells of a step, against what has changed in it.

#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "scree/scree.h"
#include "tests/fuzz/laws.h"

namespace fuzz {

class EventLaws {
public:
    /// What is known of the step before is no more so: the world has gone back.
    void Forget() { m_isKnown = false; }

    void BeginStep(const scree::World& world) {
        m_poses.clear();
        for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            m_poses.emplace(KeyOf(world.GetId(body)), body->GetTransform());
    }

    /// After a step that was not refused.
    void Check(const scree::World& world) {
        const Known last = std::exchange(m_last, Look(world));
        if (m_isKnown) CheckTouching(world.GetEvents(), last);
        m_isKnown = true;
        CheckMoves(world);
    }

private:
    using Key = std::pair<int, uint32_t>;  ///< index and generation
    using KeyPair = std::pair<Key, Key>;   ///< the lower one first

    /// After a step.
    struct Known {
        std::set<KeyPair> touching;
        std::map<Key, uint8_t> reports;  ///< of fixtures
    };

    template <typename Id>
    static Key KeyOf(Id id) {
        return {id.index, id.generation};
    }
    static KeyPair PairOf(Key a, Key b) { return std::minmax(a, b); }

    static Known Look(const scree::World& world) {
        Known known;
        for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            for (const scree::Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
                known.reports.emplace(KeyOf(world.GetId(f)), f->GetReports());
        }
        for (const scree::Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
            const auto key = [&](const scree::Fixture* fixture) { return KeyOf(world.GetId(fixture)); };
            if (contact->IsTouching())
                known.touching.insert(PairOf(key(contact->GetFixtureA()), key(contact->GetFixtureB())));
        }
        return known;
    }

    /// Who touched, with those who began and without those who stopped, are those who touch.
    void CheckTouching(const scree::Events& events, const Known& last) const {
        std::map<KeyPair, int> balance;
        for (const KeyPair& pair : last.touching) ++balance[pair];
        for (const KeyPair& pair : m_last.touching) --balance[pair];
        for (const scree::ContactEvent& e : events.contactsBegun)
            ++balance[PairOf(KeyOf(e.fixtureA), KeyOf(e.fixtureB))];
        for (const scree::ContactEvent& e : events.contactsEnded)
            --balance[PairOf(KeyOf(e.fixtureA), KeyOf(e.fixtureB))];
        for (const scree::SensorEvent& e : events.sensorsEntered) ++balance[PairOf(KeyOf(e.sensor), KeyOf(e.visitor))];
        for (const scree::SensorEvent& e : events.sensorsLeft) --balance[PairOf(KeyOf(e.sensor), KeyOf(e.visitor))];
        for (const auto& [pair, count] : balance) {
            if (Wants(pair, last)) Demand(count == 0, "events tell who touches");
        }
    }

    /// Whether the contacts of a pair are reported, before the step and after it.
    [[nodiscard]] bool Wants(const KeyPair& pair, const Known& last) const {
        uint8_t before = 0, after = 0;
        for (const Key& fixture : {pair.first, pair.second}) {
            const auto had = last.reports.find(fixture), has = m_last.reports.find(fixture);
            const bool isOld = had != last.reports.end(), isNew = has != m_last.reports.end();
            if (isOld || isNew) {
                before |= isOld ? had->second : has->second;
                after |= isNew ? has->second : had->second;
            }
        }
        return (before & after & scree::Report::contacts) != 0;
    }

    void CheckMoves(const scree::World& world) const {
        if (!world.GetReportMoves()) return;
        std::set<Key> moved;
        for (const scree::MoveEvent& event : world.GetEvents().moved)
            Demand(moved.insert(KeyOf(event.body)).second, "a body is told once");
        for (const scree::Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
            const Key key = KeyOf(world.GetId(body));
            const auto pose = m_poses.find(key);
            if (pose == m_poses.end()) continue;
            const scree::Transform &was = pose->second, &is = body->GetTransform();
            if (!IsNear(body->GetWorldCenter())) continue;  // where a new mass moves what it should not
            const bool isSame = was.p == is.p && was.q.s == is.q.s && was.q.c == is.q.c;
            Demand(isSame || moved.contains(key), "a body that moved is told");
        }
    }

    bool m_isKnown = false;
    Known m_last;
    std::map<Key, scree::Transform> m_poses;  ///< of bodies, before the step
};

}  // namespace fuzz
