// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Candidates → pairs → times.

#include "pipeline/parts/toi_pairs.h"

#include <algorithm>
#include <limits>

#include "geometry/passage.h"
#include "geometry/reach.h"
#include "pipeline/parts/make_contact.h"
#include "state/frames.h"

namespace scree {

namespace {

/// Below these counts bodies to look over and searches are not worth waking workers for.
constexpr int leastToScreen = 512, leastSearches = 32;

/// The middle of a mover is stopped at the slop before a surface, or at this share of its depth in the mover where that
/// is less. It is stopped at no less than a fiftieth of the slop, for below that rounding decides.
constexpr float middleShare = 0.25f, leastMiddleScale = 0.02f;

/// How far apart boxes are along x or y; negative: they overlap.
float GapOf(const AABB& a, const AABB& b) {
    const Vec2 below = a.lowerBound - b.upperBound, above = b.lowerBound - a.upperBound;
    return Max(Max(below.x, above.x), Max(below.y, above.y));
}

}  // namespace

void ToiPairs::Clear() {
    const size_t count = ToSize(m_bodies.slots.Size());
    m_s.pairs.clear();
    m_s.events.Clear();
    EnsureRows(m_s.firstPair, count, -1);
    EnsureRows(m_s.alpha, count);
    EnsureRows(m_s.isPassedOver, count);
    for (const BodyIndex body : m_s.lookers) m_s.isPassedOver[body] = 0;  // of the last step
    m_s.lookers.clear();
    for (const BodyIndex body : m_s.touched) {
        m_s.firstPair[body] = -1;
        if (!m_s.resuming) m_s.alpha[body] = 0.0f;
    }
    // Where bodies stand must be forgotten after the step that goes on, also if nothing touches them any more.
    std::erase_if(m_s.touched, [this](BodyIndex body) { return m_s.alpha[body] == 0.0f; });
}

/// Non-bullet dynamic bodies pass through each other.
bool ToiPairs::MayMeet(BodyIndex bodyA, BodyIndex bodyB) const {
    if (!IsDynamic(bodyA) && !IsDynamic(bodyB)) return false;
    return !IsDynamic(bodyA) || !IsDynamic(bodyB) || IsBullet(bodyA) || IsBullet(bodyB);
}

/// However slow, since a body that is pressed down may creep through by less than a slop a step.
bool ToiPairs::Moves(BodyIndex body) const {
    const Position& from = m_bodies.startPosition[body];
    const Position& to = m_bodies.position[body];
    if (!(from.c == to.c) || from.a != to.a) return true;
    return m_bodies.IsFar() && !(m_bodies.rest[body].start == m_bodies.rest[body].end);
}

void ToiPairs::FindAll() {
    const std::span<const BodyIndex> bodies = m_bodies.Listed();
    // What rests is no danger but to what moves: a kinematic body or a bullet that rests counts only where dynamic ones
    // do not.
    const bool somethingMoves =
        std::ranges::any_of(bodies, [this](BodyIndex b) { return IsDynamic(b) && m_bodies.IsActive(b); });
    m_s.lookers.assign(bodies.begin(), bodies.end());
    if (somethingMoves) AddRestingTargets();
    for (const BodyIndex body : m_s.lookers) {
        if (!m_bodies.Has(body, BodyFlag::enabled)) continue;
        m_dynamicTargets = m_dynamicTargets || m_bodies.IsTarget(body);
    }
    m_fewToMeet = m_dynamicTargets && AreFewToMeet(somethingMoves);
    if (m_fewToMeet) {
        GatherTargets();
    } else if (m_dynamicTargets) {
        SweepBoxes();
    }
    Screen();
    m_timesFollow = true;
    size_t hitter = 0;
    for (size_t i = 0; i < m_s.lookers.size(); ++i) {
        const BodyIndex body = m_s.lookers[i];
        const ScreenFind& screened = m_s.screened[i];
        if (screened.says == ScreenedBody::passes) continue;
        if (screened.says == ScreenedBody::hasCandidates) {
            const std::vector<ToiCandidate>& found = m_s.ofWorkers[screened.worker].kept;
            m_s.candidates.assign(found.begin() + screened.begin, found.begin() + screened.end);
            AddCandidates(body);
        } else if (IsHitter(body) && m_fewToMeet) {
            CollectHits(body, hitter);
        } else if (IsHitter(body)) {
            Collect(body, true);  // even at rest: what hits it looks only for static fixtures
        } else {
            CollectFirst(body);
        }
    }
    m_timesFollow = false;
    FindTimes();
}

/// Adds the targets that rest, or where they are many those on somebody's way.
void ToiPairs::AddRestingTargets() {
    const std::span<const BodyIndex> movers = m_bodies.Listed();
    if (ToSize(m_bodies.targetRows.Count()) <= movers.size()) {
        m_bodies.AddResting(m_bodies.targetRows, m_s.lookers);
        return;
    }
    m_dynamicTargets = true;  // ways may still change
    m_s.nearTargets.Reserve(m_bodies.movers.size());
    m_s.nearTargets.Clear();
    const auto visit = [&](uint32_t proxy) {
        const BodyIndex body = m_t.fixtures.body[FixtureOf(proxy)];
        if (m_bodies.IsTarget(body)) m_s.nearTargets.Insert(m_bodies.info[body].moverRow);
        return true;
    };
    const float margin = linearSlop * m_lengthScale;  // as in QuickSweepOf
    for (const BodyIndex body : movers) {
        if (!IsDynamic(body) || !m_bodies.IsActive(body)) continue;
        for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
            if (!m_t.fixtures.info[f].inBroadPhase) continue;
            AABB box = SweptBox(body, f);
            box.lowerBound -= {margin, margin}, box.upperBound += {margin, margin};
            m_t.broadPhase.QueryResting(box, visit);
        }
    }
    m_bodies.AddResting(m_s.nearTargets, m_s.lookers);
}

