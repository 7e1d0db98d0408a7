// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Gather → move to the impact → contacts → rest of the step → new times.

#include "pipeline/parts/impact_round.h"

#include <algorithm>

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/contact_update.h"
#include "pipeline/parts/note_events.h"

namespace scree {

namespace {

/// Fewer contacts than this, and a single impact, are not worth waking workers for.
constexpr int leastRoundContacts = 64, leastImpacts = 2;

}  // namespace

void ImpactRound::Clear() {
    for (const BodyIndex body : m_s.bodies) m_s.marks[body] = none;
    for (const BodyIndex body : m_s.beside) m_s.marks[body] = none;
    m_s.impacts.clear();
    m_s.bodies.clear(), m_s.joints.clear(), m_s.contacts.clear(), m_s.beside.clear();
    m_bodiesIn = m_jointsIn = 0;
}

bool ImpactRound::IsJointed(const ToiPair& pair) const {
    if (m_settings.rest.solve == nullptr) return false;
    const auto isJointed = [&](BodyIndex b) { return m_toi.IsDynamic(b) && HasSolvedJoint(b); };
    return isJointed(pair.bodyA) || isJointed(pair.bodyB);
}

/// A joint to a disabled body is not solved, and that body has no proxies.
bool ImpactRound::IsSolved(const JointInfo& joint) const {
    return m_bodies.Has(joint.bodyA, BodyFlag::enabled) && m_bodies.Has(joint.bodyB, BodyFlag::enabled);
}
bool ImpactRound::HasSolvedJoint(BodyIndex body) const {
    for (const JointIndex joint : m_t.joints.OfBody(body)) {
        if (IsSolved(m_t.joints.info[joint])) return true;
    }
    return false;
}

template <typename Visit>
void ImpactRound::ForEachContact(BodyIndex body, Visit&& visit) {
    for (const ContactIndex contact : m_t.contacts.OfBody(body)) {
        if (!m_t.contacts.IsAlive(contact) || m_t.contacts.Has(contact, ContactFlag::sensor)) continue;
        const ContactPair& pair = m_t.contacts.pair[contact];
        visit(contact, pair.bodyA == body ? pair.bodyB : pair.bodyA);
    }
}

/// False if the body is one of the round, or beside it.
bool ImpactRound::Gather(BodyIndex body) {
    if (!m_toi.IsDynamic(body) || MarkOf(body) == gathered) return true;
    if (MarkOf(body) != none) return false;
    EnsureRows(m_s.marks, ToSize(m_bodies.slots.Size()), uint8_t{none});
    m_s.marks[body] = gathered;
    m_s.bodies.push_back(body);
    return true;
}

/// The bodies of a pair with all that joints hold to them, and their joints. False if contacts or joints join some of
/// them to bodies of the round.
bool ImpactRound::GatherAll(const ToiPair& pair) {
    if (!Gather(pair.bodyA) || !Gather(pair.bodyB)) return false;
    for (size_t next = m_bodiesIn; next < m_s.bodies.size(); ++next) {
        const BodyIndex body = m_s.bodies[next];
        for (const JointIndex joint : m_t.joints.OfBody(body)) {
            const JointInfo& info = m_t.joints.info[joint];
            if (!IsSolved(info)) continue;
            if (!Gather(info.bodyA) || !Gather(info.bodyB)) return false;
            // Lists what two bodies share once: at body A, or at the other where A is none of them.
            if (body == info.bodyA || MarkOf(info.bodyA) != gathered) m_s.joints.push_back(joint);
        }
    }
    if (IsEmpty()) return true;
    bool isApart = true;
    for (const BodyIndex body : Gathered()) {
        ForEachContact(body, [&](ContactIndex, BodyIndex other) {
            isApart = isApart && (MarkOf(other) == none || MarkOf(other) == gathered);
        });
    }
    return isApart;
}

void ImpactRound::DropGathered() {
    for (const BodyIndex body : Gathered()) m_s.marks[body] = none;
    m_s.bodies.resize(m_bodiesIn);
    m_s.joints.resize(m_jointsIn);
}

bool ImpactRound::IsApart(const ToiPair& pair) {
    DropGathered();
    // Others tell bodies that stand still how much of the step is done: they keep to the order of times.
    return IsJointed(pair) ? GatherAll(pair) : IsEmpty();
}

void ImpactRound::Add(float alpha) {
    m_s.impacts.push_back({alpha, m_bodiesIn, m_jointsIn, m_s.contacts.size()});
    for (const BodyIndex body : Gathered()) {
        m_bodies.Wake(body);
        m_t.contacts.RouseOf(body);
        ListContacts(body);
    }
    for (const BodyIndex body : Gathered()) m_s.marks[body] = member;
    m_bodiesIn = m_s.bodies.size(), m_jointsIn = m_s.joints.size();
}

void ImpactRound::ListContacts(BodyIndex body) {
    ForEachContact(body, [&](ContactIndex contact, BodyIndex other) {
        const BodyIndex bodyA = m_t.contacts.pair[contact].bodyA;
        if (body == bodyA || MarkOf(bodyA) != gathered) m_s.contacts.push_back(contact);
        if (!m_toi.IsDynamic(other) || MarkOf(other) != none) return;
        EnsureRows(m_s.marks, ToSize(m_bodies.slots.Size()), uint8_t{none});
        m_s.marks[other] = beside;
        m_s.beside.push_back(other);
    });
}

/// Moves a jointed body to the impact, with the velocity that it has there.
void ImpactRound::MoveToImpact(BodyIndex body, float alpha) {
    const float begin = m_toiScratch.alpha[body];
    if (m_toiScratch.firstPair[body] < 0) m_toiScratch.touched.push_back(body);
    m_toi.Advance(body, alpha);
    Velocity& v = m_bodies.velocity[body];
    // Null for what stands still, or was asleep when the step began.
    const bool moves = v.v.x != 0.0f || v.v.y != 0.0f || v.w != 0.0f;
    const Velocity* const start = moves ? m_settings.startVelocities->Find(body) : nullptr;
    const bool isJointed = HasSolvedJoint(body);
    if (begin < 1.0f && isJointed && start != nullptr) {
        const Velocity from = *start;
        const float share = (alpha - begin) / (1.0f - begin);
        v.v = from.v + share * (v.v - from.v);
        v.w = from.w + share * (v.w - from.w);
    }
    if (m_bodies.info[body].jointCount > 0) m_settings.startVelocities->Note(body, v);
}

/// Manifolds where bodies stand now. Where nobody is told all workers compute them.
void ImpactRound::UpdateContacts() {
    m_s.touching.resize(m_s.contacts.size());
    if (m_events.listener != nullptr) {
        for (size_t i = 0; i < m_s.contacts.size(); ++i) {
            const ContactIndex contact = m_s.contacts[i];
            // The listener may have made it a sensor's.
            const bool touches = !m_t.contacts.Has(contact, ContactFlag::sensor) &&
                                 UpdateContact(contact, m_t.fixtures, m_events, m_bodies, m_t.contacts);
            m_s.touching[i] = touches ? uint8_t{1} : uint8_t{0};
        }
        return;
    }
    constexpr uint8_t touches = 1, isRegrouped = 2;
    m_t.pool.For(static_cast<int>(m_s.contacts.size()), leastRoundContacts, [&](int begin, int end, int /*worker*/) {
        for (size_t i = ToSize(begin); i < ToSize(end); ++i) {
            const ContactIndex contact = m_s.contacts[i];
            const int before = m_t.contacts.manifold[contact].pointCount;
            const bool touchesNow = ComputeManifold(contact, m_t.fixtures, m_bodies, *m_events.work, m_t.contacts);
            const bool hasChanged = m_t.contacts.manifold[contact].pointCount != before;
            m_s.touching[i] = static_cast<uint8_t>((touchesNow ? touches : 0) | (hasChanged ? isRegrouped : 0));
        }
    });
    for (size_t i = 0; i < m_s.contacts.size(); ++i) {
        const ContactIndex contact = m_s.contacts[i];
        const uint8_t finding = m_s.touching[i];
        m_s.touching[i] = finding & touches;
        if ((finding & isRegrouped) != 0) ++m_t.contacts.grouping;
        const bool hasChanged =
            NoteTouching(contact, m_s.touching[i] != 0, m_events.restartsTimers, m_bodies, m_t.contacts);
        if (hasChanged && m_events.log != nullptr) NoteChange(contact, m_t.contacts, *m_events.log);
    }
}

/// Leaves the contacts that push, whose bodies wake.
void ImpactRound::KeepActing() {
    size_t kept = 0, next = 0;
    for (size_t i = 0; i < m_s.contacts.size(); ++i) {
        for (; next < m_s.impacts.size() && m_s.impacts[next].contacts == i; ++next) m_s.impacts[next].contacts = kept;
        const ContactIndex contact = m_s.contacts[i];
        if (m_s.touching[i] == 0 || !m_t.contacts.Has(contact, ContactFlag::enabled)) continue;
        m_s.contacts[kept++] = contact;
        m_bodies.Wake(m_t.contacts.pair[contact].bodyA);
        m_bodies.Wake(m_t.contacts.pair[contact].bodyB);
    }
    for (; next < m_s.impacts.size(); ++next) m_s.impacts[next].contacts = kept;
    m_s.contacts.resize(kept);
    if (m_events.log == nullptr) return;
    for (const ContactIndex contact : m_s.contacts)
        NoteHit(contact, m_t.fixtures, m_bodies, m_t.contacts, *m_events.log);
}

void ImpactRound::SolveOne(size_t impact, int worker) {
    JointedImpact& own = m_s.impacts[impact];
    const std::span<const BodyIndex> bodies = PartOf(m_s.bodies, impact, &JointedImpact::bodies);
    const std::span<const ContactIndex> contacts = PartOf(m_s.contacts, impact, &JointedImpact::contacts);
    own.counts = m_settings.rest.solve({bodies, contacts, PartOf(m_s.joints, impact, &JointedImpact::joints),
                                        (1.0f - own.alpha) * m_settings.dt, worker});
    own.counts.nonFinite += ReturnLost(contacts);
    if (m_toi.MeetsMovers()) return;
    for (size_t i = 0; i < bodies.size(); ++i) {
        m_s.looks[own.bodies + i] = m_toi.Look(bodies[i], worker, m_s.lookers[ToSize(worker)]);
    }
}

/// Bodies that touch the jointed ones are pushed by them. Returns how many were lost.
int ImpactRound::ReturnLost(std::span<const ContactIndex> contacts) {
    int lost = 0;
    for (const ContactIndex contact : contacts) {
        const ContactPair& pair = m_t.contacts.pair[contact];
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (MarkOf(body) == member || !m_toi.IsDynamic(body) || !ReturnIfLost(m_bodies, body)) continue;
            m_bodies.UpdateTransform(body);
            ++lost;
        }
    }
    return lost;
}

