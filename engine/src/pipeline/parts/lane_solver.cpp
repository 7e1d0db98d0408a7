// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands of like size share a group, since a group takes as long as its largest member.

#include "pipeline/parts/lane_solver.h"

#include <algorithm>
#include <utility>

#include "base/sin_cos_terms.h"
#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/integrate.h"

namespace scree {

LaneSolver::LaneSolver(const SolverSettings& settings, const IslandTable& islands, const ContactEvents& events,
                       SolverTables tables, SolverScratch& scratch)
    : m_settings(settings), m_islands(islands), m_tables(tables), m_s(scratch) {
    m_s.lanes.members.clear();
    m_s.lanes.order.clear();
    m_s.lanes.isChosen.assign(islands.islands.size(), 0);
    // What is rare is solved one by one. So are islands whose listener may change those that follow.
    const KernelSet& kernels = settings.kernels;
    if (kernels.locks || kernels.rolling || tables.bodies.IsFar() || events.HearsPostSolve()) return;
    Choose();
}

/// Joints and angles that the kernels cannot turn are left out.
bool LaneSolver::Fits(const Island& island) const {
    constexpr float mostAngle = 0.1f * sin_cos::largestDirect;
    if (CountContacts(island) == 0 || IsWide(island) || island.jointBegin != island.jointEnd) return false;
    const auto turnsLittle = [this](BodyIndex body) { return Abs(m_tables.bodies.position[body].a) < mostAngle; };
    for (const ContactIndex contact : Contacts(m_islands, island)) {
        const ContactPair& pair = m_tables.contacts.pair[contact];
        if (!turnsLittle(pair.bodyA) || !turnsLittle(pair.bodyB)) return false;
    }
    return true;
}

void LaneSolver::Choose() {
    // A step of the vector kernels takes as long as so many of the others.
    constexpr int stepsOfOne = 2;
    std::vector<int>& order = m_s.lanes.order;
    const std::vector<Island>& islands = m_islands.islands;
    const auto countOf = [&](int island) { return CountContacts(islands[ToSize(island)]); };
    // Counting sort, the largest first.
    int start[leastWideContacts] = {};
    for (size_t i = 0; i < islands.size(); ++i) {
        m_s.lanes.isChosen[i] = Fits(islands[i]) ? 1 : 0;
        if (m_s.lanes.isChosen[i] != 0) ++start[CountContacts(islands[i])];
    }
    int fitting = 0;
    for (int count = leastWideContacts - 1; count >= 0; --count) fitting += std::exchange(start[count], fitting);
    order.resize(ToSize(fitting));
    for (size_t i = 0; i < islands.size(); ++i) {
        if (m_s.lanes.isChosen[i] != 0) order[ToSize(start[CountContacts(islands[i])]++)] = static_cast<int>(i);
    }
    // A group is worth it if its members have enough contacts beside those of the largest.
    size_t kept = 0;
    for (size_t begin = 0; begin < order.size(); begin += islandLanes) {
        const size_t end = std::min(begin + islandLanes, order.size());
        int contacts = 0;
        for (size_t i = begin; i < end; ++i) contacts += countOf(order[i]);
        const bool isWorthIt = contacts >= stepsOfOne * countOf(order[begin]);
        for (size_t i = begin; i < end; ++i) {
            m_s.lanes.isChosen[ToSize(order[i])] = isWorthIt ? 1 : 0;
            if (isWorthIt) order[kept++] = order[i];
        }
    }
    order.resize(kept);
}

SolverCounts LaneSolver::Solve(const FixtureTable& fixtures) {
    constexpr int leastGroups = 8;
    LaneScratch& s = m_s.lanes;
    if (s.order.empty()) return {};
    Prepare(fixtures);
    SolverCounts counts[maxWorkers];
    const auto groups = static_cast<int>((s.order.size() + islandLanes - 1) / islandLanes);
    m_tables.pool.For(groups, leastGroups, [&](int begin, int end, int worker) {
        for (int g = begin; g < end; ++g) {
            const size_t first = ToSize(g) * islandLanes;
            const std::span<const int> group{s.order.data() + first,
                                             std::min<size_t>(islandLanes, s.order.size() - first)};
            counts[worker] += SolveGroup(group, s.groups[worker]);
        }
    });
    StoreContactImpulses(s.rows, m_tables.contacts.manifold);
    Sleep();
    SolverCounts sum;
    for (const SolverCounts& part : counts) sum += part;
    return sum;
}

/// Rows of all members, in the order of the islands.
void LaneSolver::Prepare(const FixtureTable& fixtures) {
    LaneScratch& s = m_s.lanes;
    s.contacts.clear();
    s.bodies.clear();
    s.memberOf.resize(m_islands.islands.size());
    s.slotOf.resize(ToSize(m_tables.bodies.slots.Size()));
    for (size_t i = 0; i < m_islands.islands.size(); ++i) {
        if (!Has(i)) continue;
        s.memberOf[i] = static_cast<int>(s.members.size());
        s.members.push_back({static_cast<int>(i), s.contacts.size(), false});
        const auto append = [](auto& to, auto from) { to.insert(to.end(), from.begin(), from.end()); };
        append(s.contacts, Contacts(m_islands, m_islands.islands[i]));
        append(s.bodies, Bodies(m_islands, m_islands.islands[i]));
    }
    WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
        ForEachOf(m_tables.pool, s.bodies.size(),
                  [&](size_t i) { IntegrateVelocity<forces>(m_settings, m_tables.bodies, s.bodies[i]); });
    });
    PrepareContacts({m_tables.bodies, fixtures, m_tables.contacts, s.contacts, m_settings.impulseScale,
                     m_settings.kernels.restitution},
                    m_tables.pool, s.rows);
}