/// Looks over all bodies, on all workers: who needs no pairs, and which candidates the others have where the static
/// fixtures near them are known. Changes only what is kept for the body or the worker.
void ToiPairs::Screen() {
    m_t.broadPhase.PrepareStatic();
    m_s.nearStatics.PrepareCalm(m_atOutlines);
    const std::vector<BodyIndex>& lookers = m_s.lookers;
    m_s.screened.resize(lookers.size());
    EnsureRows(m_s.ofWorkers, ToSize(m_t.pool.GetRowCount()));
    for (ScreenedCandidates& found : m_s.ofWorkers) found.kept.clear();
    m_t.pool.For(static_cast<int>(lookers.size()), leastToScreen, [&](int begin, int end, int worker) {
        for (int i = begin; i < end; ++i) m_s.screened[ToSize(i)] = ScreenBody(lookers[ToSize(i)], worker);
    });
    size_t kept = 0;
    for (const ScreenedCandidates& found : m_s.ofWorkers) kept += found.kept.size();
    ReserveEach(m_s.ofWorkers, &ScreenedCandidates::kept, kept);
    MatchRooms(m_s.ofWorkers);
    if (m_s.audit == nullptr) return;
    for (const BodyIndex body : lookers) {
        if (m_s.isPassedOver[body] != 0 && m_bodies.IsActive(body)) AuditBody(body);
    }
}

ScreenFind ToiPairs::ScreenBody(BodyIndex body, int worker) {
    if (!m_bodies.Has(body, BodyFlag::enabled)) return {ScreenedBody::passes};
    if (IsHitter(body)) return {ScreenedBody::isToCollect};
    if (!m_bodies.IsActive(body)) return {ScreenedBody::passes};
    if (IsBullet(body)) return {ScreenedBody::isToCollect};
    if (!Moves(body)) return {ScreenedBody::passes};
    if (m_bodies.IsFar()) return {ScreenedBody::isToCollect};
    ScreenFind find{ScreenedBody::passes};
    if (!m_s.nearStatics.StaysCalm(body, m_bodies)) {
        const auto near = m_s.nearStatics.FindApart(body, Nearby());
        if (!near) return {ScreenedBody::isToCollect};
        if (!PassesAll(body, *near)) find = FindKnown(body, *near, worker);
    }
    if (find.says == ScreenedBody::passes) m_s.isPassedOver[body] = 1;
    return find;
}

/// Collects for a body whose near static fixtures are known.
ScreenFind ToiPairs::FindKnown(BodyIndex body, std::span<const FixtureIndex> near, int worker) {
    auto& [kept, candidates] = m_s.ofWorkers[ToSize(worker)];
    candidates.clear();
    for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
        if (m_t.fixtures.isSensor[f] || !m_t.fixtures.info[f].inBroadPhase) continue;
        FindCandidates(body, f, near, candidates);
    }
    if (BoundWays(candidates)) return {ScreenedBody::passes};
    const size_t begin = kept.size();
    for (ToiCandidate& candidate : candidates) {
        if (IsClear(candidate.fixture, candidate.other, 0.0f)) continue;
        candidate.isScreened = true;
        kept.push_back(candidate);
    }
    return {ScreenedBody::hasCandidates, static_cast<uint8_t>(worker), static_cast<int>(begin),
            static_cast<int>(kept.size())};
}

