// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sequential impulses for many small islands, side by side in the eight lanes of vectors (constraints/island_lanes.h).
// Bits are those of solving them one by one, so that it is free which islands are taken.

#pragma once

#include "pipeline/contact_events.h"
#include "pipeline/parts/solver.h"

namespace scree {

/// Islands with so many contacts and bodies are solved by the kernels of contact_blocks.h, contacts side by side. Each
/// island is judged by itself: what else is in the world must not change how one moves. An island that is alone takes a
/// half to a quarter of the time so. Where there are many of this size, lanes would be a tenth faster; of fifty
/// contacts, not. Few bodies with many contacts are compounds. Of n bodies at most n/2 pairs can stand side by side, so
/// that most places of a vector would stay empty.
inline constexpr int leastWideContacts = 32, leastWideBodies = 8;
/// Islands with so many contacts are in no group of lanes.
inline constexpr int mostLaneContacts = 128;

inline int CountContacts(const Island& island) { return island.contactEnd - island.contactBegin; }
inline bool IsWide(const Island& island) {
    return CountContacts(island) >= leastWideContacts && island.bodyEnd - island.bodyBegin >= leastWideBodies;
}

/// How long things take, in contacts that are solved side by side. In mixed, tiles and falling-circles such a contact
/// takes 0.1 to 0.16 µs. One of those that are solved one by one takes 0.45, a contact of each lane 1.1 to 1.8.
inline constexpr int costOfOne = 3, costOfLanes = 9;
/// Joints are solved one by one.
inline int CostOf(const Island& island) {
    const int joints = island.jointEnd - island.jointBegin;
    return CountContacts(island) * (IsWide(island) ? 1 : costOfOne) + joints * costOfOne;
}

class LaneSolver {
public:
    /// Chooses the islands.
    LaneSolver(const SolverSettings& settings, const IslandTable& islands, const ContactEvents& events,
               SolverTables tables, SolverScratch& scratch);

    /// The island with this number is one of those chosen.
    [[nodiscard]] bool Has(size_t island) const { return m_s.lanes.isChosen[island] != 0; }
    [[nodiscard]] int CountGroups() const { return static_cast<int>(m_s.lanes.groups.size()); }
    [[nodiscard]] int CostOf(int group) const;
    /// Gives up groups that would keep one worker busy for longer than so many workers need for everything: their
    /// islands take longer one by one, but each of them less. Appends these to `lone`, and returns what is left of
    /// `rest`, the cost of everything.
    int64_t Spread(int64_t rest, int workers, std::vector<LoneIsland>& lone);
    /// All of a step for the islands of the groups [begin, end), with the rows of `worker`.
    SolverCounts Solve(const FixtureTable& fixtures, int begin, int end, int worker);

private:
    using Places = std::span<const LaneScratch::Place>;

    void Choose();
    [[nodiscard]] static bool Fits(const Island& island);
    /// The islands of a group; none behind the last.
    [[nodiscard]] Places GroupOf(size_t number) const;
    void FetchAhead(const FixtureTable& fixtures, Places next, Places later) const;
    /// For the islands of one group: what that writes stays in the caches of a core.
    [[nodiscard]] SolverCounts SolveGroup(const FixtureTable& fixtures, Places group, int worker);
    [[nodiscard]] const Island& IslandOf(int island) const { return m_islands.islands[ToSize(island)]; }

    const SolverSettings& m_settings;
    const IslandTable& m_islands;
    SolverTables m_tables;
    SolverScratch& m_s;
};

}  // namespace scree
