// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Candidates, events in order of time, and the solve of one event.

#include "pipeline/continuous.h"

#include <algorithm>
#include <limits>

#include "geometry/reach.h"
#include "pipeline/parts/contact_update.h"
#include "pipeline/parts/make_contact.h"
#include "pipeline/parts/report_impulses.h"
#include "scree/time_of_impact.h"
#include "state/frames.h"
#include "state/limits.h"

namespace scree {

namespace {

/// Box2D's: enough for the two bodies alone to come apart.
constexpr int positionIterations = 20;
/// Overlap left by the position iterations, m at a length scale of 1: half a slop more than they aim at.
constexpr float positionTolerance = -1.5f * linearSlop;

size_t Row(int index) { return static_cast<size_t>(index); }

/// Where a body was before an event was tried.
struct BodyBackup {
    int body;
    Position start, end;
    PositionRest rest;
    Transform transform;
    float alpha;
};

class ContinuousSolver {
public:
    ContinuousSolver(const ContinuousSettings& settings, const ContactEvents& events, ContinuousTables tables,
                     ContinuousScratch& scratch)
        : m_settings(settings), m_events(events), m_t(tables), m_bodies(tables.bodies), m_s(scratch) {}

    ContinuousReport Run() {
        Begin();
        FindCandidates();
        while (!m_s.events.Empty()) {
            const int pair = m_s.events.Top();
            const float alpha = m_s.events.TopKey();
            m_s.events.Remove(pair);
            if (m_s.pairs[Row(pair)].rounds >= maxSubSteps) {
                Abandon(pair, alpha);
            } else if (HandleEvent(pair, alpha) && m_settings.subStepping) {
                m_report.complete = m_s.events.Empty();
                break;
            }
        }
        End();
        return m_report;
    }

private:
    void Begin() {
        const size_t count = Row(m_bodies.slots.Size());
        m_s.pairs.clear();
        m_s.events.Clear();
        m_s.firstPair.resize(count, -1);
        m_s.alpha.resize(count, 0.0f);
        m_s.knownTo.resize(Row(m_t.fixtures.slots.Size()), 0);
        for (const int body : m_s.touched) {
            m_s.firstPair[Row(body)] = -1;
            if (!m_s.resuming) m_s.alpha[Row(body)] = 0.0f;
        }
        m_s.touched.clear();
        m_s.ballistic.clear();
    }

    void End() { m_s.resuming = !m_report.complete; }

    [[nodiscard]] bool IsBullet(int body) const { return m_bodies.Has(body, BodyFlag::bullet); }
    [[nodiscard]] bool IsDynamic(int body) const { return m_bodies.type[Row(body)] == dynamicBody; }

    /// Non-bullet dynamic bodies pass through each other.
    [[nodiscard]] bool MayMeet(int bodyA, int bodyB) const {
        if (!IsDynamic(bodyA) && !IsDynamic(bodyB)) return false;
        return !IsDynamic(bodyA) || !IsDynamic(bodyB) || IsBullet(bodyA) || IsBullet(bodyB);
    }

    /// However slow, since a body that is pressed down may creep through by less than a slop a step.
    [[nodiscard]] bool Moves(int body) const {
        const Position& from = m_bodies.startPosition[Row(body)];
        const Position& to = m_bodies.position[Row(body)];
        if (!(from.c == to.c) || from.a != to.a) return true;
        return m_bodies.IsFar() && !(m_bodies.rest[Row(body)].start == m_bodies.rest[Row(body)].end);
    }

    void FindCandidates() {
        for (const int body : m_bodies.movers) {
            if (!m_bodies.Has(body, BodyFlag::enabled)) continue;
            m_dynamicTargets = m_dynamicTargets || !IsDynamic(body) || (IsBullet(body) && m_bodies.IsActive(body));
        }
        if (m_dynamicTargets) SweepBoxes();
        const NearStatics::Tables nearby{m_bodies, m_t.fixtures, m_t.broadPhase, m_settings.lengthScale};
        for (const int body : m_bodies.movers) {
            if (!m_bodies.Has(body, BodyFlag::enabled)) continue;
            if (!IsDynamic(body)) {
                CollectPairs(body, true);  // even at rest: what hits it looks only for static fixtures
            } else if (m_bodies.IsActive(body) && Moves(body)) {
                CollectFirst(body, nearby);
            }
        }
    }