/// True if the body surely meets none of the static fixtures near it.
bool ToiPairs::PassesAll(BodyIndex body, std::span<const FixtureIndex> near) {
    float slack = std::numeric_limits<float>::max(), reach = 0.0f;
    for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
        if (near.empty()) break;
        if (m_t.fixtures.isSensor[f] || !m_t.fixtures.info[f].inBroadPhase) continue;
        const PassedBox passed = PassedBoxOf(body, f);
        for (const FixtureIndex other : near) {
            const AABB& box = m_t.broadPhase.GetBox(ProxyOf(other));
            if (!TestOverlap(passed.onWay, box)) {
                slack = Min(slack, GapOf(passed.atEnd, box) - passed.skin);
                reach = Max(reach, passed.reach);
                continue;
            }
            const ToiPair pair = PairOf(f, other);
            const Clearance clearance = ClearanceOf(pair);
            slack = clearance.isSure ? Min(slack, clearance.slack) : -1.0f;
            reach = Max(reach, clearance.reach);
            if (clearance.isSure) continue;
            if (!PassesBy(pair) && TestOverlap(SweptBox(body, f), box)) return false;
        }
    }
    if (slack > 0.0f) m_s.nearStatics.NoteCalm(body, m_bodies, reach, slack);
    return true;
}

/// Searches in full for what was passed over, where boxes overlap: no search is made where they do not.
void ToiPairs::AuditBody(BodyIndex body) const {
    const auto near = m_s.nearStatics.Get(body, m_bodies);
    if (!near) return;
    for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
        if (m_t.fixtures.isSensor[f] || !m_t.fixtures.info[f].inBroadPhase) continue;
        const AABB box = SweptBox(body, f);
        for (const FixtureIndex other : *near) {
            if (TestOverlap(box, m_t.broadPhase.GetBox(ProxyOf(other)))) Audit(PairOf(f, other));
        }
    }
}

void ToiPairs::Audit(const ToiPair& pair) const {
    TOIStats work;
    AddShared(m_s.audit->spared, 1);
    if (TimeOf(pair, Bounded::notYet, work) < 1.0f) AddShared(m_s.audit->missed, 1);
}

/// Times of all pairs, on all workers, and their events.
void ToiPairs::FindTimes() {
    m_s.times.resize(m_s.pairs.size());
    m_t.pool.For(static_cast<int>(m_s.pairs.size()), leastSearches, [&](int begin, int end, int /*worker*/) {
        TOIStats work;
        for (int i = begin; i < end; ++i) {
            m_s.times[i] = FirstTimeOf(m_s.pairs[i], m_s.pairs[i].bounded, work);
        }
        if (work.calls > 0) CountSearches(*m_events.work, work);
    });
    for (const int i : m_s.times.Rows()) {
        if (m_s.times[i] < 1.0f) SetEvent(i, m_s.times[i]);
    }
}

/// Gives the dynamic bodies boxes that cover their motion, when someone can hit them. What is found by them is asked
/// for its exact box.
void ToiPairs::SweepBoxes() {
    m_s.sweptBoxes.clear();
    const bool isAtStart = !m_s.resuming && !m_bodies.IsFar();
    for (const BodyIndex body : m_bodies.Listed()) {
        if (!m_bodies.IsActive(body)) continue;
        const QuickSweep sweep = QuickSweepOf(body);
        for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
            const AABB box = isAtStart ? sweep.Cover(m_t.broadPhase.GetBox(ProxyOf(f))) : SweptBox(body, f);
            m_s.sweptBoxes.push_back({box, vec2Zero, ProxyOf(f)});
        }
    }
    m_t.broadPhase.CoverWays(m_s.sweptBoxes);
}

/// No bullets that move, few fixtures of hitters for what is dynamic and moves, and boxes in the broad phase that are
/// those of the start of the step.
bool ToiPairs::AreFewToMeet(bool somethingMoves) const {
    constexpr int most = 24;
    if (m_s.resuming || m_bodies.IsFar()) return false;
    if (!somethingMoves) return true;
    int fixtures = 0;
    for (const BodyIndex body : m_s.lookers) {
        if (!m_bodies.Has(body, BodyFlag::enabled) || !m_bodies.IsTarget(body)) continue;
        if (!IsHitter(body)) return false;
        fixtures += m_bodies.info[body].fixtureCount;
        if (fixtures > most) return false;
    }
    return true;
}