SolverCounts LaneSolver::SolveGroup(std::span<const int> group, IslandLanes& lanes) {
    LaneScratch& s = m_s.lanes;
    BodyTable& bodies = m_tables.bodies;
    IslandLanes::Member members[islandLanes];
    for (size_t lane = 0; lane < group.size(); ++lane) {
        const Member& member = s.members[ToSize(s.memberOf[ToSize(group[lane])])];
        const auto count = ToSize(CountContacts(IslandOf(member)));
        members[lane] = {Bodies(m_islands, IslandOf(member)),
                         {s.rows.velocity.data() + member.firstRow, count},
                         {s.rows.position.data() + member.firstRow, count}};
    }
    const std::span<const IslandLanes::Member> all{members, group.size()};
    lanes.Gather(all, bodies, s.slotOf);
    lanes.SolveVelocities(m_settings.velocityIterations, m_settings.impulseScale > 0.0f, m_settings.kernels.friction,
                          bodies);
    SolverCounts counts;
    WithBodyKernel(m_settings.kernels, [&](auto, auto limit) {
        for (const IslandLanes::Member& member : all) {
            for (const BodyIndex b : member.bodies)
                counts.capped += IntegratePosition<limit>(m_settings, bodies, b) ? 1 : 0;
        }
    });
    lanes.SolvePositions(m_settings.positionIterations, ContactTolerance(m_settings),
                         {baumgarte, m_settings.lengthScale}, bodies);
    for (size_t lane = 0; lane < group.size(); ++lane) {
        s.members[ToSize(s.memberOf[ToSize(group[lane])])].isSolved = lanes.IsSolved(lane);
        for (const BodyIndex b : members[lane].bodies) {
            if (bodies.type[b] != dynamicBody) counts.nonFinite += FinishPose(bodies, b) ? 1 : 0;
        }
    }
    lanes.ForEachRotation(bodies, [&](BodyIndex b, Rot q) { counts.nonFinite += FinishPose(bodies, b, q) ? 1 : 0; });
    return counts;
}

void LaneSolver::Sleep() {
    if (!m_settings.allowSleep) return;
    for (const Member& member : m_s.lanes.members) {
        SleepIsland(m_tables.bodies, Bodies(m_islands, IslandOf(member)), m_settings, member.isSolved);
    }
}

}  // namespace scree