    /// Gives the dynamic bodies boxes that cover their motion, when someone can hit them.
    void SweepBoxes() {
        for (const int body : m_bodies.movers) {
            if (m_bodies.IsActive(body)) SweepBoxesOf(body);
        }
    }

    void SweepBoxesOf(int body) {
        for (const int f : m_t.fixtures.From(m_bodies.fixtureHead[Row(body)])) {
            m_t.broadPhase.Update(static_cast<uint32_t>(f), SweptBox(body, f), vec2Zero);
        }
    }

    /// Covers the fixture on its whole way: the boxes at both ends, widened by how far a turning point leaves the
    /// straight line between its ends.
    [[nodiscard]] AABB SweptBox(int body, int fixture) const {
        const Vec2 frame = FrameOf(m_bodies, body, body);
        const Sweep sweep = SweepOf(body, frame);
        const Shape& shape = *m_t.fixtures.shape[Row(fixture)];
        Transform xf = TransformIn(frame, m_bodies, body);  // at the end
        AABB box, start;
        shape.ComputeAABB(&box, xf);
        if (sweep.a0 != sweep.a) xf.q.Set(sweep.a0);
        xf.p = sweep.c0 - Mul(xf.q, sweep.localCenter);
        shape.ComputeAABB(&start, xf);
        box.Combine(start);
        const float turn = Abs(sweep.a - sweep.a0);
        if (turn > 0.0f) {
            const float reach = Reach(shape, sweep.localCenter);
            const float bulge = turn < pi ? reach * (1.0f - SinCos(0.5f * turn).cos) : 2.0f * reach;
            box.lowerBound -= Vec2{bulge, bulge};
            box.upperBound += Vec2{bulge, bulge};
        }
        return m_bodies.IsFar() ? ToWorld(frame, box) : box;
    }

    [[nodiscard]] Sweep SweepOf(int body, Vec2 frame) const {
        Sweep sweep;
        sweep.localCenter = m_bodies.mass[Row(body)].localCenter;
        sweep.c0 = StartIn(frame, m_bodies, body);
        sweep.a0 = m_bodies.startPosition[Row(body)].a;
        sweep.c = CentreIn(frame, m_bodies, body);
        sweep.a = m_bodies.position[Row(body)].a;
        sweep.alpha0 = m_s.alpha[Row(body)];
        return sweep;
    }

    /// CollectPairs for a dynamic body that has no pairs yet but those of kinematic bodies and bullets with it.
    void CollectFirst(int body, const NearStatics::Tables& tables) {
        const bool isBullet = IsBullet(body);
        const auto known = isBullet ? std::nullopt : m_s.nearStatics.Find(body, tables);
        if (!known) return CollectPairs(body, isBullet);
        if (known->empty()) return;
        m_s.found.assign(known->begin(), known->end());  // a filter that is asked may make what is known forgotten
        for (const int f : m_t.fixtures.From(m_bodies.fixtureHead[Row(body)])) {
            if (m_t.fixtures.isSensor[Row(f)] || !m_t.fixtures.info[Row(f)].inBroadPhase) continue;
            MarkKnown(body, f);
            const AABB box = SweptBox(body, f);
            for (const int other : m_s.found) {
                if (TestOverlap(box, m_t.broadPhase.GetBox(static_cast<uint32_t>(other)))) AddPair(f, other);
            }
        }
    }