/// Lists the fixtures of hitters with boxes that cover their motion, and the listed dynamic fixtures whose own boxes
/// then overlap one of these. That is one pass over the bodies instead of a tree of all their swept boxes.
void ToiPairs::GatherTargets() {
    m_s.sweptBoxes.clear();
    m_s.hitters.clear();
    m_hittersAreSwept = false;
    for (const BodyIndex body : m_s.lookers) {
        if (!IsHitter(body) || !m_bodies.Has(body, BodyFlag::enabled)) continue;
        const bool moves = m_bodies.IsActive(body);
        for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
            m_s.hitters.push_back({SweptBox(body, f), f, moves});
        }
    }
    if (m_s.hitters.empty()) return;
    const auto isNear = [this](const AABB& box) {
        return std::ranges::any_of(m_s.hitters, [&](const ToiHitter& hitter) { return TestOverlap(box, hitter.box); });
    };
    for (const BodyIndex body : m_bodies.Listed()) {
        if (!IsDynamic(body) || !m_bodies.Has(body, BodyFlag::enabled)) continue;
        const bool isActive = m_bodies.IsActive(body);
        const QuickSweep sweep = QuickSweepOf(body);
        for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
            const AABB box = m_t.broadPhase.GetBox(ProxyOf(f));
            if (!isNear(isActive ? sweep.Cover(box) : box)) continue;
            m_s.sweptBoxes.push_back({isActive ? SweptBox(body, f) : box, vec2Zero, ProxyOf(f)});
        }
    }
}

QuickSweep ToiPairs::QuickSweepOf(BodyIndex body) const {
    const Position& from = m_bodies.startPosition[body];
    const Position& to = m_bodies.position[body];
    const float margin = linearSlop * m_lengthScale;  // boxes of what fell asleep may lag behind
    return {from.c, to.c, to.a - from.a, margin};
}

/// Gives the broad phase the boxes of the hitters: from the first event on dynamic bodies ask for them.
void ToiPairs::SweepHitters() {
    if (m_hittersAreSwept) return;
    m_hittersAreSwept = true;
    for (const ToiHitter& hitter : m_s.hitters) {
        if (hitter.moves) m_t.broadPhase.CoverWay(ProxyOf(hitter.fixture), hitter.box);
    }
}

/// Makes the pairs of a hitter with everything dynamic on its way. `next`: its first hitter; afterwards that of
/// the next body.
void ToiPairs::CollectHits(BodyIndex body, size_t& next) {
    m_s.candidates.clear();
    for (; next < m_s.hitters.size() && m_t.fixtures.body[m_s.hitters[next].fixture] == body; ++next) {
        const ToiHitter& hitter = m_s.hitters[next];
        if (m_t.fixtures.isSensor[hitter.fixture] || !m_t.fixtures.info[hitter.fixture].inBroadPhase) continue;
        FindTargets(hitter);
    }
    if (!m_s.candidates.empty()) AddCandidates(body);
}

/// Dynamic fixtures that rest are found by the broad phase; those of listed bodies that are near were gathered.
void ToiPairs::FindTargets(const ToiHitter& hitter) {
    m_s.found.clear();
    const auto visit = [&](uint32_t other) {
        const BodyIndex body = m_t.fixtures.body[FixtureOf(other)];
        if (IsDynamic(body) && m_bodies.isListed[body] == 0) m_s.found.push_back(FixtureOf(other));
        return true;
    };
    m_t.broadPhase.QueryResting(hitter.box, visit);
    for (const BoxUpdate& target : m_s.sweptBoxes) {
        if (TestOverlap(hitter.box, target.box)) m_s.found.push_back(FixtureOf(target.fixture));
    }
    std::sort(m_s.found.begin(), m_s.found.end());  // the order of a query depends on the algorithm
    for (const FixtureIndex other : m_s.found) m_s.candidates.push_back({hitter.fixture, other});
}

void ToiPairs::SweepBoxesOf(BodyIndex body) {
    for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
        m_t.broadPhase.CoverWay(ProxyOf(f), SweptBox(body, f));
    }
}

