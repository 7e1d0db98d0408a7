// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Part of the continuous stage: the pairs of fixtures that may meet within the step, and when they do. Boxes swept over
// the motion find the pairs, conservative advancement (geometry/time_of_impact.cpp) their times, which are put into the
// heap of events.
//
// Most bodies rest, slide or pass by. Cheap bounds (geometry/passage.h) show that they meet nothing; such a body gets
// no pairs until an event needs them. Bodies are looked over, their candidates found and times searched on all workers;
// pairs are made in the order of bodies, by one.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "base/indexed_heap.h"
#include "base/task_pool.h"
#include "broad_phase/broad_phase.h"
#include "geometry/passage.h"
#include "geometry/swept_box.h"
#include "pipeline/contact_events.h"
#include "pipeline/parts/near_statics.h"
#include "scree/time_of_impact.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct ContinuousTables {
    TaskPool& pool;
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
    BroadPhase& broadPhase;
};

/// What the bounds have said of a pair's way.
enum class Bounded : uint8_t {
    notYet,
    isSpared,    ///< it has no event
    needsCores,  ///< the middle of the mover meets nothing
    needsSearch
};

/// Two fixtures that may meet on their way.
struct ToiPair {
    FixtureIndex fixtureA, fixtureB;
    BodyIndex bodyA, bodyB;
    int rounds;                         ///< events so far
    int nextA, nextB;                   ///< the next pair of each body's list
    bool over;                          ///< not to be looked at again in this step
    bool isHeld = false;                ///< by its contact: only its centre is looked at
    Bounded bounded = Bounded::notYet;  ///< of the way at which it was made
};

/// A fixture of a body and one on its way.
struct ToiCandidate {
    FixtureIndex fixture, other;
    Bounded bounded = Bounded::notYet;
    bool isScreened = false;  ///< is not clear of the static one's way
};

/// A fixture that dynamic ones may meet: of a kinematic body, or of a bullet that rests.
struct ToiHitter {
    AABB box;  ///< covers its way
    FixtureIndex fixture;
    bool moves;  ///< its body is active
};

/// What the first look at a body says.
enum class ScreenedBody : uint8_t {
    passes,
    hasCandidates,  ///< among what is known to be near it
    isToCollect
};

/// And what was found for it: candidates [begin, end) of those of a worker, with their bounds.
struct ScreenFind {
    ScreenedBody says = ScreenedBody::passes;
    uint8_t worker = 0;
    int begin = 0, end = 0;
};

/// What a worker found for the bodies that it looked over.
struct ScreenedCandidates {
    std::vector<ToiCandidate> kept;    ///< of all of them
    std::vector<ToiCandidate> ofBody;  ///< of one, with those that are spared

    void MatchRoomOf(const ScreenedCandidates& other) { MatchRoom(ofBody, other.ofBody); }
};

/// What ToiPairs::Look found for a body: candidates [begin, end) of those of a worker.
struct ToiLook {
    bool moves = false;
    int worker = 0;
    int begin = 0, end = 0;
};
/// What a worker that looks needs, and what it found for all its bodies.
struct ToiLooker {
    std::vector<FixtureIndex> found;  ///< of one query
    std::vector<ToiCandidate> candidates;

    void MatchRoomOf(const ToiLooker& other) { MatchRoom(found, other.found), MatchRoom(candidates, other.candidates); }
};

/// For tests: searches in full for every pair that was spared it.
struct ToiAudit {
    int spared = 0;
    int missed = 0;  ///< of these: had an event after all
};

