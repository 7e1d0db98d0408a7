// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pairs and times of bodies whose motion an event has changed.

#include "pipeline/parts/toi_pairs.h"
#include "state/frames.h"

namespace scree {

void ToiPairs::Advance(BodyIndex body, float alpha) {
    if (m_bodies.type[body] == staticBody) {
        m_s.alpha[body] = alpha;
        return;
    }
    const Vec2 frame = FrameOf(m_bodies, body, body);
    Sweep sweep = SweepOf(body, frame);
    sweep.Advance(alpha);
    m_bodies.position[body] = {sweep.c0, sweep.a0, 0.0f};
    if (m_bodies.IsFar()) {
        m_bodies.position[body].c = frame;
        m_bodies.rest[body].end = sweep.c0;
    }
    m_s.alpha[body] = alpha;
    m_bodies.UpdateTransform(body);
    m_bodies.NoteStart(body);
}

void ToiPairs::UpdateTimes(BodyIndex body) {
    for (int p = m_s.firstPair[body]; p >= 0; p = Next(p, body)) UpdateEvent(p);
}

void ToiPairs::Complete(BodyIndex body) {
    if (m_s.isPassedOver[body] != 0) Collect(body, false);
}

void ToiPairs::Refresh(BodyIndex body) {
    UpdateTimes(body);
    if (!Moves(body)) return;
    SweepHitters();
    if (m_dynamicTargets) SweepBoxesOf(body);
    Collect(body, m_dynamicTargets);
}

void ToiPairs::PrepareLooks() {
    m_s.times.resize(m_s.pairs.size());
    m_t.broadPhase.PrepareStatic();
}

ToiLook ToiPairs::Look(BodyIndex body, int worker, ToiLooker& looker) {
    TOIStats work;
    for (int p = m_s.firstPair[body]; p >= 0; p = Next(p, body)) {
        m_s.times[p] = FirstTimeOf(m_s.pairs[p], Bounded::notYet, work);
    }
    if (work.calls > 0) CountSearches(*m_events.work, work);
    ToiLook look{Moves(body), worker, static_cast<int>(looker.candidates.size())};
    if (look.moves) {
        for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
            if (m_t.fixtures.isSensor[f] || !m_t.fixtures.info[f].inBroadPhase) continue;
            FindStatic(body, f, looker.found, looker.candidates);
        }
    }
    look.end = static_cast<int>(looker.candidates.size());
    return look;
}

void ToiPairs::Take(BodyIndex body, const ToiLook& look, std::span<const ToiLooker> lookers) {
    for (int p = m_s.firstPair[body]; p >= 0; p = Next(p, body)) PutEvent(p, m_s.times[p]);
    if (!look.moves) return;
    const std::vector<ToiCandidate>& found = lookers[ToSize(look.worker)].candidates;
    m_s.candidates.assign(found.begin() + look.begin, found.begin() + look.end);
    AddCandidates(body);
}

}  // namespace scree
