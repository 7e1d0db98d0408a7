// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Events in order of time, and the solve of one.

#include "pipeline/continuous.h"

#include <algorithm>
#include <utility>

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/contact_update.h"
#include "pipeline/parts/locked_bodies.h"
#include "pipeline/parts/make_contact.h"
#include "pipeline/parts/note_events.h"
#include "pipeline/parts/report_impulses.h"
#include "pipeline/parts/toi_pairs.h"
#include "state/frames.h"

namespace scree {

namespace {

/// Box2D's: enough for the two bodies alone to come apart.
constexpr int positionIterations = 20;
/// Overlap left by the position iterations, m at a length scale of 1: half a slop more than they aim at.
constexpr float positionTolerance = -1.5f * linearSlop;

/// Where a body was before an event was tried.
struct BodyBackup {
    BodyIndex body;
    Position start, end;
    PositionRest rest;
    Transform transform;
    float alpha;
};

class ContinuousSolver {
public:
    ContinuousSolver(const ContinuousSettings& settings, const ContactEvents& events, ContinuousTables tables,
                     ContinuousScratch& scratch)
        : m_settings(settings),
          m_events(events),
          m_t(tables),
          m_bodies(tables.bodies),
          m_s(scratch),
          m_toi(settings.lengthScale, settings.atOutlines, events, m_t, scratch),
          m_round({settings.dt, settings.rest, settings.startVelocities}, events, m_t, scratch.impacts, scratch,
                  m_toi) {}

    ContinuousReport Run() {
        m_toi.Clear();
        ForgetMembers();  // of an event that a callback ended by an exception
        m_round.Clear();
        if (!m_s.resuming) m_s.ballistic.clear();
        m_toi.FindAll();
        while (!m_s.events.Empty() || !m_round.IsEmpty()) {
            const bool isOver = m_s.events.Empty() || m_settings.subStepping;
            if (m_round.IsFull() || (isOver && !m_round.IsEmpty()) || !m_round.IsApart(m_s.pairs[m_s.events.Top()])) {
                SolveRound();
                if (!m_settings.subStepping) continue;
                m_report.complete = m_s.events.Empty();
                break;
            }
            const int pair = m_s.events.Top();
            const float alpha = m_s.events.TopKey();
            m_s.events.Remove(pair);
            if (m_s.pairs[pair].rounds >= maxSubSteps) {
                Abandon(pair, alpha);
            } else if (HandleEvent(pair, alpha) && m_settings.subStepping && m_round.IsEmpty()) {
                m_report.complete = m_s.events.Empty();
                break;
            }
        }
        if (!m_report.complete) EnsureBallistic();
        m_s.resuming = !m_report.complete;
        return m_report;
    }

private:
    /// Moves the body to the given part of the step, where its motion starts (and for now ends).
    BodyBackup Advance(BodyIndex body, float alpha) {
        const BodyBackup backup{body,
                                m_bodies.startPosition[body],
                                m_bodies.position[body],
                                m_bodies.IsFar() ? m_bodies.rest[body] : PositionRest{},
                                m_bodies.transform[body],
                                m_s.alpha[body]};
        m_toi.Advance(body, alpha);
        return backup;
    }

    void Restore(const BodyBackup& backup) {
        m_bodies.startPosition[backup.body] = backup.start;
        m_bodies.position[backup.body] = backup.end;
        if (m_bodies.IsFar()) m_bodies.rest[backup.body] = backup.rest;
        m_bodies.transform[backup.body] = backup.transform;
        m_s.alpha[backup.body] = backup.alpha;
    }

    /// The contact of a pair whose bodies stand at the event, updated; −1 if they do not touch or must not.
    ContactIndex TouchingContact(const ToiPair& pair) {
        ContactIndex contact = m_t.contacts.Find(pair.fixtureA, pair.fixtureB);
        if (IsNone(contact)) {
            contact = MakeContact(std::min(pair.fixtureA, pair.fixtureB), std::max(pair.fixtureA, pair.fixtureB),
                                  m_events, m_t.fixtures, m_t.contacts);
        }
        if (IsNone(contact)) return ContactIndex::none;
        const bool touching = UpdateContact(contact, m_t.fixtures, m_events, m_bodies, m_t.contacts);
        return touching && m_t.contacts.Has(contact, ContactFlag::enabled) ? contact : ContactIndex::none;
    }