/// Scratch of the pairs, kept between steps.
struct ToiScratch {
    Column<int, ToiPair> pairs;
    Column<BodyIndex, int> firstPair;      ///< per body, −1: none
    Column<BodyIndex, float> alpha;        ///< per body: the part of the step done at its start position
    Column<BodyIndex, uint8_t> ballistic;  ///< per body: moved by gravity and forces alone; empty until they meet
    std::vector<BodyIndex> touched;        ///< bodies whose entries in firstPair and alpha must be reset
    std::vector<FixtureIndex> found;       ///< fixtures of one query
    std::vector<BodyIndex> lookers;        ///< bodies whose ways are looked at
    IndexSet<MoverRow> nearTargets;        ///< those that rest and are on somebody's way
    std::vector<ToiCandidate> candidates;  ///< of one body
    std::vector<ScreenFind> screened;      ///< by place among the lookers
    std::vector<ScreenedCandidates> ofWorkers;
    std::vector<BoxUpdate> sweptBoxes;        ///< when someone can hit moving bodies
    std::vector<ToiHitter> hitters;           ///< while they are few
    Column<BodyIndex, uint8_t> isPassedOver;  ///< per body: 1 if it has no pairs because it meets nothing static
    Column<int, float> times;                 ///< per pair
    Column<FixtureIndex, int> knownTo;  ///< per fixture: the round of collecting in which it was found to have a pair
    int round = 0;                      ///< of collecting, counts up; 0: none yet
    NearStatics nearStatics;
    IndexedHeap events;
    bool resuming = false;  ///< the step goes on
    ToiAudit* audit = nullptr;

    [[nodiscard]] size_t GetMemoryBytes() const {
        size_t bytes = ofWorkers.capacity() * sizeof(ScreenedCandidates);
        for (const ScreenedCandidates& own : ofWorkers) bytes += BytesOf(own.kept, own.ofBody);
        return bytes +
               BytesOf(pairs, firstPair, alpha, ballistic, touched, found, lookers, candidates, screened, sweptBoxes,
                       hitters, isPassedOver, times, knownTo) +
               nearTargets.GetMemoryBytes() + nearStatics.GetMemoryBytes() + events.GetMemoryBytes();
    }
};

class ToiPairs {
public:
    /// `atOutlines`: bodies rest where their outlines touch (soft step).
    ToiPairs(float lengthScale, bool atOutlines, const ContactEvents& events, const ContinuousTables& tables,
             ToiScratch& scratch)
        : m_lengthScale(lengthScale),
          m_atOutlines(atOutlines),
          m_events(events),
          m_t(tables),
          m_bodies(tables.bodies),
          m_s(scratch) {}

    /// Forgets all pairs, and where bodies stand in the step unless it goes on.
    void Clear();
    /// Makes the pairs of everything that moves with what is on its way.
    void FindAll();
    /// Makes the pairs of a body that was passed over: it takes part in an event.
    void Complete(BodyIndex body);
    /// New times for all pairs of a body.
    void UpdateTimes(BodyIndex body);
    /// The same of one pair.
    void UpdateEvent(int index);
    /// The same after its motion changed, and pairs with what has come into its way.
    void Refresh(BodyIndex body);
    /// Whether bodies meet others than static ones: kinematic ones or bullets.
    [[nodiscard]] bool MeetsMovers() const { return m_dynamicTargets; }
    // Where they do not, Refresh has two parts. Several threads may look for bodies that no joint or contact joins.
    void PrepareLooks();
    [[nodiscard]] ToiLook Look(BodyIndex body, int worker, ToiLooker& looker);
    /// Takes what was found.
    void Take(BodyIndex body, const ToiLook& look, std::span<const ToiLooker> lookers);
    /// Moves the body to the given part of the step, where its motion starts (and for now ends).
    void Advance(BodyIndex body, float alpha);

