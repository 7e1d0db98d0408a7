// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A group takes as long as its largest island. Smaller ones fill up the lanes beside it.

#include "pipeline/parts/lane_solver.h"

#include <algorithm>
#include <utility>

#include "base/compiler.h"
#include "pipeline/parts/body_motion.h"
#include "pipeline/parts/integrate.h"

namespace scree {

namespace {

/// Islands by their number of contacts: a counting sort, from which they are taken.
class IslandsBySize {
public:
    /// Of the islands that are chosen.
    IslandsBySize(const std::vector<Island>& islands, const std::vector<uint8_t>& isChosen, std::vector<int>& sorted)
        : m_sorted(sorted) {
        for (size_t i = 0; i < islands.size(); ++i) {
            if (isChosen[i] != 0) ++m_end[CountContacts(islands[i])];
        }
        int count = 0;
        for (int size = 0; size < mostLaneContacts; ++size) {
            m_begin[size] = count;
            count += std::exchange(m_end[size], count);
        }
        sorted.resize(ToSize(count));
        for (size_t i = 0; i < islands.size(); ++i) {
            if (isChosen[i] != 0) sorted[ToSize(m_end[CountContacts(islands[i])]++)] = static_cast<int>(i);
        }
    }

    /// The largest number of contacts of an island that has at most so many; 0: there is none.
    [[nodiscard]] int GetLargest(int most) {
        while (m_largest > 0 && IsEmpty(m_largest)) --m_largest;
        int size = std::min(most, m_largest);
        while (size > 0 && IsEmpty(size)) --size;
        return size;
    }
    /// One that has so many.
    int Take(int size) { return m_sorted[ToSize(m_begin[size]++)]; }

private:
    [[nodiscard]] bool IsEmpty(int size) const { return m_begin[size] == m_end[size]; }