/// A quick box around the fixture's whole way: no point leaves the straight way to where it ends by more than the turn
/// takes it.
ToiPairs::PassedBox ToiPairs::PassedBoxOf(BodyIndex body, FixtureIndex fixture) const {
    const Shape& shape = *m_t.fixtures.shape[fixture];
    PassedBox passed;
    shape.ComputeAABB(&passed.atEnd, m_bodies.transform[body]);
    passed.reach = ReachOf(body, fixture);
    const Vec2 from = m_bodies.startPosition[body].c, to = m_bodies.position[body].c, way = to - from;
    constexpr float perSize = 5e-7f;  // eight roundings
    const float rounding = perSize * (Abs(from.x) + Abs(from.y) + Abs(to.x) + Abs(to.y) + passed.reach);
    // What is nearer than the slop counts as met even without a skin.
    passed.skin = 2.0f * linearSlop * m_lengthScale + rounding;
    const float turned = Abs(m_bodies.position[body].a - m_bodies.startPosition[body].a) * passed.reach + rounding;
    const Vec2 wider{turned, turned};
    passed.onWay = {passed.atEnd.lowerBound - wider - Max(way, vec2Zero),
                    passed.atEnd.upperBound + wider - Min(way, vec2Zero)};
    return passed;
}

/// Of the fixture, which is no sensor, from the body's centre of mass, m.
float ToiPairs::ReachOf(BodyIndex body, FixtureIndex fixture) const {
    // Shapes are all over memory.
    const float known = m_bodies.info[body].fixtureCount == 1 ? m_s.nearStatics.GetReach(body) : -1.0f;
    return known >= 0.0f ? known : Reach(*m_t.fixtures.shape[fixture], m_bodies.mass[body].localCenter);
}

/// Covers the fixture on its whole way.
AABB ToiPairs::SweptBox(BodyIndex body, FixtureIndex fixture) const {
    const Vec2 frame = FrameOf(m_bodies, body, body);
    const AABB box =
        scree::SweptBox(*m_t.fixtures.shape[fixture], SweepOf(body, frame), TransformIn(frame, m_bodies, body));
    return m_bodies.IsFar() ? ToWorld(frame, box) : box;
}

Sweep ToiPairs::SweepOf(BodyIndex body, Vec2 frame) const {
    Sweep sweep;
    sweep.localCenter = m_bodies.mass[body].localCenter;
    sweep.c0 = StartIn(frame, m_bodies, body);
    sweep.a0 = m_bodies.startPosition[body].a;
    sweep.c = CentreIn(frame, m_bodies, body);
    sweep.a = m_bodies.position[body].a;
    sweep.alpha0 = m_s.alpha[body];
    return sweep;
}

/// Collect for a dynamic body that has no pairs yet but those of kinematic bodies and bullets with it.
void ToiPairs::CollectFirst(BodyIndex body) {
    const bool isBullet = IsBullet(body);
    const auto known = isBullet ? std::nullopt : m_s.nearStatics.Find(body, Nearby());
    m_s.candidates.clear();
    for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
        if (m_t.fixtures.isSensor[f] || !m_t.fixtures.info[f].inBroadPhase) continue;
        if (!known) {
            FindCandidates(body, f, isBullet);
        } else if (!known->empty()) {
            FindCandidates(body, f, *known, m_s.candidates);
        }
    }
    if (m_s.candidates.empty()) return;
    const bool areSpared = BoundWays(m_s.candidates);
    if (areSpared && !isBullet) {
        m_s.isPassedOver[body] = 1;
    } else {
        AddCandidates(body);
    }
}

bool ToiPairs::BoundWays(std::span<ToiCandidate> candidates) const {
    bool areSpared = true;
    for (ToiCandidate& c : candidates) {
        if (m_bodies.type[m_t.fixtures.body[c.other]] == staticBody) c.bounded = BoundsOf(PairOf(c.fixture, c.other));
        areSpared = areSpared && c.bounded == Bounded::isSpared;
    }
    return areSpared;
}

/// Makes the pairs of a body with everything on its way and puts their events into the heap.
void ToiPairs::Collect(BodyIndex body, bool withDynamic) {
    m_s.candidates.clear();
    for (const FixtureIndex f : m_t.fixtures.From(m_bodies.fixtureHead[body])) {
        if (m_t.fixtures.isSensor[f] || !m_t.fixtures.info[f].inBroadPhase) continue;
        FindCandidates(body, f, withDynamic);
    }
    AddCandidates(body);
}