    [[nodiscard]] bool IsDynamic(BodyIndex body) const { return m_bodies.type[body] == dynamicBody; }
    /// The body's motion in what is left of the step, relative to `frame`.
    [[nodiscard]] Sweep SweepOf(BodyIndex body, Vec2 frame) const;
    /// The pair behind `pair` in the list of the body that begins with firstPair; −1: none.
    [[nodiscard]] int Next(int pair, BodyIndex body) const {
        const ToiPair& p = m_s.pairs[pair];
        return p.bodyA == body ? p.nextA : p.nextB;
    }

private:
    [[nodiscard]] bool IsBullet(BodyIndex body) const { return m_bodies.Has(body, BodyFlag::bullet); }
    /// Looks for all that hits it, as that looks for static fixtures alone.
    [[nodiscard]] bool IsHitter(BodyIndex body) const {
        return m_bodies.IsTarget(body) && (!IsDynamic(body) || !m_bodies.IsActive(body));
    }
    [[nodiscard]] bool MayMeet(BodyIndex bodyA, BodyIndex bodyB) const;
    [[nodiscard]] bool Moves(BodyIndex body) const;
    /// Of a pair with something dynamic: which one moves against the other.
    [[nodiscard]] bool IsMoverA(const ToiPair& pair) const {
        return IsDynamic(pair.bodyA) && (!IsDynamic(pair.bodyB) || IsBullet(pair.bodyA));
    }
    [[nodiscard]] ToiPair PairOf(FixtureIndex fixture, FixtureIndex other) const {
        return {.fixtureA = fixture,
                .fixtureB = other,
                .bodyA = m_t.fixtures.body[fixture],
                .bodyB = m_t.fixtures.body[other],
                .rounds = 0,
                .nextA = -1,
                .nextB = -1,
                .over = false};
    }
    [[nodiscard]] NearStatics::Tables Nearby() const { return {m_bodies, m_t.fixtures, m_t.broadPhase, m_lengthScale}; }
    void AddRestingTargets();
    void Screen();
    [[nodiscard]] ScreenFind ScreenBody(BodyIndex body, int worker);
    [[nodiscard]] bool PassesAll(BodyIndex body, std::span<const FixtureIndex> near);
    [[nodiscard]] ScreenFind FindKnown(BodyIndex body, std::span<const FixtureIndex> near, int worker);
    void AuditBody(BodyIndex body) const;
    void Audit(const ToiPair& pair) const;
    void FindTimes();
    void SweepBoxes();
    [[nodiscard]] QuickSweep QuickSweepOf(BodyIndex body) const;
    [[nodiscard]] bool AreFewToMeet(bool somethingMoves) const;
    void GatherTargets();
    void SweepHitters();
    void CollectHits(BodyIndex body, size_t& next);
    void FindTargets(const ToiHitter& hitter);
    void SweepBoxesOf(BodyIndex body);
    struct PassedBox {
        AABB onWay, atEnd;
        float skin, reach;  ///< m: within which things meet; of the fixture from the body's centre
    };
    [[nodiscard]] PassedBox PassedBoxOf(BodyIndex body, FixtureIndex fixture) const;
    [[nodiscard]] float ReachOf(BodyIndex body, FixtureIndex fixture) const;
    [[nodiscard]] AABB SweptBox(BodyIndex body, FixtureIndex fixture) const;
    void CollectFirst(BodyIndex body);
    void Collect(BodyIndex body, bool withDynamic);
    void FindCandidates(BodyIndex body, FixtureIndex fixture, std::span<const FixtureIndex> known,
                        std::vector<ToiCandidate>& candidates) const;
    /// Bounds the ways to static ones; true if all candidates are spared.
    bool BoundWays(std::span<ToiCandidate> candidates) const;
    void FindCandidates(BodyIndex body, FixtureIndex fixture, bool withDynamic);
    void FindStatic(BodyIndex body, FixtureIndex fixture, std::vector<FixtureIndex>& found,
                    std::vector<ToiCandidate>& candidates) const;
    void AddCandidates(BodyIndex body);
    void MarkKnown(BodyIndex body, FixtureIndex fixture);
    void Add(const ToiCandidate& candidate);
    [[nodiscard]] bool MayCollide(FixtureIndex fixture, FixtureIndex other) const;
    [[nodiscard]] bool PassesBy(const ToiPair& pair) const;
    [[nodiscard]] bool IsClear(FixtureIndex fixture, FixtureIndex other, float overlap) const;
    [[nodiscard]] Clearance ClearanceOf(const ToiPair& pair) const;
    [[nodiscard]] Bounded BoundsOf(const ToiPair& pair) const;
    void SetEvent(int index, float alpha);
    void PutEvent(int index, float alpha);
    [[nodiscard]] float FirstTimeOf(const ToiPair& pair, Bounded bounded, TOIStats& work) const;
    [[nodiscard]] float TimeOf(const ToiPair& pair, Bounded bounded, TOIStats& work) const;

    const float m_lengthScale;
    const bool m_atOutlines;
    const ContactEvents& m_events;
    const ContinuousTables& m_t;
    BodyTable& m_bodies;
    ToiScratch& m_s;
    bool m_timesFollow = false;     ///< of all pairs, once they are there
    bool m_dynamicTargets = false;  ///< some body can hit dynamic ones: a bullet or a kinematic body
    bool m_fewToMeet = false;       ///< these are few, and no bullet moves: sweptBoxes holds what is near them
    bool m_hittersAreSwept = true;  ///< the broad phase has the boxes of the hitters
};

}  // namespace scree