    const std::vector<int>& m_sorted;
    int m_begin[mostLaneContacts] = {}, m_end[mostLaneContacts] = {};
    int m_largest = mostLaneContacts - 1;
};

}  // namespace

LaneSolver::LaneSolver(const SolverSettings& settings, const IslandTable& islands, const ContactEvents& events,
                       SolverTables tables, SolverScratch& scratch)
    : m_settings(settings), m_islands(islands), m_tables(tables), m_s(scratch) {
    m_s.lanes.places.clear();
    m_s.lanes.groups.clear();
    m_s.lanes.isChosen.assign(islands.islands.size(), 0);
    // What is rare is solved one by one. So are islands whose listener may change those that follow.
    const KernelSet& kernels = settings.kernels;
    if (kernels.locks || kernels.rolling || tables.bodies.IsFar() || events.HearsPostSolve()) return;
    Choose();
    if (CountGroups() > 0) m_s.lanes.slotOf.resize(ToSize(tables.bodies.slots.Size()));
}

/// Islands with joints are left out.
bool LaneSolver::Fits(const Island& island) {
    const int contacts = CountContacts(island);
    if (contacts == 0 || contacts >= mostLaneContacts || IsWide(island)) return false;
    return island.jointBegin == island.jointEnd;
}

void LaneSolver::Choose() {
    LaneScratch& s = m_s.lanes;
    const std::vector<Island>& islands = m_islands.islands;
    for (size_t i = 0; i < islands.size(); ++i) s.isChosen[i] = Fits(islands[i]) ? 1 : 0;
    IslandsBySize rest(islands, s.isChosen, s.bySize);
    while (const int height = rest.GetLargest(mostLaneContacts)) {
        const auto begin = static_cast<int>(s.places.size());
        int contacts = 0;
        for (int lane = 0; lane < islandLanes; ++lane) {
            int first = 0;
            while (const int size = rest.GetLargest(height - first)) {
                s.places.push_back({rest.Take(size), lane, first});
                first += size;
            }
            contacts += first;
        }
        if (contacts * costOfOne >= height * costOfLanes) {
            s.groups.push_back({begin, static_cast<int>(s.places.size())});
            continue;
        }
        for (const LaneScratch::Place& place : Places(s.places).subspan(ToSize(begin))) {
            s.isChosen[ToSize(place.island)] = 0;
        }
        s.places.resize(ToSize(begin));
    }
}

SolverCounts LaneSolver::Solve(const FixtureTable& fixtures, int begin, int end, int worker) {
    SolverCounts counts;
    for (size_t g = ToSize(begin); g < ToSize(end); ++g) {
        FetchAhead(fixtures, GroupOf(g + 1), GroupOf(g + 2));
        counts += SolveGroup(fixtures, GroupOf(g), worker);
    }
    return counts;
}

int LaneSolver::CostOf(int group) const {
    return costOfLanes * CountContacts(IslandOf(GroupOf(ToSize(group)).front().island));
}

int64_t LaneSolver::Spread(int64_t rest, int workers, std::vector<LoneIsland>& lone) {
    std::vector<LaneScratch::Group>& groups = m_s.lanes.groups;
    int given = 0;
    for (; given < CountGroups(); ++given) {  // the tallest first
        const Places group = GroupOf(ToSize(given));
        int64_t apart = 0;
        for (const LaneScratch::Place& place : group) apart += scree::CostOf(IslandOf(place.island));
        const int64_t together = CostOf(given);
        if (together * workers <= std::max(rest, rest - together + apart)) break;
        rest += apart - together;
        for (const LaneScratch::Place& place : group)
            lone.push_back({place.island, -1, CountContacts(IslandOf(place.island))});
    }
    groups.erase(groups.begin(), groups.begin() + given);
    return rest;
}

LaneSolver::Places LaneSolver::GroupOf(size_t number) const {
    const LaneScratch& s = m_s.lanes;
    if (number >= s.groups.size()) return {};
    const auto [begin, end] = s.groups[number];
    return Places(s.places).subspan(ToSize(begin), ToSize(end - begin));
}

/// Contacts of an island are in memory anywhere. Where their shapes are, their pairs tell.
void LaneSolver::FetchAhead(const FixtureTable& fixtures, Places next, Places later) const {
    const ContactTable& table = m_tables.contacts;
    for (const LaneScratch::Place& place : later) {
        for (const ContactIndex contact : Contacts(m_islands, IslandOf(place.island))) Prefetch(&table.pair[contact]);
    }
    for (const LaneScratch::Place& place : next) {
        for (const ContactIndex contact : Contacts(m_islands, IslandOf(place.island))) {
            Prefetch(fixtures.shape[table.pair[contact].fixtureA]);
            Prefetch(fixtures.shape[table.pair[contact].fixtureB]);
            Prefetch(&table.material[contact]);
            PrefetchToWrite(&table.manifold[contact]);
        }
    }
}

SolverCounts LaneSolver::SolveGroup(const FixtureTable& fixtures, Places group, int worker) {
    BodyTable& bodies = m_tables.bodies;
    IslandLanes& lanes = m_s.lanes.workers[ToSize(worker)].lanes;
    std::vector<IslandLanes::Member>& all = m_s.lanes.workers[ToSize(worker)].members;
    all.clear();
    for (const LaneScratch::Place& place : group) {
        const Island& island = IslandOf(place.island);
        all.push_back({Bodies(m_islands, island), Contacts(m_islands, island), place.lane, place.first});
    }
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
    for (const IslandLanes::Member& member : all) {
        for (const BodyIndex b : member.bodies) {
            if (bodies.type[b] != dynamicBody) counts.nonFinite += FinishPose(bodies, b) ? 1 : 0;
        }
    }
    lanes.ForEachRotation(bodies, [&](BodyIndex b, Rot q) { counts.nonFinite += FinishPose(bodies, b, q) ? 1 : 0; });
    if (!m_settings.allowSleep) return counts;
    for (size_t i = 0; i < all.size(); ++i) SleepIsland(bodies, all[i].bodies, m_settings, lanes.IsSolved(i));
    return counts;
}

}  // namespace scree
