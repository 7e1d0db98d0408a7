// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands of like size share a group, since a group takes as long as its largest member.

#include "pipeline/parts/lane_solver.h"

#include <algorithm>
#include <utility>

#include "base/compiler.h"
#include "base/sin_cos_terms.h"
#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/integrate.h"

namespace scree {

LaneSolver::LaneSolver(const SolverSettings& settings, const IslandTable& islands, const ContactEvents& events,
                       SolverTables tables, SolverScratch& scratch)
    : m_settings(settings), m_islands(islands), m_tables(tables), m_s(scratch) {
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
        if (!Fits(islands[i])) continue;
        m_s.lanes.isChosen[i] = 1;
        ++start[CountContacts(islands[i])];
    }
    int fitting = 0;
    for (int count = leastWideContacts - 1; count >= 0; --count) fitting += std::exchange(start[count], fitting);
    order.resize(ToSize(fitting));
    for (size_t i = 0; i < islands.size(); ++i) {
        if (Has(i)) order[ToSize(start[CountContacts(islands[i])]++)] = static_cast<int>(i);
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
    s.slotOf.resize(ToSize(m_tables.bodies.slots.Size()));
    SolverCounts counts[maxWorkers];
    const auto groups = static_cast<int>((s.order.size() + islandLanes - 1) / islandLanes);
    m_tables.pool.For(groups, leastGroups, [&](int begin, int end, int worker) {
        for (int g = begin; g < end; ++g) {
            FetchAhead(fixtures, GroupOf(g + 1), GroupOf(g + 2));
            counts[worker] += SolveGroup(fixtures, GroupOf(g), s.groups[worker]);
        }
    });
    SolverCounts sum;
    for (const SolverCounts& part : counts) sum += part;
    return sum;
}

std::span<const int> LaneSolver::GroupOf(int number) const {
    const std::vector<int>& order = m_s.lanes.order;
    const size_t first = std::min(ToSize(number) * islandLanes, order.size());
    return {order.data() + first, std::min<size_t>(islandLanes, order.size() - first)};
}

/// Contacts of an island are in memory anywhere. Where their shapes are, their pairs tell.
void LaneSolver::FetchAhead(const FixtureTable& fixtures, std::span<const int> next, std::span<const int> later) const {
    const ContactTable& table = m_tables.contacts;
    for (const int island : later) {
        for (const ContactIndex contact : Contacts(m_islands, IslandOf(island))) Prefetch(&table.pair[contact]);
    }
    for (const int island : next) {
        for (const ContactIndex contact : Contacts(m_islands, IslandOf(island))) {
            Prefetch(fixtures.shape[table.pair[contact].fixtureA]);
            Prefetch(fixtures.shape[table.pair[contact].fixtureB]);
            Prefetch(&table.material[contact]);
            PrefetchToWrite(&table.manifold[contact]);
        }
    }
}

SolverCounts LaneSolver::SolveGroup(const FixtureTable& fixtures, std::span<const int> group, IslandLanes& lanes) {
    BodyTable& bodies = m_tables.bodies;
    IslandLanes::Member members[islandLanes];
    for (size_t lane = 0; lane < group.size(); ++lane) {
        const Island& island = IslandOf(group[lane]);
        members[lane] = {Bodies(m_islands, island), Contacts(m_islands, island)};
    }
    const std::span<const IslandLanes::Member> all{members, group.size()};
    WithBodyKernel(m_settings.kernels, [&](auto forces, auto) {
        for (const IslandLanes::Member& member : all) {
            for (const BodyIndex b : member.bodies) IntegrateVelocity<forces>(m_settings, bodies, b);
        }
    });
    lanes.Prepare({bodies, fixtures, m_tables.contacts, m_settings.impulseScale, m_settings.kernels.restitution}, all,
                  m_s.lanes.slotOf);
    lanes.SolveVelocities(m_settings.velocityIterations, m_settings.impulseScale > 0.0f, m_settings.kernels.friction,
                          bodies);
    lanes.StoreImpulses(m_tables.contacts.manifold);
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
        for (const BodyIndex b : members[lane].bodies) {
            if (bodies.type[b] != dynamicBody) counts.nonFinite += FinishPose(bodies, b) ? 1 : 0;
        }
    }
    lanes.ForEachRotation(bodies, [&](BodyIndex b, Rot q) { counts.nonFinite += FinishPose(bodies, b, q) ? 1 : 0; });
    if (!m_settings.allowSleep) return counts;
    for (size_t lane = 0; lane < group.size(); ++lane) {
        SleepIsland(bodies, members[lane].bodies, m_settings, lanes.IsSolved(lane));
    }
    return counts;
}

}  // namespace scree
