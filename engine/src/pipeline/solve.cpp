// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sequential impulses are solved by islands. The soft step solves everything at once. It needs islands where each has
// its own number of sub-steps; else it asks who wakes, and who may fall asleep together.

#include "pipeline/solve.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/rouse.h"
#include "pipeline/solve_islands.h"
#include "pipeline/solve_soft.h"

namespace scree {

namespace {

/// Sequential impulses add to angles without their rests, which are therefore to be 0.
void ClearAngleRests(BodyTable& bodies, SolverScratch& scratch) {
    if (!scratch.anglesHaveRests) return;
    for (const BodyIndex body : bodies.movers) bodies.position[body].aRest = 0.0f;
    scratch.anglesHaveRests = false;
}

/// After SolveSoft: sleep timers go on, and the islands that were listed may fall asleep.
void SleepIslands(const SolverSettings& settings, TaskPool& pool, const IslandTable& active, const IslandTable& islands,
                  BodyTable& bodies) {
    constexpr size_t leastToShare = 512;
    if (!settings.allowSleep) return;
    pool.ForIfWide(static_cast<int>(active.bodies.size()), static_cast<int>(leastToShare),
                   [&](int begin, int end, int /*worker*/) {
                       for (const BodyIndex body : Range(active.bodies, begin, end))
                           UpdateSleepTimer(bodies, body, settings);
                   });
    const auto isRested = [&](BodyIndex body) { return bodies.sleepTime[body] >= timeToSleep; };
    const auto count = static_cast<int>(islands.islands.size());
    const int least = islands.bodies.size() >= leastToShare ? 2 : count + 1;
    pool.ForIfWide(count, least, [&](int begin, int end, int /*worker*/) {
        for (int i = begin; i < end; ++i) {
            const std::span<const BodyIndex> island = Bodies(islands, islands.islands[ToSize(i)]);
            if (!std::ranges::all_of(island, isRested)) continue;
            for (const BodyIndex body : island) bodies.PutToSleep(body);
        }
    });
}

/// One group after the other; without a tolerance all that is active is the one group.
void SolveGroups(const SolverSettings& settings, const FixtureTable& fixtures, SolveLists lists,
                 const ContactEvents& events, SolverTables tables, SolverScratch& scratch, SolveReport& report) {
    tables.noteDemand = settings.tolerance != nullptr;
    const auto solve = [&](const SolverSettings& own, const IslandTable& group) {
        report.substeps = own.substeps;  // groups come with rising numbers
        report.bodySubsteps += static_cast<int64_t>(group.bodies.size() + group.isolated.size()) * own.substeps;
        report.counts += SolveSoft(own, fixtures, group, events, tables, scratch);
    };
    if (settings.tolerance == nullptr) return solve(settings, lists.active);
    SolverSettings own = settings;
    for (const SubstepGroup& group : lists.groups.Get()) {
        own.substeps = group.substeps;
        solve(own, group.lists);
    }
}

}  // namespace

void GatherLists(const SolverSettings& settings, TaskPool& pool, ContactTable& contacts, JointTable& joints,
                 BodyTable& bodies, IslandScratch& scratch, IsolatedPath path, SolveLists lists) {
    lists.groups.Clear();
    RouseContacts(bodies, contacts);
    if (settings.substeps == 0) {
        lists.active.Clear();
        FindIslands(contacts, joints, pool, bodies, scratch, lists.islands, path);
        RouseContacts(bodies, contacts);
        return;
    }
    const Tolerance* tolerance = settings.tolerance;
    if (tolerance != nullptr) {
        FindIslands(contacts, joints, pool, bodies, scratch, lists.islands, path);
    } else {
        WakeReached(contacts, joints, pool, bodies, scratch.sleepy);
    }
    RouseContacts(bodies, contacts);
    GatherActive(contacts, joints, pool, bodies, scratch, lists.active, path);
    if (tolerance == nullptr) {
        lists.islands.Clear();
        if (!settings.allowSleep) return;
        FindSleepyIslands(lists.active, contacts, joints, pool, bodies, settings.dt, scratch.sleepy, lists.islands);
        return;
    }
    GroupBySubsteps({lists.islands, lists.active, contacts, joints, *tolerance, settings.Slop(), settings.dt}, bodies,
                    lists.groups);
}

const IslandTable& SolvedOf(const SolverSettings& settings, SolveLists lists) {
    return settings.substeps > 0 ? lists.active : lists.islands;
}

SolveReport Solve(const SolverSettings& settings, const FixtureTable& fixtures, SolveLists lists,
                  const ContactEvents& events, SolverTables tables, SolverScratch& scratch) {
    SolveReport report{.substeps = settings.substeps};
    MakeRollingRows(settings, tables.contacts);
    if (settings.substeps > 0) {
        scratch.anglesHaveRests = true;
        scratch.startVelocities.Forget();
        SolveGroups(settings, fixtures, lists, events, tables, scratch, report);
        SleepIslands(settings, tables.pool, lists.active, lists.islands, tables.bodies);
    } else {
        ClearAngleRests(tables.bodies, scratch);
        report.counts = SolveIslands(settings, fixtures, lists.islands, events, tables, scratch);
    }
    const IslandTable& solved = SolvedOf(settings, lists);
    report.islandCount = static_cast<int>(lists.islands.islands.size());
    report.isolatedCount = static_cast<int>(solved.isolated.size());
    report.awakeCount = report.isolatedCount + static_cast<int>(solved.bodies.size());
    return report;
}

namespace {

/// Visits the impulses of a row, known by their names, and by `ofOther` whatever is a number.
template <typename OfImpulse, typename OfOther>
struct VisitImpulses {
    OfImpulse ofImpulse;
    OfOther ofOther;