    /// Makes the pairs of a body with everything on its way and puts their events into the heap.
    void CollectPairs(int body, bool withDynamic) {
        for (const int f : m_t.fixtures.From(m_bodies.fixtureHead[Row(body)])) {
            if (m_t.fixtures.isSensor[Row(f)] || !m_t.fixtures.info[Row(f)].inBroadPhase) continue;
            m_s.found.clear();
            const auto visit = [&](uint32_t other) {
                m_s.found.push_back(static_cast<int>(other));
                return true;
            };
            const AABB box = SweptBox(body, f);
            withDynamic ? m_t.broadPhase.Query(box, visit) : m_t.broadPhase.QueryStatic(box, visit);
            std::sort(m_s.found.begin(), m_s.found.end());  // the order of a query depends on the algorithm
            if (!m_s.found.empty()) MarkKnown(body, f);
            for (const int other : m_s.found) AddPair(f, other);
        }
    }

    /// Marks the fixtures that have a pair with `fixture` already: one pass, however many are to be asked about.
    void MarkKnown(int body, int fixture) {
        if (m_s.round == std::numeric_limits<int>::max()) {
            m_s.round = 0;
            std::ranges::fill(m_s.knownTo, 0);
        }
        ++m_s.round;
        for (int p = m_s.firstPair[Row(body)]; p >= 0; p = Next(p, body)) {
            const ToiPair& pair = m_s.pairs[Row(p)];
            if (pair.fixtureA == fixture) m_s.knownTo[Row(pair.fixtureB)] = m_s.round;
            if (pair.fixtureB == fixture) m_s.knownTo[Row(pair.fixtureA)] = m_s.round;
        }
    }

    void AddPair(int fixture, int other) {
        const int body = m_t.fixtures.body[Row(fixture)];
        const int otherBody = m_t.fixtures.body[Row(other)];
        if (otherBody == body || m_t.fixtures.isSensor[Row(other)] || !MayMeet(body, otherBody)) return;
        if (m_bodies.type[Row(otherBody)] == staticBody && IsClear(fixture, other, 0.0f)) return;
        if (m_s.knownTo[Row(other)] == m_s.round) return;
        if (!MayPush(fixture, other)) return;
        const int index = static_cast<int>(m_s.pairs.size());
        for (const int b : {body, otherBody}) {
            if (m_s.firstPair[Row(b)] < 0) m_s.touched.push_back(b);
        }
        m_s.pairs.push_back(
            {fixture, other, body, otherBody, 0, m_s.firstPair[Row(body)], m_s.firstPair[Row(otherBody)], false});
        m_s.firstPair[Row(body)] = index;
        m_s.firstPair[Row(otherBody)] = index;
        UpdateEvent(index);
    }

    /// Neither refused by a filter or a joint nor disabled by a listener.
    [[nodiscard]] bool MayPush(int fixture, int other) const {
        // Who asks nobody need not look for the contact: it is enabled, and there because it may be.
        if (m_events.listener != nullptr || m_events.filter != nullptr) {
            const int contact = m_t.contacts.Find(static_cast<uint32_t>(fixture), static_cast<uint32_t>(other));
            if (contact >= 0) return m_t.contacts.Has(contact, ContactFlag::enabled);
        }
        return MayHaveContact(std::min(fixture, other), std::max(fixture, other), m_events, m_t.fixtures, m_t.joints);
    }

