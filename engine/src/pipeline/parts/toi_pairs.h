// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Part of the continuous stage: the pairs of fixtures that may meet within the step, and when they do. Boxes swept over
// the motion find the pairs, conservative advancement (geometry/time_of_impact.cpp) their times, which are put into the
// heap of events.

#pragma once

#include <vector>

#include "base/indexed_heap.h"
#include "broad_phase/broad_phase.h"
#include "pipeline/contact_events.h"
#include "pipeline/parts/near_statics.h"
#include "scree/time_of_impact.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/fixtures.h"
#include "state/joints.h"

namespace scree {

struct ContinuousTables {
    BodyTable& bodies;
    FixtureTable& fixtures;
    JointTable& joints;
    ContactTable& contacts;
    BroadPhase& broadPhase;
};

/// Two fixtures that may meet on their way.
struct ToiPair {
    int fixtureA, fixtureB;
    int bodyA, bodyB;
    int rounds;           ///< events so far
    int nextA, nextB;     ///< the next pair of each body's list
    bool over;            ///< not to be looked at again in this step
    bool isHeld = false;  ///< by its contact: only its centre is looked at
};

/// Scratch of the pairs, kept between steps.
struct ToiScratch {
    std::vector<ToiPair> pairs;
    std::vector<int> firstPair;  ///< per body, −1: none
    std::vector<float> alpha;    ///< per body: the part of the step done at its start position
    std::vector<int> touched;    ///< bodies whose entries above must be reset
    std::vector<int> found;      ///< fixtures of one query
    std::vector<int> lookers;    ///< bodies whose ways are looked at
    std::vector<int> knownTo;    ///< per fixture: the round of collecting in which it was found to have a pair
    int round = 0;               ///< of collecting, counts up; 0: none yet
    NearStatics nearStatics;
    IndexedHeap events;
    bool resuming = false;  ///< the step goes on

    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(pairs, firstPair, alpha, touched, found, lookers, knownTo) + nearStatics.GetMemoryBytes() +
               events.GetMemoryBytes();
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
    /// New times for all pairs of a body.
    void UpdateTimes(int body);
    /// The same after its motion changed, and pairs with what has come into its way.
    void Refresh(int body);

    [[nodiscard]] bool IsDynamic(int body) const { return m_bodies.type[static_cast<size_t>(body)] == dynamicBody; }
    /// The body's motion in what is left of the step, relative to `frame`.
    [[nodiscard]] Sweep SweepOf(int body, Vec2 frame) const;
    /// The pair behind `pair` in the list of the body that begins with firstPair; −1: none.
    [[nodiscard]] int Next(int pair, int body) const {
        const ToiPair& p = m_s.pairs[static_cast<size_t>(pair)];
        return p.bodyA == body ? p.nextA : p.nextB;
    }

private:
    [[nodiscard]] bool IsBullet(int body) const { return m_bodies.Has(body, BodyFlag::bullet); }
    [[nodiscard]] bool MayMeet(int bodyA, int bodyB) const;
    [[nodiscard]] bool Moves(int body) const;
    void SweepBoxes();
    void SweepBoxesOf(int body);
    [[nodiscard]] AABB SweptBox(int body, int fixture) const;
    void CollectFirst(int body, const NearStatics::Tables& tables);
    void Collect(int body, bool withDynamic);
    void MarkKnown(int body, int fixture);
    void Add(int fixture, int other);
    [[nodiscard]] bool MayCollide(int fixture, int other) const;
    [[nodiscard]] bool PassesBy(const ToiPair& pair) const;
    [[nodiscard]] bool IsClear(int fixture, int other, float overlap) const;
    void UpdateEvent(int index);
    [[nodiscard]] float TimeOf(const ToiPair& pair) const;

    const float m_lengthScale;
    const bool m_atOutlines;
    const ContactEvents& m_events;
    const ContinuousTables& m_t;
    BodyTable& m_bodies;
    ToiScratch& m_s;
    bool m_dynamicTargets = false;  ///< some body can hit dynamic ones: a bullet or a kinematic body
};

}  // namespace scree
