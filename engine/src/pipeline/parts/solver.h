// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What both solvers are given, keep and report.

#pragma once

#include <vector>

#include "base/task_pool.h"
#include "constraints/contact_blocks.h"
#include "constraints/contact_rows.h"
#include "constraints/island_lanes.h"
#include "constraints/joint_solver.h"
#include "constraints/joint_tree.h"
#include "constraints/load_bearers.h"
#include "constraints/loaded_bodies.h"
#include "constraints/rolling_rows.h"
#include "pipeline/parts/locked_bodies.h"
#include "pipeline/parts/start_velocities.h"
#include "scree/accuracy.h"
#include "scree/features.h"
#include "scree/world_callbacks.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/islands.h"
#include "state/joints.h"

namespace scree {

struct SolverSettings {
    float dt;                                    ///< s, > 0
    float impulseScale;                          ///< of warm starting: dt / last dt, 0 without
    int velocityIterations, positionIterations;  ///< sequential impulses
    int substeps;                                ///< soft step; 0: sequential impulses
    Vec2 gravity;
    float maxTranslation, maxRotation;  ///< per step
    const KernelSet& kernels;           ///< what to leave out; a listener may add to it between two islands
    bool allowSleep;
    bool exactDrift;  ///< sequential impulses: positions advance by the mean of the velocities before and after
    bool directJoints = true;  ///< soft step: joints are solved directly where they can be
    float contactHertz, contactDampingRatio, contactPushSpeed;  ///< soft step
    float lengthScale = 1.0f;                                   ///< factor on tolerances
    const Tolerance* tolerance = nullptr;  ///< soft step: islands may take more than `substeps` to keep it

    [[nodiscard]] float Slop() const { return linearSlop * lengthScale; }
    /// Of warm starting a sub-step.
    [[nodiscard]] float SubstepScale() const { return impulseScale / static_cast<float>(substeps); }
    /// The same of contacts. What they did in a much shorter step is more of blows than of weight.
    [[nodiscard]] float ContactScale() const { return impulseScale <= 3.0f ? SubstepScale() : 0.0f; }
};

/// Velocity, or a change of it, without the room that a table's row leaves.
struct Twist {
    Vec2 v{0.0f, 0.0f};
    float w = 0.0f;
};

/// A body's constants over a soft step, and what its last sub-step did. One cache line.
struct alignas(64) SoftBody {
    BodyIndex body;
    bool jointed;
    float linearDamp, angularDamp;  ///< factors of half a sub-step
    Twist kick;                     ///< by gravity and forces in half a sub-step
    /// Velocity after the last kick, before constraints, without what contacts do. Of jointed bodies: velocity before
    /// the last pass over the contacts.
    Twist unaided;
    Twist byContacts;  ///< change by contacts in the last sub-step
    /// During warm starting: velocity before it. Then, of jointed bodies: change by contacts in this sub-step so far.
    /// Of others: velocity between the halves of the sub-step, before constraints.
    Twist gained;
};
static_assert(sizeof(SoftBody) == 64);

/// A body of a net.
struct NettedBody {
    int soft;     ///< row of `SolverScratch::soft`
    Twist ahead;  ///< what the second half of a sub-step brings to it, before joints and contacts
};

/// Small islands that are solved side by side (pipeline/parts/lane_solver.h).
struct LaneScratch {
    /// Where an island is in its group: the contacts from `first` on of a lane.
    struct Place {
        int island, lane, first;
    };
    /// A range of `places`.
    struct Group {
        int begin, end;
    };
    std::vector<uint8_t> isChosen;  ///< per island
    std::vector<int> bySize;        ///< islands that fit
    std::vector<Place> places;      ///< of the islands chosen
    std::vector<Group> groups;
    Column<BodyIndex, int> slotOf;
    /// What a worker needs.
    struct OfWorker {
        IslandLanes lanes;
        std::vector<IslandLanes::Member> members;  ///< of the group that it solves

        void MatchRoomOf(const OfWorker& other) {
            lanes.MatchRoomOf(other.lanes);
            MatchRoom(members, other.members);
        }
    };
    std::vector<OfWorker> workers;  ///< per worker