    /// Spares the search for a time of impact where shapes may touch: an event begins only some slops below the
    /// surfaces, where disks that roll never get. Leaves as much again as an event's tolerance to rounding.
    [[nodiscard]] bool PassesBy(const ToiPair& pair) const {
        const bool isStaticA = m_bodies.type[Row(pair.bodyA)] == staticBody;
        if (!isStaticA && m_bodies.type[Row(pair.bodyB)] != staticBody) return false;
        const int fixture = isStaticA ? pair.fixtureB : pair.fixtureA,
                  other = isStaticA ? pair.fixtureA : pair.fixtureB;
        const float scale = m_settings.lengthScale;
        const float radii = m_t.fixtures.shape[Row(fixture)]->m_radius + m_t.fixtures.shape[Row(other)]->m_radius;
        return IsClear(fixture, other, radii - (TOITarget(radii, scale) + 2.0f * toiTolerance * scale));
    }
    /// True if a fixture, on its whole way, surely overlaps a static one by less than `overlap`; with 0 they stay
    /// apart, as where the boxes of slanted slabs overlap.
    [[nodiscard]] bool IsClear(int fixture, int other, float overlap) const {
        const int body = m_t.fixtures.body[Row(fixture)], otherBody = m_t.fixtures.body[Row(other)];
        const float reach = Reach(*m_t.fixtures.shape[Row(fixture)], m_bodies.mass[Row(body)].localCenter);
        const Vec2 frame = FrameOf(m_bodies, body, otherBody);
        return WayIsClear(*m_t.fixtures.shape[Row(other)], TransformIn(frame, m_bodies, otherBody),
                          StartIn(frame, m_bodies, body), CentreIn(frame, m_bodies, body), reach - overlap);
    }

    [[nodiscard]] int Next(int pair, int body) const {
        const ToiPair& p = m_s.pairs[Row(pair)];
        return p.bodyA == body ? p.nextA : p.nextB;
    }

    /// Computes when the pair meets and puts, moves or takes out its event.
    void UpdateEvent(int index) {
        const ToiPair& pair = m_s.pairs[Row(index)];
        const float alpha = pair.over || PassesBy(pair) ? 1.0f : TimeOf(pair);
        if (alpha >= 1.0f) {
            m_s.events.Remove(index);
            return;
        }
        const auto low = static_cast<uint64_t>(std::min(pair.fixtureA, pair.fixtureB));
        const auto high = static_cast<uint64_t>(std::max(pair.fixtureA, pair.fixtureB));
        m_s.events.Set(index, alpha, high << 32 | low);
    }

    /// The part of the step at which the pair meets; 1: not in this step.
    [[nodiscard]] float TimeOf(const ToiPair& pair) const {
        TOIInput input;
        input.proxyA.Set(m_t.fixtures.shape[Row(pair.fixtureA)], 0);
        input.proxyB.Set(m_t.fixtures.shape[Row(pair.fixtureB)], 0);
        const Vec2 frame = FrameOf(m_bodies, pair.bodyA, pair.bodyB);
        input.sweepA = SweepOf(pair.bodyA, frame);
        input.sweepB = SweepOf(pair.bodyB, frame);
        const float alpha0 = Max(input.sweepA.alpha0, input.sweepB.alpha0);
        if (alpha0 >= 1.0f) return 1.0f;
        input.sweepA.Advance(alpha0);
        input.sweepB.Advance(alpha0);
        input.tMax = 1.0f;
        input.lengthScale = m_settings.lengthScale;
        TOIOutput output;
        TimeOfImpact(&output, &input);
        m_events.work->Add(output);
        // A search that gave up has shown the way up to t to be free: stop there rather than pass through.
        if (output.state != TOIOutput::e_touching && output.state != TOIOutput::e_failed) return 1.0f;
        return Min(alpha0 + (1.0f - alpha0) * output.t, 1.0f);
    }

    /// Moves the body to the given part of the step, where its motion starts (and for now ends).
    BodyBackup Advance(int body, float alpha) {
        const BodyBackup backup{body,
                                m_bodies.startPosition[Row(body)],
                                m_bodies.position[Row(body)],
                                m_bodies.IsFar() ? m_bodies.rest[Row(body)] : PositionRest{},
                                m_bodies.transform[Row(body)],
                                m_s.alpha[Row(body)]};
        const Vec2 frame = FrameOf(m_bodies, body, body);
        Sweep sweep = SweepOf(body, frame);
        sweep.Advance(alpha);
        m_bodies.position[Row(body)] = {sweep.c0, sweep.a0, 0.0f};
        if (m_bodies.IsFar()) {
            m_bodies.position[Row(body)].c = frame;
            m_bodies.rest[Row(body)].end = sweep.c0;
        }
        m_s.alpha[Row(body)] = alpha;
        m_bodies.UpdateTransform(body);
        m_bodies.NoteStart(Row(body));
        return backup;
    }

