// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Part of the continuous stage: impacts of jointed bodies in the soft step. Everything that joints hold to a body that
// is stopped goes on from the impact together, with all that touches it. Impacts follow each other in the order of
// their times, but those of bodies that do not touch have nothing to do with each other. They are gathered in a round,
// and all workers solve it, unless a listener is to be told. Which impacts are in a round does not depend on how many
// workers there are.

#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "pipeline/contact_events.h"
#include "pipeline/parts/solver.h"
#include "pipeline/parts/toi_pairs.h"
#include "scree/function_ref.h"

namespace scree {

/// Bodies that joints hold together, from an impact on: they stand where it found them.
struct JointedRest {
    std::span<const BodyIndex> bodies;
    std::span<const ContactIndex> contacts;
    std::span<const JointIndex> joints;
    float dt;    ///< what is left of the step, s
    int worker;  ///< that solves it
};
/// Solves and moves them. Several workers below `workers` may do so at the same time for bodies that do not touch.
struct JointedRestSolver {
    FunctionRef<void(int workers)> prepare{};
    FunctionRef<SolverCounts(const JointedRest&)> solve{};
};

/// Scratch of what one worker solves after impacts.
struct RestScratch {
    SolverScratch solver;
    IslandTable lists;
};
using RestScratches = std::vector<std::unique_ptr<RestScratch>>;  ///< by worker, as many as have solved any
inline size_t GetMemoryBytes(const RestScratches& scratches) {
    size_t bytes = scratches.capacity() * sizeof(scratches.front());
    for (const auto& one : scratches)
        bytes += sizeof(RestScratch) + one->solver.GetMemoryBytes() + one->lists.GetMemoryBytes();
    return bytes;
}

/// One of a round; what it consists of ends where that of the next one begins.
struct JointedImpact {
    float alpha;  ///< the part of the step that is done
    size_t bodies, joints, contacts;
    SolverCounts counts{};
};

/// Scratch of the rounds, kept between steps.
struct ImpactScratch {
    std::vector<JointedImpact> impacts;
    std::vector<BodyIndex> bodies;  ///< of all of them
    std::vector<JointIndex> joints;
    std::vector<ContactIndex> contacts;
    std::vector<BodyIndex> beside;     ///< other dynamic bodies with which they have contacts
    std::vector<uint8_t> touching;     ///< by place in `contacts`
    Column<BodyIndex, uint8_t> marks;  ///< per body: in which list it is; 0 between rounds
    std::vector<ToiLook> looks;        ///< by place in `bodies`
    std::vector<ToiLooker> lookers;    ///< by worker

    size_t mostImpacts = 512;  ///< in one round; tests put it to 1
    size_t largestRound = 0;   ///< so far, for tests

    [[nodiscard]] size_t GetMemoryBytes() const {
        size_t bytes = lookers.capacity() * sizeof(ToiLooker);
        for (const ToiLooker& looker : lookers) bytes += BytesOf(looker.found, looker.candidates);
        return bytes + BytesOf(impacts, bodies, joints, contacts, beside, touching, marks, looks);
    }
};

struct ImpactSettings {
    float dt;                          ///< of the whole step, s
    JointedRestSolver rest;            ///< null: bodies are not held by their joints at impacts
    StartVelocities* startVelocities;  ///< of the step
};

class ImpactRound {
public:
    ImpactRound(const ImpactSettings& settings, const ContactEvents& events, const ContinuousTables& tables,
                ImpactScratch& scratch, ToiScratch& toiScratch, ToiPairs& toi)
        : m_settings(settings),
          m_events(events),
          m_t(tables),
          m_bodies(tables.bodies),
          m_s(scratch),
          m_toiScratch(toiScratch),
          m_toi(toi) {}

    /// Forgets a round that a callback ended by an exception.
    void Clear();
    [[nodiscard]] bool IsEmpty() const { return m_s.impacts.empty(); }
    /// Bodies may meet those of other impacts, or there is no room for more.
    [[nodiscard]] bool IsFull() const {
        return !IsEmpty() && (m_toi.MeetsMovers() || m_s.impacts.size() >= m_s.mostImpacts);
    }
    /// Whether joints hold one of the pair's dynamic bodies.
    [[nodiscard]] bool IsJointed(const ToiPair& pair) const;
    /// Whether an impact of the pair has nothing to do with those of the round. Gathers what joints hold to it.
    [[nodiscard]] bool IsApart(const ToiPair& pair);
    /// The dynamic bodies that joints hold to a jointed pair that IsApart was asked about last.
    [[nodiscard]] std::span<const BodyIndex> Gathered() const { return std::span(m_s.bodies).subspan(m_bodiesIn); }
    /// Adds an impact of these bodies, which are where they were.
    void Add(float alpha);
    /// Solves the impacts of the round, which is empty then.
    SolverCounts Solve();

private:
    enum Mark : uint8_t { none, member, beside, gathered };

    [[nodiscard]] bool IsSolved(const JointInfo& joint) const;
    [[nodiscard]] bool HasSolvedJoint(BodyIndex body) const;
    [[nodiscard]] bool Gather(BodyIndex body);
    [[nodiscard]] bool GatherAll(const ToiPair& pair);
    void DropGathered();
    void ListContacts(BodyIndex body);
    /// Calls visit(contact, the other body) for the contacts that can push the body.
    template <typename Visit>
    void ForEachContact(BodyIndex body, Visit&& visit);
    [[nodiscard]] Mark MarkOf(BodyIndex body) const {
        return m_s.marks.Has(body) ? static_cast<Mark>(m_s.marks[body]) : none;
    }
    void MoveToImpact(BodyIndex body, float alpha);
    void UpdateContacts();
    void KeepActing();
    void SolveAll();
    void SolveOne(size_t impact, int worker);
    [[nodiscard]] int ReturnLost(std::span<const ContactIndex> contacts);

    template <typename T>
    [[nodiscard]] std::span<const T> PartOf(const std::vector<T>& all, size_t impact,
                                            size_t JointedImpact::*begin) const {
        const size_t from = m_s.impacts[impact].*begin;
        const size_t to = impact + 1 < m_s.impacts.size() ? m_s.impacts[impact + 1].*begin : all.size();
        return std::span(all).subspan(from, to - from);
    }

    const ImpactSettings m_settings;
    const ContactEvents& m_events;
    const ContinuousTables& m_t;
    BodyTable& m_bodies;
    ImpactScratch& m_s;
    ToiScratch& m_toiScratch;
    ToiPairs& m_toi;
    size_t m_bodiesIn = 0, m_jointsIn = 0;  ///< those of the round; what follows is only gathered
};

}  // namespace scree