    [[nodiscard]] size_t GetMemoryBytes() const {
        size_t bytes = BytesOf(isChosen, bySize, places, groups, slotOf, workers);
        for (const OfWorker& one : workers) bytes += one.lanes.GetMemoryBytes() + BytesOf(one.members);
        return bytes;
    }
};

/// Rows of an island that is solved by itself (sequential impulses).
struct IslandRows {
    ContactRows contacts;
    RollingRows rolling;
    LockedBodies locked;
    JointConstraints joints;
    BodyMarks marks;
    std::vector<BodyIndex> sliced;  ///< bodies of the island, by slice
    ContactBlocks blocks;           ///< of islands whose blocks are not kept

    [[nodiscard]] size_t GetMemoryBytes() const {
        return BytesOf(contacts.velocity, contacts.position, sliced) + marks.GetMemoryBytes() +
               rolling.GetMemoryBytes() + locked.GetMemoryBytes() + joints.GetMemoryBytes() + blocks.GetMemoryBytes();
    }
    void MatchRoomOf(const IslandRows& other) {
        MatchRoom(contacts.velocity, other.contacts.velocity), MatchRoom(contacts.position, other.contacts.position);
        MatchRoom(marks.coloursTaken, other.marks.coloursTaken), MatchRoom(marks.isAtBorder, other.marks.isAtBorder);
        MatchRoom(sliced, other.sliced);
        rolling.MatchRoomOf(other.rolling);
        locked.MatchRoomOf(other.locked);
        joints.MatchRoomOf(other.joints);
        blocks.MatchRoomOf(other.blocks);
    }
};

/// An island that is in no group of LaneScratch.
struct LoneIsland {
    int island;
    int blocks;  ///< of SolverScratch::wide; -1: it keeps none
    int size;    ///< contacts and joints
};

/// What a worker solves at once, whatever the others do (sequential impulses).
struct SolverJob {
    bool isGroup;
    int index;  ///< of a group, or of a LoneIsland
    int cost;   ///< how long it takes, in contacts that are solved side by side
};

/// Constraints of a soft step. Their order stays until the next one while joints and contacts do.
struct SoftConstraints {
    JointTree tree;
    JointConstraints joints;
    ContactBlocks blocks;

    [[nodiscard]] size_t GetMemoryBytes() const {
        return tree.GetMemoryBytes() + joints.GetMemoryBytes() + blocks.GetMemoryBytes();
    }
    void Trim() {
        joints = {};
        blocks = {};
    }
};

/// Scratch of the solvers, kept between steps.
struct SolverScratch {
    bool anglesHaveRests = true;  ///< some Position::aRest may not be 0
    SoftConstraints constraints;
    BodyMarks marks;  ///< of the soft step, as the rows that follow
    RollingRows rolling;
    LoadBearers bearers;  ///< none between steps
    LoadedBodies loaded;
    LockedBodies locked;
    Column<BodyIndex, Velocity> delta;  ///< per body: motion since the start of the step; zero between steps
    std::vector<BodyIndex> sliced;      ///< bodies of islands, by slice
    std::vector<SoftBody> soft;
    StartVelocities startVelocities;
    std::vector<int> jointed;  ///< rows of `soft`
    std::vector<NettedBody> netted;
    LaneScratch lanes;
    std::vector<SolverJob> jobs;
    std::vector<LoneIsland> lone;
    std::vector<IslandRows> islandRows;  ///< per worker if there are several, and the last for one that has no job
    std::vector<ContactBlocks> wide;     ///< of the large islands, in their order (sequential impulses)
    std::vector<int> colours;            ///< by place in the list of contacts of islands; set of those that have blocks
    std::vector<ContactImpulse> impulses;
    std::vector<float> ofJoints;  ///< impulses before the rest of a step