    void Restore(const BodyBackup& backup) {
        m_bodies.startPosition[Row(backup.body)] = backup.start;
        m_bodies.position[Row(backup.body)] = backup.end;
        if (m_bodies.IsFar()) m_bodies.rest[Row(backup.body)] = backup.rest;
        m_bodies.transform[Row(backup.body)] = backup.transform;
        m_s.alpha[Row(backup.body)] = backup.alpha;
    }

    /// The contact of a pair whose bodies stand at the event, updated; −1 if they do not touch or must not.
    int TouchingContact(const ToiPair& pair) {
        int contact = m_t.contacts.Find(static_cast<uint32_t>(pair.fixtureA), static_cast<uint32_t>(pair.fixtureB));
        if (contact < 0) {
            contact = MakeContact(std::min(pair.fixtureA, pair.fixtureB), std::max(pair.fixtureA, pair.fixtureB),
                                  m_t.fixtures, m_t.contacts);
        }
        if (contact < 0) return -1;
        const bool touching = UpdateContact(contact, m_t.fixtures, m_events, m_bodies, m_t.contacts);
        return touching && m_t.contacts.Has(contact, ContactFlag::enabled) ? contact : -1;
    }

    /// Stops the pair at the event and solves it. False if nothing happens after all.
    bool HandleEvent(int index, float alpha) {
        ++m_s.pairs[Row(index)].rounds;
        const ToiPair pair = m_s.pairs[Row(index)];
        const BodyBackup backupA = Advance(pair.bodyA, alpha);
        const BodyBackup backupB = Advance(pair.bodyB, alpha);
        const int contact = TouchingContact(pair);
        if (contact < 0) {
            m_s.pairs[Row(index)].over = true;
            Restore(backupA);
            Restore(backupB);
            return false;
        }
        ++m_report.events;
        m_bodies.Wake(pair.bodyA);
        m_bodies.Wake(pair.bodyB);
        m_s.islandContacts.assign(1, contact);
        m_s.islandBodies.assign({pair.bodyA, pair.bodyB});
        for (const int body : {pair.bodyA, pair.bodyB}) {
            if (IsDynamic(body)) JoinTouching(body, index, alpha);
        }
        SolveEvent(pair, alpha);
        for (size_t i = 0; i < m_s.islandBodies.size(); ++i) {
            const int body = m_s.islandBodies[i];
            if (m_bodies.type[Row(body)] != staticBody) Refresh(body);
        }
        return true;
    }

    /// Adds what else touches the body at the time of the event: a corner stops it from two sides.
    void JoinTouching(int body, int event, float alpha) {
        for (int p = m_s.firstPair[Row(body)]; p >= 0; p = Next(p, body)) {
            const ToiPair pair = m_s.pairs[Row(p)];
            if (p == event || pair.over) continue;
            const int other = pair.bodyA == body ? pair.bodyB : pair.bodyA;
            const bool isMember =
                std::find(m_s.islandBodies.begin(), m_s.islandBodies.end(), other) != m_s.islandBodies.end();
            const BodyBackup backup = isMember ? BodyBackup{} : Advance(other, alpha);
            const int contact = BoxesOverlap(pair) ? TouchingContact(pair) : -1;
            if (contact < 0) {
                if (!isMember) Restore(backup);
                continue;
            }
            if (std::find(m_s.islandContacts.begin(), m_s.islandContacts.end(), contact) == m_s.islandContacts.end()) {
                m_s.islandContacts.push_back(contact);
            }
            if (isMember) continue;
            m_s.islandBodies.push_back(other);
            m_bodies.Wake(other);
        }
    }