    void Note(float& impulse) { ofImpulse(impulse); }
    void Note(Vec2& impulse) { ofImpulse(impulse.x), ofImpulse(impulse.y); }
    void Visit(float& value) { ofOther(value); }
    void Visit(Vec2& value) { ofOther(value.x), ofOther(value.y); }
    template <typename T>
    void Visit(T& value) {
        if constexpr (std::is_array_v<T>) {
            for (auto& element : value) Visit(element);
        } else if constexpr (std::is_class_v<T>) {
            if constexpr (requires { value.impulse; }) Note(value.impulse);
            if constexpr (requires { value.turnImpulse; }) Note(value.turnImpulse);
            if constexpr (requires { value.springImpulse; }) Note(value.springImpulse);
            if constexpr (requires { value.lowerImpulse; }) Note(value.lowerImpulse), Note(value.upperImpulse);
            T::Fields(value, *this);
        }
    }
    template <typename... T>
    void operator()(T&... values) {
        (Visit(values), ...);
    }
    template <typename... T>
    void LeftOut(T&... values) {
        (Visit(values), ...);
    }
};

template <typename OfImpulse, typename OfOther>
void VisitRow(JointTable& joints, JointIndex joint, OfImpulse ofImpulse, OfOther ofOther) {
    VisitImpulses<OfImpulse, OfOther> visitor{ofImpulse, ofOther};
    const JointInfo& info = joints.info[joint];
    JointTable::WithStore(joints, info.type, [&](auto& store) { visitor.Visit(store.rows[info.row]); });
}

/// Calls visit(impulse) for all of these joints, in order.
template <typename Visit>
void ForEachImpulse(JointTable& joints, std::span<const JointIndex> of, Visit&& visit) {
    for (const JointIndex joint : of)
        VisitRow(
            joints, joint, [&](float& impulse) { visit(impulse); }, [](float&) {});
}

}  // namespace

SolverCounts SolveRest(const SolverSettings& settings, float dt, const FixtureTable& fixtures, const IslandTable& lists,
                       const ContactEvents& events, SolverTables tables, SolverScratch& scratch) {
    SolverSettings own = settings;
    const float share = dt / settings.dt;
    own.dt = dt;
    own.substeps = std::max(1, static_cast<int>(std::lround(share * static_cast<float>(settings.substeps))));
    own.impulseScale = settings.impulseScale > 0.0f ? share : 0.0f;
    tables.isRest = true;
    scratch.ofJoints.clear();
    ForEachImpulse(tables.joints, lists.joints, [&](float impulse) { scratch.ofJoints.push_back(impulse); });
    const SolverCounts counts = SolveSoft(own, fixtures, lists, events, tables, scratch);
    // What joints did up to here is part of what they do in the step.
    size_t next = 0;
    ForEachImpulse(tables.joints, lists.joints, [&](float& impulse) {
        const float before = scratch.ofJoints[next++];
        if (std::isfinite(before)) impulse += (1.0f - share) * before;
    });
    // Impulses are to be those of a whole step; of a very short rest they are those of a blow.
    const float whole = Min(1.0f / share, static_cast<float>(2 * settings.substeps) / static_cast<float>(own.substeps));
    for (const ContactIndex contact : lists.contacts) {
        for (ManifoldPoint& point : tables.contacts.manifold[contact].points)
            point.normalImpulse *= whole, point.tangentImpulse *= whole;
    }
    return counts;
}

namespace {

void Forget(bool always, float& impulse) {
    if (always || !std::isfinite(impulse)) impulse = 0.0f;
}

/// A gear pushes the bodies of its joints, too.
bool IsOfLost(const BodyTable& bodies, const JointTable& joints, const JointInfo& joint) {
    if (joint.type == e_gearJoint) {
        for (const GearSide& side : joints.Store<GearRow>().rows[joint.row].side)
            if (bodies.Has(side.against, BodyFlag::lost)) return true;
    }
    return bodies.Has(joint.bodyA, BodyFlag::lost) || bodies.Has(joint.bodyB, BodyFlag::lost);
}

}  // namespace

void ForgetLost(BodyTable& bodies, ContactTable& contacts, JointTable& joints) {
    for (const ContactIndex contact : contacts.flags.Rows()) {
        if (!contacts.IsAlive(contact)) continue;
        const ContactPair& pair = contacts.pair[contact];
        const bool all = bodies.Has(pair.bodyA, BodyFlag::lost) || bodies.Has(pair.bodyB, BodyFlag::lost);
        for (ManifoldPoint& point : contacts.manifold[contact].points)
            Forget(all, point.normalImpulse), Forget(all, point.tangentImpulse);
        if (contact < contacts.rolling.End()) Forget(all, contacts.rolling[contact]);
    }
    for (const JointIndex joint : joints.info.Rows()) {
        if (!joints.slots.IsAlive(joint)) continue;
        const bool all = IsOfLost(bodies, joints, joints.info[joint]);
        VisitRow(
            joints, joint, [&](float& impulse) { Forget(all, impulse); },
            [](float& value) {
                if (std::isnan(value)) value = 0.0f;  // bounds may be infinite
            });
    }
    for (uint16_t& flags : bodies.flags) flags = static_cast<uint16_t>(flags & ~BodyFlag::lost);
}

}  // namespace scree
