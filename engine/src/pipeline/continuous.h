// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Stage: continuous collision. Bodies have moved from their start to their end positions. Whatever would pass through a
// static or kinematic fixture on the way (a bullet: through anything) is stopped at the time of impact. The contact
// pushes it there, and it goes on for the rest of the step.
//
// The dissertation's scheme (§6). Boxes swept over the motion find candidates, and a binary min-heap with changeable
// keys holds the events in order of time. Only bodies that an event moved are queried again. Contacts of pairs that
// have parted are removed later, with the others. The times come from conservative advancement
// (geometry/time_of_impact.cpp). One event is solved as in Box2D 2.4: positions first, with only the two bodies free to
// move, then velocities without warm starting.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "constraints/contact_rows.h"
#include "pipeline/contact_events.h"
#include "pipeline/parts/impact_round.h"
#include "pipeline/parts/solver.h"
#include "pipeline/parts/toi_pairs.h"

namespace scree {

struct ContinuousSettings {
    float dt;  ///< of the whole step, s
    int velocityIterations;
    float maxTranslation, maxRotation;  ///< per step
    bool subStepping;                   ///< stop after the first event; the next call goes on from there
    float lengthScale;                  ///< factor on the tolerances
    Vec2 gravity;
    /// Bodies that moved under gravity and forces alone, exactly: at an impact they have the speed of that moment, and
    /// forces act for the rest of the step after it. Without exact drift: none.
    std::span<const BodyIndex> ballistic;
    /// Soft step: bodies rest where their outlines touch.
    bool atOutlines = false;
    /// Soft step: solves and moves jointed bodies for the rest of a step. One limb that is stopped alone tears its
    /// joints.
    JointedRestSolver rest{};
    StartVelocities* startVelocities = nullptr;
};

/// After a step that the solver has done, or begun to do, with these settings. `substeps` are those that it took,
/// `isolated` are the bodies that it moved without contacts and joints.
ContinuousSettings MakeContinuousSettings(const SolverSettings& solver, int substeps,
                                          std::span<const BodyIndex> isolated, bool subStepping);

struct ContinuousReport {
    int events = 0;         ///< times a body was stopped at an impact
    int abandoned = 0;      ///< bodies held at an impact because their pair had maxSubSteps events
    float lostTime = 0.0f;  ///< motion that abandoned bodies lost, s, summed
    int capped = 0;         ///< times a body's way on after an event was shortened to a cap
    int nonFinite = 0;      ///< bodies that an event left with a state that is not finite: stopped where they met
    bool complete = true;   ///< false: sub-stepping stopped it
};

/// Scratch of the stage, kept between steps; with sub-stepping also what is left of an unfinished step.
struct ContinuousScratch : ToiScratch {
    ContactRows rows;
    std::vector<Velocity> ahead;  ///< per body of islandBodies: change of velocity by forces in the rest of the step
    std::vector<ContactIndex> islandContacts;
    std::vector<BodyIndex> islandBodies;
    ImpactScratch impacts;
    std::vector<int> pairsInOrder;       ///< of one body
    Column<BodyIndex, int> islandPlace;  ///< per body: its place in islandBodies; −1 if it is not there
    std::vector<BodyIndex> goingOn;      ///< of a step that goes on: what was active before

    [[nodiscard]] size_t GetMemoryBytes() const {
        return ToiScratch::GetMemoryBytes() +
               BytesOf(rows.velocity, rows.position, ahead, islandContacts, islandBodies, pairsInOrder, islandPlace,
                       goingOn) +
               impacts.GetMemoryBytes();
    }
};

/// Runs all events of the step. Transforms are those of the end positions afterwards; boxes are not updated.
ContinuousReport SolveContinuous(const ContinuousSettings& settings, const ContactEvents& events,
                                 ContinuousTables tables, ContinuousScratch& scratch);

}  // namespace scree