void ToiPairs::FindCandidates(BodyIndex body, FixtureIndex fixture, std::span<const FixtureIndex> known,
                              std::vector<ToiCandidate>& candidates) const {
    const AABB box = SweptBox(body, fixture);
    for (const FixtureIndex other : known) {
        if (TestOverlap(box, m_t.broadPhase.GetBox(ProxyOf(other)))) candidates.push_back({fixture, other});
    }
}

/// Those on its way in an order that does not hang on the algorithm: static ones, or all.
void ToiPairs::FindCandidates(BodyIndex body, FixtureIndex fixture, bool withDynamic) {
    if (!withDynamic) {
        m_t.broadPhase.PrepareStatic();
        return FindStatic(body, fixture, m_s.found, m_s.candidates);
    }
    m_s.found.clear();
    const AABB box = SweptBox(body, fixture);
    m_t.broadPhase.PrepareQueries();  // boxes were swept
    m_t.broadPhase.Query(box, [&](uint32_t proxy) {
        const FixtureIndex other = FixtureOf(proxy);
        const BodyIndex otherBody = m_t.fixtures.body[other];
        const bool isSwept = m_bodies.isListed[otherBody] != 0 && m_bodies.IsActive(otherBody);
        if (!isSwept || TestOverlap(box, SweptBox(otherBody, other))) m_s.found.push_back(other);
        return true;
    });
    std::sort(m_s.found.begin(), m_s.found.end());
    for (const FixtureIndex other : m_s.found) m_s.candidates.push_back({fixture, other});
}
void ToiPairs::FindStatic(BodyIndex body, FixtureIndex fixture, std::vector<FixtureIndex>& found,
                          std::vector<ToiCandidate>& candidates) const {
    found.clear();
    m_t.broadPhase.QueryStatic(SweptBox(body, fixture), [&](uint32_t proxy) {
        const FixtureIndex other = FixtureOf(proxy);
        // A mover that is shown all the same looks for its pairs itself, or the order of a pair would hang on the tree.
        if (m_bodies.type[m_t.fixtures.body[other]] == staticBody) found.push_back(other);
        return true;
    });
    std::sort(found.begin(), found.end());
    for (const FixtureIndex other : found) candidates.push_back({fixture, other});
}

void ToiPairs::AddCandidates(BodyIndex body) {
    m_s.isPassedOver[body] = 0;
    for (size_t i = 0; i < m_s.candidates.size(); ++i) {
        const ToiCandidate candidate = m_s.candidates[i];
        if (i == 0 || candidate.fixture != m_s.candidates[i - 1].fixture) MarkKnown(body, candidate.fixture);
        Add(candidate);
    }
}

/// Marks the fixtures that have a pair with `fixture` already: one pass, however many are to be asked about.
void ToiPairs::MarkKnown(BodyIndex body, FixtureIndex fixture) {
    EnsureRows(m_s.knownTo, ToSize(m_t.fixtures.slots.Size()));
    if (m_s.round == std::numeric_limits<int>::max()) {
        m_s.round = 0;
        std::ranges::fill(m_s.knownTo, 0);
    }
    ++m_s.round;
    for (int p = m_s.firstPair[body]; p >= 0; p = Next(p, body)) {
        const ToiPair& pair = m_s.pairs[p];
        if (pair.fixtureA == fixture) m_s.knownTo[pair.fixtureB] = m_s.round;
        if (pair.fixtureB == fixture) m_s.knownTo[pair.fixtureA] = m_s.round;
    }
}

void ToiPairs::Add(const ToiCandidate& candidate) {
    const FixtureIndex fixture = candidate.fixture, other = candidate.other;
    const BodyIndex body = m_t.fixtures.body[fixture];
    const BodyIndex otherBody = m_t.fixtures.body[other];
    if (otherBody == body || m_t.fixtures.isSensor[other] || !MayMeet(body, otherBody)) return;
    if (!m_bodies.IsActive(body) && !m_bodies.IsActive(otherBody)) return;
    const bool isStatic = m_bodies.type[otherBody] == staticBody;
    if (isStatic && !candidate.isScreened && IsClear(fixture, other, 0.0f)) return;
    if (m_s.knownTo[other] == m_s.round) return;
    if (!MayCollide(fixture, other)) return;
    const int index = static_cast<int>(m_s.pairs.size());
    for (const BodyIndex b : {body, otherBody}) {
        if (m_s.firstPair[b] < 0) m_s.touched.push_back(b);
    }
    m_s.pairs.push_back(PairOf(fixture, other));
    m_s.pairs.back().bounded = candidate.bounded;
    m_s.pairs.back().nextA = m_s.firstPair[body];
    m_s.pairs.back().nextB = m_s.firstPair[otherBody];
    m_s.firstPair[body] = index;
    m_s.firstPair[otherBody] = index;
    if (!m_timesFollow) UpdateEvent(index);
}