    [[nodiscard]] bool BoxesOverlap(const ToiPair& pair) const {
        AABB a, b;
        const Vec2 frame = FrameOf(m_bodies, pair.bodyA, pair.bodyB);
        m_t.fixtures.shape[Row(pair.fixtureA)]->ComputeAABB(&a, TransformIn(frame, m_bodies, pair.bodyA));
        m_t.fixtures.shape[Row(pair.fixtureB)]->ComputeAABB(&b, TransformIn(frame, m_bodies, pair.bodyB));
        return TestOverlap(a, b);
    }

    void SolveEvent(const ToiPair& pair, float alpha) {
        const ContactPrepareInput input{m_bodies, m_t.fixtures, m_t.contacts, m_s.islandContacts, 0.0f};
        const float tolerance = positionTolerance * m_settings.lengthScale;
        const PushApart push{toiBaumgarte, m_settings.lengthScale};
        PrepareContacts(input, m_s.rows);
        for (ContactPositionRow& row : m_s.rows.position) {
            // Only the two bodies of the event move: the others stand where an earlier event or nothing put them.
            if (row.bodyA != pair.bodyA && row.bodyA != pair.bodyB) row.massA.invMass = row.massA.invI = 0.0f;
            if (row.bodyB != pair.bodyA && row.bodyB != pair.bodyB) row.massB.invMass = row.massB.invI = 0.0f;
        }
        for (int i = 0; i < positionIterations; ++i) {
            if (SolveContactPositions(m_s.rows, m_bodies, push) >= tolerance) break;
        }
        for (const int body : {pair.bodyA, pair.bodyB}) {
            Quarantine(body);
            m_bodies.UpdateTransform(body);
            m_bodies.NoteStart(Row(body));
        }
        const float rest = (1.0f - alpha) * m_settings.dt;
        FindAhead(rest);
        for (size_t i = 0; i < m_s.islandBodies.size(); ++i) AddSpeed(i, -1.0f);
        PrepareContacts(input, m_s.rows);
        for (int i = 0; i < m_settings.velocityIterations; ++i) SolveContactVelocities(m_s.rows, m_bodies.velocity);
        ReportImpulses(m_s.rows, m_events, m_t.contacts);
        const bool leaves = StaysApart();
        for (size_t i = 0; i < m_s.islandBodies.size(); ++i) {
            const int body = m_s.islandBodies[i];
            if (m_bodies.type[Row(body)] == staticBody) continue;
            // A body that its contact goes on to hold up is not accelerated.
            if (leaves) AddSpeed(i, 0.5f);
            Integrate(body, rest);
            if (leaves) AddSpeed(i, 0.5f);
        }
    }

    /// What forces will add to the velocities of the event's bodies in the rest of the step, and have added already.
    void FindAhead(float rest) {
        if (m_s.ballistic.empty()) {
            m_s.ballistic.resize(Row(m_bodies.slots.Size()), 0);
            for (const int body : m_settings.ballistic) m_s.ballistic[Row(body)] = 1;
        }
        m_s.ahead.clear();
        for (const int body : m_s.islandBodies) {
            Velocity& ahead = m_s.ahead.emplace_back();
            if (m_s.ballistic[Row(body)] == 0 || !IsDynamic(body)) continue;
            const MassRow& mass = m_bodies.mass[Row(body)];
            const ForceRow force = m_bodies.GetForce(body);
            const MotionRow& motion = m_bodies.motion[Row(body)];
            const Vec2 pull = (motion.gravityScale * motion.mass) * m_settings.gravity + force.force;
            ahead.v = (rest * mass.invMass) * pull;
            ahead.w = rest * mass.invI * force.torque;
        }
    }
    void AddSpeed(size_t islandBody, float factor) {
        Velocity& v = m_bodies.velocity[Row(m_s.islandBodies[islandBody])];
        const Velocity& ahead = m_s.ahead[islandBody];
        v.v += factor * ahead.v;
        v.w += factor * ahead.w;
    }