    [[nodiscard]] size_t GetMemoryBytes() const {
        size_t ofIslands = BytesOf(islandRows, wide, jobs, lone, colours);
        for (const ContactBlocks& one : wide) ofIslands += one.GetMemoryBytes();
        for (const IslandRows& rows : islandRows) ofIslands += rows.GetMemoryBytes();
        return ofIslands + marks.GetMemoryBytes() + BytesOf(delta, sliced, soft, jointed, netted, impulses, ofJoints) +
               startVelocities.GetMemoryBytes() + constraints.GetMemoryBytes() + rolling.GetMemoryBytes() +
               bearers.GetMemoryBytes() + loaded.GetMemoryBytes() + locked.GetMemoryBytes() + lanes.GetMemoryBytes();
    }
    /// Gives the room of the last step back; the next one makes it anew.
    void Trim() {
        constraints.Trim();
        marks = {};
        rolling = {};
        bearers = {};
        loaded = {};
        locked = {};
        delta = {};
        sliced = {};
        soft = {};
        startVelocities = {};
        jointed = {};
        netted = {};
        lanes = {};
        jobs = {}, lone = {};
        islandRows = {};
        wide = {};
        colours = {};
        impulses = {};
        ofJoints = {};
    }
};

struct SolverCounts {
    int capped = 0;
    int nonFinite = 0;

    SolverCounts& operator+=(const SolverCounts& other) {
        capped += other.capped;
        nonFinite += other.nonFinite;
        return *this;
    }
};

/// Below this many bodies a loop stays on one thread.
inline constexpr int leastBodies = 256;

/// Runs range(begin, end) → SolverCounts over parts of [0, count) on the workers and returns the sum.
template <typename OfRange>
SolverCounts CountRanges(TaskPool& pool, size_t count, OfRange&& range) {
    if (count == 0) return {};
    SolverCounts parts[maxWorkers];
    pool.For(static_cast<int>(count), leastBodies,
             [&](int begin, int end, int worker) { parts[worker] += range(begin, end); });
    SolverCounts sum;
    for (const SolverCounts& part : parts) sum += part;
    return sum;
}
/// Runs body(index) → SolverCounts over [0, count) on the workers and returns the sum.
template <typename Body>
SolverCounts CountOver(TaskPool& pool, size_t count, Body&& body) {
    return CountRanges(pool, count, [&](int begin, int end) {
        SolverCounts sum;
        for (int i = begin; i < end; ++i) sum += body(ToSize(i));
        return sum;
    });
}
/// The same without counting.
template <typename Body>
void ForEachOf(TaskPool& pool, size_t count, Body&& body) {
    pool.For(static_cast<int>(count), leastBodies, [&](int begin, int end, int) {
        for (int i = begin; i < end; ++i) body(ToSize(i));
    });
}

/// Calls visit(forces, limit) with two std::bool_constant: what the loops over bodies must contain.
template <typename Visit>
decltype(auto) WithBodyKernel(const KernelSet& kernels, Visit&& visit) {
    constexpr KernelSet compiled = ChooseKernels(compiledFeatures);
    const auto withLimit = [&](auto forces) -> decltype(auto) {
        if constexpr (compiled.speedLimit) {
            if (kernels.speedLimit) return visit(forces, std::true_type{});
        }
        return visit(forces, std::false_type{});
    };
    if constexpr (compiled.bodyForces) {
        if (kernels.bodyForces) return withLimit(std::true_type{});
    }
    return withLimit(std::false_type{});
}

struct SolverTables {
    TaskPool& pool;
    BodyTable& bodies;
    ContactTable& contacts;
    JointTable& joints;
    bool isRest = false;      ///< the rest of a step after a time of impact
    bool noteDemand = false;  ///< the soft step notes pull rates in BodyTable::demand
};

/// Makes the rows that keep what rolls, before several threads ask for some of them.
inline void MakeRollingRows(const SolverSettings& settings, ContactTable& contacts) {
    if (settings.kernels.rolling) EnsureRows(contacts.rolling, contacts.flags.size());
}
/// Rolling rows of a list of contacts, after MakeRollingRows; none without the feature.
inline void PrepareRolling(const SolverSettings& settings, const FixtureTable& fixtures,
                           std::span<const ContactIndex> list, float impulseScale, SolverTables tables,
                           RollingRows& rows) {
    rows.Clear();
    if (!settings.kernels.rolling) return;
    rows.Prepare({tables.bodies, fixtures, tables.contacts, list, impulseScale, settings.lengthScale});
}

}  // namespace scree