/// Neither refused by a filter or a joint nor disabled by a listener.
bool ToiPairs::MayCollide(FixtureIndex fixture, FixtureIndex other) const {
    // Who asks nobody need not look for the contact: it is enabled, and there because it may be.
    if (m_events.listener != nullptr || m_events.filter != nullptr) {
        const ContactIndex contact = m_t.contacts.Find(fixture, other);
        if (IsSome(contact)) return m_t.contacts.Has(contact, ContactFlag::enabled);
    }
    const uint64_t key = RefusedPairs::KeyOf(fixture, other);
    if (m_events.filter != nullptr && m_t.contacts.refused.Has(key)) return false;
    return MayHaveContact(std::min(fixture, other), std::max(fixture, other), m_events, m_t.fixtures, m_t.joints);
}

/// Spares the search for a time of impact where shapes may touch: an event begins only some slops below the
/// surfaces, where disks that roll never get. Leaves as much again as an event's tolerance to rounding.
bool ToiPairs::PassesBy(const ToiPair& pair) const {
    const bool isStaticA = m_bodies.type[pair.bodyA] == staticBody;
    if (!isStaticA && m_bodies.type[pair.bodyB] != staticBody) return false;
    const FixtureIndex fixture = isStaticA ? pair.fixtureB : pair.fixtureA,
                       other = isStaticA ? pair.fixtureA : pair.fixtureB;
    const float scale = m_lengthScale;
    const float radii = m_t.fixtures.shape[fixture]->m_radius + m_t.fixtures.shape[other]->m_radius;
    return IsClear(fixture, other, radii - (TOITarget(radii, scale) + 2.0f * toiTolerance * scale));
}
/// True if a fixture, on its whole way, surely overlaps a static one by less than `overlap`; with 0 they stay
/// apart, as where the boxes of slanted slabs overlap.
bool ToiPairs::IsClear(FixtureIndex fixture, FixtureIndex other, float overlap) const {
    const BodyIndex body = m_t.fixtures.body[fixture], otherBody = m_t.fixtures.body[other];
    const float reach = ReachOf(body, fixture);
    const Vec2 frame = FrameOf(m_bodies, body, otherBody);
    return WayIsClear(*m_t.fixtures.shape[other], TransformIn(frame, m_bodies, otherBody),
                      StartIn(frame, m_bodies, body), CentreIn(frame, m_bodies, body), reach - overlap);
}

/// Bounds the motion of a pair one of which does not turn.
Clearance ToiPairs::ClearanceOf(const ToiPair& pair) const {
    const bool isMoverA = IsMoverA(pair);
    const BodyIndex mover = isMoverA ? pair.bodyA : pair.bodyB, still = isMoverA ? pair.bodyB : pair.bodyA;
    const bool isStatic = m_bodies.type[still] == staticBody;
    if (!isStatic && m_bodies.startPosition[still].a != m_bodies.position[still].a) return {};
    // Ways are compared from a body's own start on.
    const float begin = m_s.alpha[mover], beginOfStill = m_s.alpha[still];
    if (!isStatic && begin != beginOfStill) return {};
    const Vec2 frame = FrameOf(m_bodies, mover, still);
    Vec2 way = CentreIn(frame, m_bodies, mover) - StartIn(frame, m_bodies, mover);
    if (!isStatic) way -= CentreIn(frame, m_bodies, still) - StartIn(frame, m_bodies, still);
    const float turn = m_bodies.position[mover].a - m_bodies.startPosition[mover].a;
    const Watched watched = pair.isHeld                             ? Watched::middle
                            : m_atOutlines && begin >= beginOfStill ? Watched::coresOrMiddle
                                                                    : Watched::cores;
    const FixtureIndex fixture = isMoverA ? pair.fixtureA : pair.fixtureB,
                       other = isMoverA ? pair.fixtureB : pair.fixtureA;
    return BoundClearance(
        {*m_t.fixtures.shape[other], TransformIn(frame, m_bodies, still), *m_t.fixtures.shape[fixture],
         TransformIn(frame, m_bodies, mover), m_bodies.mass[mover].localCenter, way, turn},
        watched, m_lengthScale);
}