    /// After the event: no contact of it will be pressed together again by forces within the step.
    [[nodiscard]] bool StaysApart() const {
        const auto aheadOf = [this](int body) {
            const auto at = std::find(m_s.islandBodies.begin(), m_s.islandBodies.end(), body);
            return at == m_s.islandBodies.end() ? Velocity{}
                                                : m_s.ahead[static_cast<size_t>(at - m_s.islandBodies.begin())];
        };
        for (const ContactVelocityRow& row : m_s.rows.velocity) {
            const Velocity a = aheadOf(row.bodyA), b = aheadOf(row.bodyB);
            const Velocity& vA = m_bodies.velocity[Row(row.bodyA)];
            const Velocity& vB = m_bodies.velocity[Row(row.bodyB)];
            for (int i = 0; i < row.pointCount; ++i) {
                const Vec2 speedA = vA.v + a.v + Cross(vA.w + a.w, row.points[i].rA);
                const Vec2 speedB = vB.v + b.v + Cross(vB.w + b.w, row.points[i].rB);
                if (Dot(row.normal, speedB - speedA) < 0.0f) return false;
            }
        }
        return true;
    }

    void Integrate(int body, float h) {
        Velocity& v = m_bodies.velocity[Row(body)];
        const float way = h * v.v.Length();
        const float turn = h * Abs(v.w);
        if (way > m_settings.maxTranslation || turn > m_settings.maxRotation) ++m_report.capped;
        if (way > m_settings.maxTranslation) v.v *= m_settings.maxTranslation / way;
        if (turn > m_settings.maxRotation) v.w *= m_settings.maxRotation / turn;
        m_bodies.Shift(Row(body), h * v.v);
        m_bodies.position[Row(body)].a += h * v.w;
        Quarantine(body);
        m_bodies.UpdateTransform(body);
    }

    /// A body that is not finite any more goes back to where the event found it, at rest.
    void Quarantine(int body) {
        Velocity& v = m_bodies.velocity[Row(body)];
        const bool inRange = IsInRange(m_bodies.position[Row(body)], v);
        if (inRange && (!m_bodies.IsFar() || IsInRange(m_bodies.rest[Row(body)].end))) return;
        ++m_report.nonFinite;
        m_bodies.ReturnToStart(Row(body));
        v = {vec2Zero, 0.0f, 0.0f};
    }

    /// New times for all pairs of a body whose motion changed, and pairs with what has come into its way.
    void Refresh(int body) {
        for (int p = m_s.firstPair[Row(body)]; p >= 0; p = Next(p, body)) UpdateEvent(p);
        if (!Moves(body)) return;
        if (m_dynamicTargets) SweepBoxesOf(body);
        CollectPairs(body, m_dynamicTargets);
    }

    /// Holds the dynamic bodies of the pair where they meet, for the rest of the step.
    void Abandon(int index, float alpha) {
        const ToiPair pair = m_s.pairs[Row(index)];
        m_s.pairs[Row(index)].over = true;
        for (const int body : {pair.bodyA, pair.bodyB}) {
            if (!IsDynamic(body)) continue;
            Advance(body, alpha);
            ++m_report.abandoned;
            m_report.lostTime += (1.0f - alpha) * m_settings.dt;
            for (int p = m_s.firstPair[Row(body)]; p >= 0; p = Next(p, body)) UpdateEvent(p);
        }
    }

    const ContinuousSettings& m_settings;
    const ContactEvents& m_events;
    ContinuousTables m_t;
    BodyTable& m_bodies;
    ContinuousScratch& m_s;
    ContinuousReport m_report;
    bool m_dynamicTargets = false;  ///< some body can hit dynamic ones: a bullet or a kinematic body
};

}  // namespace

ContinuousReport SolveContinuous(const ContinuousSettings& settings, const ContactEvents& events,
                                 ContinuousTables tables, ContinuousScratch& scratch) {
    return ContinuousSolver(settings, events, tables, scratch).Run();
}

}  // namespace scree