    /// Stops the pair at the event and solves it. False if nothing happens after all.
    bool HandleEvent(int index, float alpha) {
        ++m_s.pairs[index].rounds;
        const ToiPair pair = m_s.pairs[index];
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (m_toi.IsDynamic(body)) m_toi.Complete(body);
        }
        const BodyBackup backupA = Advance(pair.bodyA, alpha);
        const BodyBackup backupB = Advance(pair.bodyB, alpha);
        const ContactIndex contact = TouchingContact(pair);
        if (IsSome(contact) && !pair.isHeld && !WillOverlap(contact, alpha)) {
            m_s.pairs[index].isHeld = true;
            Restore(backupA);
            Restore(backupB);
            m_toi.UpdateEvent(index);  // of the others nothing changed: a body on a rough ground has thousands
            return false;
        }
        if (IsNone(contact)) {
            m_s.pairs[index].over = true;
            Restore(backupA);
            Restore(backupB);
            return false;
        }
        ++m_report.events;
        m_bodies.Wake(pair.bodyA);
        m_bodies.Wake(pair.bodyB);
        m_s.islandContacts.assign(1, contact);
        if (m_round.IsJointed(pair)) {
            Restore(backupA);
            Restore(backupB);
            m_round.Add(alpha);
            return true;
        }
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) AddMember(body);
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (m_toi.IsDynamic(body)) JoinTouching(pair, body, index, alpha);
        }
        NoteHits();
        SolveEvent(pair, alpha);
        for (size_t i = 0; i < m_s.islandBodies.size(); ++i) {
            // A kinematic body goes on as it did, so what is known of its pairs stays true: a drum has thousands.
            if (m_toi.IsDynamic(m_s.islandBodies[i])) m_toi.Refresh(m_s.islandBodies[i]);
        }
        ForgetMembers();
        return true;
    }

    /// In the soft step contacts hold what comes a little too near: only what would get deep is an event, and sliding
    /// along is none.
    [[nodiscard]] bool WillOverlap(ContactIndex contact, float alpha) {
        if (!m_settings.atOutlines) return true;
        m_s.islandContacts.assign(1, contact);
        PrepareContacts(ContactInput(), m_s.rows);
        const float slop = linearSlop * m_settings.lengthScale, rest = (1.0f - alpha) * m_settings.dt;
        const ContactVelocityRow& row = m_s.rows.velocity.front();
        const Velocity& a = m_bodies.velocity[row.bodyA];
        const Velocity& b = m_bodies.velocity[row.bodyB];
        for (int i = 0; i < row.pointCount; ++i) {
            const Vec2 apart = b.v + Cross(b.w, row.points[i].rB) - a.v - Cross(a.w, row.points[i].rA);
            if (Dot(row.normal, apart) * rest < -2.0f * slop) return true;
        }
        return false;
    }

    /// With skins in the soft step too: an event stops what would pass through thin shapes before it reaches them.
    [[nodiscard]] ContactPrepareInput ContactInput() const {
        constexpr bool atOutlines = false;
        return {m_bodies, m_t.fixtures, m_t.contacts, m_s.islandContacts,
                0.0f,     true,         atOutlines,   m_settings.lengthScale};
    }

    void SolveRound() {
        const SolverCounts counts = m_round.Solve();
        m_report.capped += counts.capped, m_report.nonFinite += counts.nonFinite;
    }

    /// Adds what else touches the body at the time of the event: a corner stops it from two sides.
    void JoinTouching(const ToiPair& met, BodyIndex body, int event, float alpha) {
        FindPairsInOrder(body);
        for (const int p : m_s.pairsInOrder) {
            const ToiPair pair = m_s.pairs[p];
            if (p == event || pair.over) continue;
            const BodyIndex other = pair.bodyA == body ? pair.bodyB : pair.bodyA;
            // Pairs of the two bodies that met are in both their lists.
            if (body == met.bodyB && other == met.bodyA && m_toi.IsDynamic(other)) continue;
            const bool isMember = PlaceOf(other) >= 0;
            const BodyBackup backup = isMember ? BodyBackup{} : Advance(other, alpha);
            const ContactIndex contact = BoxesOverlap(pair) ? TouchingContact(pair) : ContactIndex::none;
            if (IsNone(contact)) {
                if (!isMember) Restore(backup);
                continue;
            }
            m_s.islandContacts.push_back(contact);
            if (isMember) continue;
            AddMember(other);
            m_bodies.Wake(other);
        }
    }

    /// The pairs of a body in an order that does not tell when they were made.
    void FindPairsInOrder(BodyIndex body) {
        m_s.pairsInOrder.clear();
        for (int p = m_s.firstPair[body]; p >= 0; p = m_toi.Next(p, body)) m_s.pairsInOrder.push_back(p);
        const auto key = [&](int p) {
            const ToiPair& pair = m_s.pairs[p];
            const bool isA = pair.bodyA == body;
            return std::pair(isA ? pair.fixtureA : pair.fixtureB, -ToInt(isA ? pair.fixtureB : pair.fixtureA));
        };
        std::ranges::sort(m_s.pairsInOrder, {}, key);
    }

    /// The blows of an event that is going to be solved.
    void NoteHits() {
        if (m_events.log == nullptr) return;
        for (const ContactIndex contact : m_s.islandContacts)
            NoteHit(contact, m_t.fixtures, m_bodies, m_t.contacts, *m_events.log);
    }

    void AddMember(BodyIndex body) {
        EnsureRows(m_s.islandPlace, ToSize(m_bodies.slots.Size()), -1);
        m_s.islandPlace[body] = static_cast<int>(m_s.islandBodies.size());
        m_s.islandBodies.push_back(body);
    }
    void ForgetMembers() {
        for (const BodyIndex body : m_s.islandBodies) m_s.islandPlace[body] = -1;
        m_s.islandBodies.clear();
    }
    /// Place of the body among those of the event, −1 if it is not one of them.
    [[nodiscard]] int PlaceOf(BodyIndex body) const { return m_s.islandPlace.Has(body) ? m_s.islandPlace[body] : -1; }

    [[nodiscard]] bool BoxesOverlap(const ToiPair& pair) const {
        AABB a, b;
        const Vec2 frame = FrameOf(m_bodies, pair.bodyA, pair.bodyB);
        m_t.fixtures.shape[pair.fixtureA]->ComputeAABB(&a, TransformIn(frame, m_bodies, pair.bodyA));
        m_t.fixtures.shape[pair.fixtureB]->ComputeAABB(&b, TransformIn(frame, m_bodies, pair.bodyB));
        return TestOverlap(a, b);
    }

    void SolveEvent(const ToiPair& pair, float alpha) {
        const ContactPrepareInput input = ContactInput();
        const float tolerance = positionTolerance * m_settings.lengthScale;
        const PushApart push{toiBaumgarte, m_settings.lengthScale};
        PrepareContacts(input, m_s.rows);
        for (ContactPositionRow& row : m_s.rows.position) {
            // Only the two bodies of the event move: the others stand where an earlier event or nothing put them.
            if (row.bodyA != pair.bodyA && row.bodyA != pair.bodyB) row.massA.invMass = row.massA.invI = 0.0f;
            if (row.bodyB != pair.bodyA && row.bodyB != pair.bodyB) row.massB.invMass = row.massB.invI = 0.0f;
        }
        const Position metA = m_bodies.position[pair.bodyA], metB = m_bodies.position[pair.bodyB];
        const Vec2 restA = m_bodies.GetRest(pair.bodyA), restB = m_bodies.GetRest(pair.bodyB);
        for (int i = 0; i < positionIterations; ++i) {
            if (SolveContactPositions(m_s.rows, m_bodies, push) >= tolerance) break;
        }
        KeepLocked(pair.bodyA, metA.c, restA), KeepLocked(pair.bodyB, metB.c, restB);
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (m_bodies.type[body] == staticBody) continue;
            Quarantine(body);
            m_bodies.UpdateTransform(body);
            m_bodies.NoteStart(body);
        }
        const float rest = (1.0f - alpha) * m_settings.dt;
        FindAhead(rest);
        for (size_t i = 0; i < m_s.islandBodies.size(); ++i) AddSpeed(i, -1.0f);
        PrepareContacts(input, m_s.rows);
        for (int i = 0; i < m_settings.velocityIterations; ++i) SolveContactVelocities(m_s.rows, m_bodies.velocity);
        ReportImpulses(m_s.rows, m_events, m_t.contacts);
        const bool leaves = StaysApart();
        for (size_t i = 0; i < m_s.islandBodies.size(); ++i) {
            const BodyIndex body = m_s.islandBodies[i];
            if (m_bodies.type[body] == staticBody) continue;
            StopLocked(m_bodies, body, m_bodies.velocity[body]);
            // A body that its contact goes on to hold up is not accelerated.
            if (leaves) AddSpeed(i, 0.5f);
            if (!IsAbandoned(body)) Integrate(body, rest);
            if (leaves) AddSpeed(i, 0.5f);
            Quarantine(body);
            m_bodies.UpdateTransform(body);
        }
    }

    /// A locked body is where it was before it was pushed.
    void KeepLocked(BodyIndex body, Vec2 centre, Vec2 rest) {
        Vec2& c = m_bodies.position[body].c;
        if (IsLockedBy(m_bodies, body, BodyFlag::lockX)) {
            c.x = centre.x;
            if (m_bodies.IsFar()) m_bodies.rest[body].end.x = rest.x;
        }
        if (IsLockedBy(m_bodies, body, BodyFlag::lockY)) {
            c.y = centre.y;
            if (m_bodies.IsFar()) m_bodies.rest[body].end.y = rest.y;
        }
    }

    /// A step that goes on keeps what it knew when it began; bodies may have come since.
    void EnsureBallistic() {
        const bool isKnown = m_s.resuming || !m_s.ballistic.empty();
        EnsureRows(m_s.ballistic, ToSize(m_bodies.slots.Size()), uint8_t{0});
        if (isKnown) return;
        for (const BodyIndex body : m_settings.ballistic) m_s.ballistic[body] = 1;
    }

    /// What forces will add to the velocities of the event's bodies in the rest of the step, and have added already.
    void FindAhead(float rest) {
        EnsureBallistic();
        m_s.ahead.clear();
        for (const BodyIndex body : m_s.islandBodies) {
            Velocity& ahead = m_s.ahead.emplace_back();
            if (m_s.ballistic[body] == 0 || !m_toi.IsDynamic(body)) continue;
            const MassRow& mass = m_bodies.mass[body];
            const ForceRow force = m_bodies.GetForce(body);
            const MotionRow& motion = m_bodies.motion[body];
            const Vec2 pull = (motion.gravityScale * motion.mass) * m_settings.gravity + force.force;
            ahead.v = (rest * mass.invMass) * pull;
            ahead.w = rest * mass.invI * force.torque;
        }
    }
    void AddSpeed(size_t islandBody, float factor) {
        Velocity& v = m_bodies.velocity[m_s.islandBodies[islandBody]];
        const Velocity& ahead = m_s.ahead[islandBody];
        v.v += factor * ahead.v;
        v.w += factor * ahead.w;
    }

    /// After the event: no contact of it will be pressed together again by forces within the step.
    [[nodiscard]] bool StaysApart() const {
        const auto aheadOf = [this](BodyIndex body) {
            const int place = PlaceOf(body);
            return place < 0 ? Velocity{} : m_s.ahead[ToSize(place)];
        };
        for (const ContactVelocityRow& row : m_s.rows.velocity) {
            const Velocity a = aheadOf(row.bodyA), b = aheadOf(row.bodyB);
            const Velocity& vA = m_bodies.velocity[row.bodyA];
            const Velocity& vB = m_bodies.velocity[row.bodyB];
            for (int i = 0; i < row.pointCount; ++i) {
                const Vec2 speedA = vA.v + a.v + Cross(vA.w + a.w, row.points[i].rA);
                const Vec2 speedB = vB.v + b.v + Cross(vB.w + b.w, row.points[i].rB);
                if (Dot(row.normal, speedB - speedA) < 0.0f) return false;
            }
        }
        return true;
    }

    void Integrate(BodyIndex body, float h) {
        Velocity& v = m_bodies.velocity[body];
        const float way = h * v.v.Length();
        const float turn = h * Abs(v.w);
        if (way > m_settings.maxTranslation || turn > m_settings.maxRotation) ++m_report.capped;
        if (way > m_settings.maxTranslation) v.v *= m_settings.maxTranslation / way;
        if (turn > m_settings.maxRotation) v.w *= m_settings.maxRotation / turn;
        m_bodies.Shift(body, h * v.v);
        m_bodies.position[body].a += h * v.w;
    }

    /// A body that is not finite any more goes back to where the event found it, at rest. Then returns true.
    bool Quarantine(BodyIndex body) {
        if (!ReturnIfLost(m_bodies, body)) return false;
        ++m_report.nonFinite;
        return true;
    }

    /// Such a body stays where it is until the next step, whatever meets it.
    [[nodiscard]] bool IsAbandoned(BodyIndex body) const { return std::ranges::binary_search(m_abandoned, body); }

    /// Holds the dynamic bodies of the pair where they meet, for the rest of the step. They keep the velocities that
    /// contacts and joints left them, or the next step would begin, and end, like this one.
    void Abandon(int index, float alpha) {
        const ToiPair pair = m_s.pairs[index];
        m_s.pairs[index].over = true;
        const bool isJointed = m_round.IsJointed(pair);
        if (isJointed) {
            for (const BodyIndex body : m_round.Gathered()) AddMember(body);
        } else {
            for (const BodyIndex body : {pair.bodyA, pair.bodyB}) AddMember(body);
        }
        for (const BodyIndex body : m_s.islandBodies) {
            if (!m_toi.IsDynamic(body)) continue;
            if (m_s.firstPair[body] < 0) m_s.touched.push_back(body);
            // Where the last event had the same time the body stands behind it, at the end of the step. A figure that
            // begins in the ground would come out of it never.
            const bool isBehind = m_s.alpha[body] == alpha && !isJointed;
            if (m_s.alpha[body] < alpha || isBehind) Advance(body, alpha);
            const auto place = std::ranges::lower_bound(m_abandoned, body);
            if (place == m_abandoned.end() || *place != body) m_abandoned.insert(place, body);
            ++m_report.abandoned;
            m_report.lostTime += (1.0f - alpha) * m_settings.dt;
            m_toi.UpdateTimes(body);
        }
        ForgetMembers();
    }

    const ContinuousSettings& m_settings;
    const ContactEvents& m_events;
    ContinuousTables m_t;
    BodyTable& m_bodies;
    ContinuousScratch& m_s;
    ContinuousReport m_report;
    std::vector<BodyIndex> m_abandoned;  ///< in order
    ToiPairs m_toi;
    ImpactRound m_round;
};

}  // namespace

ContinuousSettings MakeContinuousSettings(const SolverSettings& solver, int substeps,
                                          std::span<const BodyIndex> isolated, bool subStepping) {
    const bool isSoft = solver.substeps > 0;
    const bool isExact = isSoft || solver.exactDrift;
    return {.dt = solver.dt,
            .velocityIterations = isSoft ? 2 * substeps : solver.velocityIterations,
            .maxTranslation = solver.maxTranslation,
            .maxRotation = solver.maxRotation,
            .subStepping = subStepping,
            .lengthScale = solver.lengthScale,
            .gravity = solver.gravity,
            .ballistic = isExact ? isolated : std::span<const BodyIndex>(),
            .atOutlines = isSoft,
            .rest = {}};
}

ContinuousReport SolveContinuous(const ContinuousSettings& settings, const ContactEvents& events,
                                 ContinuousTables tables, ContinuousScratch& scratch) {
    return ContinuousSolver(settings, events, tables, scratch).Run();
}

}  // namespace scree