/// A listener hears of impulses on the thread of the step.
void ImpactRound::SolveAll() {
    const int count = static_cast<int>(m_s.impacts.size());
    const auto solve = [this](int begin, int end, int worker) {
        for (int i = begin; i < end; ++i) SolveOne(ToSize(i), worker);
    };
    if (m_events.listener != nullptr || !m_t.pool.IsOpen() || count < leastImpacts) {
        m_settings.rest.prepare(1);
        return solve(0, count, 0);
    }
    m_settings.rest.prepare(m_t.pool.GetRowCount());
    m_t.pool.For(count, leastImpacts, solve);
}

SolverCounts ImpactRound::Solve() {
    DropGathered();
    m_s.largestRound = std::max(m_s.largestRound, m_s.impacts.size());
    m_settings.startVelocities->Reserve(m_bodies.velocity.size());
    for (size_t i = 0; i < m_s.impacts.size(); ++i) {
        for (const BodyIndex body : PartOf(m_s.bodies, i, &JointedImpact::bodies)) {
            MoveToImpact(body, m_s.impacts[i].alpha);
        }
    }
    UpdateContacts();
    KeepActing();
    if (!m_toi.MeetsMovers()) {
        m_toi.PrepareLooks();
        m_s.looks.resize(m_s.bodies.size());
        EnsureRows(m_s.lookers, ToSize(m_t.pool.GetRowCount()));
        for (ToiLooker& looker : m_s.lookers) looker.candidates.clear();
    }
    SolveAll();
    MatchRooms(m_s.lookers);
    SolverCounts counts;
    for (const JointedImpact& impact : m_s.impacts) counts += impact.counts;
    for (size_t i = 0; i < m_s.bodies.size(); ++i) {
        if (m_toi.MeetsMovers()) {
            m_toi.Refresh(m_s.bodies[i]);
        } else {
            m_toi.Take(m_s.bodies[i], m_s.looks[i], m_s.lookers);
        }
    }
    Clear();
    return counts;
}

}  // namespace scree
