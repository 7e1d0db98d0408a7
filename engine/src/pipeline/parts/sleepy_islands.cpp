// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands as sets that are joined, contact by contact, on all workers.

#include "pipeline/parts/sleepy_islands.h"

#include <algorithm>
#include <array>

#include "base/gather_parts.h"
#include "base/shared_count.h"
#include "pipeline/parts/solved_rows.h"

namespace scree {

namespace {

bool IsMover(const BodyTable& bodies, BodyIndex body) { return bodies.type[body] != staticBody; }

/// One of two movers wakes the other.
bool Wakes(const BodyTable& bodies, BodyIndex a, BodyIndex b) {
    return IsMover(bodies, a) && IsMover(bodies, b) && bodies.IsActive(a) != bodies.IsActive(b);
}

/// Calls visit(joint) for joints of listed movers, and perhaps others.
template <typename Visit>
void ForEachListedJoint(const JointTable& joints, const BodyTable& bodies, Visit&& visit) {
    if (!AreFewListed(joints, bodies)) {
        for (JointIndex joint = joints.listHead; IsSome(joint); joint = joints.info[joint].listNext) visit(joint);
        return;
    }
    for (const BodyIndex body : bodies.Listed()) {
        if (bodies.info[body].jointCount == 0) continue;
        for (const JointIndex joint : joints.OfBody(body)) visit(joint);
    }
}

bool DoesSomebodySleep(TaskPool& pool, const BodyTable& bodies) {
    if (!bodies.AreAllListed()) return true;
    const std::span<const BodyIndex> listed = bodies.Listed();
    return !AllOf(pool, static_cast<int>(listed.size()), leastRowsToShare, [&](int begin, int end) {
        return std::ranges::all_of(listed.subspan(ToSize(begin), ToSize(end - begin)),
                                   [&](BodyIndex body) { return bodies.IsActive(body); });
    });
}

}  // namespace

void WakeReached(ContactTable& contacts, const JointTable& joints, TaskPool& pool, BodyTable& bodies,
                 SleepyScratch& s) {
    if (!DoesSomebodySleep(pool, bodies)) return;
    s.woken.clear();
    const auto meet = [&](BodyIndex a, BodyIndex b) {
        if (!Wakes(bodies, a, b)) return;
        const BodyIndex sleeper = bodies.IsActive(a) ? b : a;
        s.woken.push_back(sleeper);
    };
    GatherSolved(contacts, pool, s.rows, [&](ContactIndex contact) {
        return Wakes(bodies, contacts.pair[contact].bodyA, contacts.pair[contact].bodyB);
    });
    for (const ContactIndex row : s.rows) meet(contacts.pair[row].bodyA, contacts.pair[row].bodyB);
    const auto meetBy = [&](JointIndex joint) {
        const JointInfo& info = joints.info[joint];
        if (IsSolved(info, bodies)) meet(info.bodyA, info.bodyB);
    };
    ForEachListedJoint(joints, bodies, meetBy);
    while (!s.woken.empty()) {
        const BodyIndex body = s.woken.back();
        s.woken.pop_back();
        if (bodies.IsActive(body)) continue;
        bodies.WakeReached(body);
        for (const ContactIndex row : contacts.OfBody(body)) {
            if (IsSolved(contacts.flags[row])) meet(contacts.pair[row].bodyA, contacts.pair[row].bodyB);
        }
        for (const JointIndex joint : joints.OfBody(body)) meetBy(joint);
    }
}

void FindSleepyIslands(const IslandTable& active, const ContactTable& contacts, const JointTable& joints,
                       TaskPool& pool, const BodyTable& bodies, float dt, SleepyScratch& s, IslandTable& islands) {
    islands.Clear();
    const auto isSleepy = [&](BodyIndex body) { return bodies.sleepTime[body] + dt >= timeToSleep; };
    const auto gather = [&](std::span<const BodyIndex> from, std::vector<BodyIndex>& to, auto&& keep) {
        GatherParts<BodyIndex, 1>(
            pool, static_cast<int>(from.size()), leastRowsToShare, {&to},
            [&](int begin, int end, const std::array<BodyIndex*, 1>& places) {
                const auto part = from.subspan(ToSize(begin), ToSize(end - begin));
                return std::array{static_cast<size_t>(std::ranges::copy_if(part, places[0], keep).out - places[0])};
            });
    };
    const auto forAll = [&](auto count, auto&& visit) {
        pool.For(static_cast<int>(count), leastRowsToShare, [&](int begin, int end, int /*worker*/) {
            for (auto i = ToSize(begin); i < ToSize(end); ++i) visit(i);
        });
    };
    const std::span<const BodyIndex> awake = active.bodies;
    const bool isNobody = AllOf(pool, static_cast<int>(awake.size()), leastRowsToShare, [&](int begin, int end) {
        return std::ranges::none_of(awake.subspan(ToSize(begin), ToSize(end - begin)), isSleepy);
    });
    if (isNobody) return;
    gather(awake, s.sleepy, isSleepy);
    const size_t rows = ToSize(bodies.slots.Size());
    s.sets.Reserve(rows);
    EnsureRows(s.isKept, rows), EnsureRows(s.isSetKept, rows);
    forAll(s.sleepy.size(), [&](size_t i) {
        const BodyIndex body = s.sleepy[i];
        s.sets.Begin(body);
        s.isKept[body] = s.isSetKept[body] = 0;
    });
    const auto connect = [&](BodyIndex a, BodyIndex b) {
        if (!IsMover(bodies, a) || !IsMover(bodies, b)) return;
        const bool isSleepyA = isSleepy(a), isSleepyB = isSleepy(b);
        if (isSleepyA && isSleepyB) {
            s.sets.Join(a, b);
        } else if (isSleepyA || isSleepyB) {
            SetSharedBits(s.isKept[isSleepyA ? a : b], 1);
        }
    };
    forAll(active.contacts.size(), [&](size_t i) {
        const ContactPair& pair = contacts.pair[active.contacts[i]];
        connect(pair.bodyA, pair.bodyB);
    });
    forAll(active.joints.size(), [&](size_t i) {
        const JointInfo& joint = joints.info[active.joints[i]];
        connect(joint.bodyA, joint.bodyB);
    });
    forAll(s.sleepy.size(), [&](size_t i) {
        if (s.isKept[s.sleepy[i]] != 0) SetSharedBits(s.isSetKept[s.sets.Find(s.sleepy[i])], 1);
    });
    gather(s.sleepy, islands.bodies, [&](BodyIndex body) { return s.isSetKept[s.sets.Find(body)] == 0; });
    std::ranges::stable_sort(islands.bodies, {}, [&](BodyIndex body) { return s.sets.Find(body); });
    for (size_t begin = 0, end = 0; begin < islands.bodies.size(); begin = end) {
        const BodyIndex first = s.sets.Find(islands.bodies[begin]);
        while (end < islands.bodies.size() && s.sets.Find(islands.bodies[end]) == first) ++end;
        Island& island = islands.islands.emplace_back();
        island = {};
        island.bodyBegin = static_cast<int>(begin), island.bodyEnd = static_cast<int>(end);
    }
}

}  // namespace scree