/// What has to be searched of the pair.
Bounded ToiPairs::BoundsOf(const ToiPair& pair) const {
    const Clearance clearance = ClearanceOf(pair);
    if (!clearance.isSure && !PassesBy(pair)) {
        return clearance.middlePasses ? Bounded::needsCores : Bounded::needsSearch;
    }
    if (m_s.audit != nullptr) Audit(pair);
    return Bounded::isSpared;
}

float ToiPairs::FirstTimeOf(const ToiPair& pair, Bounded bounded, TOIStats& work) const {
    if (pair.over) return 1.0f;
    if (bounded == Bounded::notYet) bounded = BoundsOf(pair);
    return bounded == Bounded::isSpared ? 1.0f : TimeOf(pair, bounded, work);
}

/// Computes when the pair meets and puts, moves or takes out its event.
void ToiPairs::UpdateEvent(int index) {
    PutEvent(index, FirstTimeOf(m_s.pairs[index], Bounded::notYet, *m_events.work));
}
void ToiPairs::PutEvent(int index, float alpha) { alpha < 1.0f ? SetEvent(index, alpha) : m_s.events.Remove(index); }

void ToiPairs::SetEvent(int index, float alpha) {
    const ToiPair& pair = m_s.pairs[index];
    const uint64_t low = ProxyOf(std::min(pair.fixtureA, pair.fixtureB));
    const uint64_t high = ProxyOf(std::max(pair.fixtureA, pair.fixtureB));
    m_s.events.Set(index, alpha, high << 32 | low);
}

/// The part of the step at which the pair meets; 1: not in this step.
float ToiPairs::TimeOf(const ToiPair& pair, Bounded bounded, TOIStats& work) const {
    TOIInput input;
    input.proxyA.Set(m_t.fixtures.shape[pair.fixtureA], 0);
    input.proxyB.Set(m_t.fixtures.shape[pair.fixtureB], 0);
    const Vec2 frame = FrameOf(m_bodies, pair.bodyA, pair.bodyB);
    input.sweepA = SweepOf(pair.bodyA, frame);
    input.sweepB = SweepOf(pair.bodyB, frame);
    const float alpha0 = Max(input.sweepA.alpha0, input.sweepB.alpha0);
    if (alpha0 >= 1.0f) return 1.0f;
    input.sweepA.Advance(alpha0);
    input.sweepB.Advance(alpha0);
    input.tMax = 1.0f;
    input.lengthScale = m_lengthScale;
    TOIOutput output;
    const auto search = [&] {
        TimeOfImpact(&output, &input);
        work.Add(output);
    };
    if (!pair.isHeld) search();
    // What begins as near as it may come, or within the other already, is held by its contact. Only the middle of the
    // one that moves must not pass to the other side.
    if (pair.isHeld || output.state == TOIOutput::e_overlapped || (m_atOutlines && output.t <= 0.0f)) {
        if (bounded == Bounded::needsCores) return 1.0f;
        const bool isA = IsMoverA(pair);
        const Shape& mover = *m_t.fixtures.shape[isA ? pair.fixtureA : pair.fixtureB];
        const Shape& still = *m_t.fixtures.shape[isA ? pair.fixtureB : pair.fixtureA];
        const Vec2 middle = MiddleOf(mover);
        const float part = MiddlePartOf(mover);
        DistanceProxy core;
        core.Set(&mover, 0);
        Vec2 vertices[maxConvexVertices];
        const int count = part > 0.0f ? std::min(core.m_count, maxConvexVertices) : 1;
        for (int i = 0; i < count; ++i) vertices[i] = middle + part * (core.m_vertices[i] - middle);
        (isA ? input.proxyA : input.proxyB).Set(vertices, count, 0.0f);
        // The middle of a small thing that lies on the surface is nearer to it than some slops: it may come nearer.
        const float depth = (1.0f - part) * DepthOfMiddle(mover);
        const float share = middleShare * depth / (linearSlop * m_lengthScale);
        input.lengthScale *= Clamp(share, leastMiddleScale, 1.0f);
        const bool hasSkin = still.GetType() == Shape::e_polygon || still.GetType() == Shape::e_edge;
        if (hasSkin) (isA ? input.proxyB : input.proxyA).m_radius = 0.0f;
        search();
    }
    // A search that gave up has shown the way up to t to be free: stop there rather than pass through.
    if (output.state != TOIOutput::e_touching && output.state != TOIOutput::e_failed) return 1.0f;
    return Min(alpha0 + (1.0f - alpha0) * output.t, 1.0f);
}

}  // namespace scree
