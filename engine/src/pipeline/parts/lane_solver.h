// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sequential impulses for many small islands: eight side by side in the lanes of vectors (constraints/island_lanes.h).
// Bits are those of solving them one by one, so that it is free which islands are taken.

#pragma once

#include "pipeline/contact_events.h"
#include "pipeline/parts/solver.h"

namespace scree {

/// Islands with so many contacts are solved by the kernels of contact_blocks.h, contacts side by side. Each island is
/// judged by itself: what else is in the world must not change how one moves.
inline constexpr int leastWideContacts = 128;
inline int CountContacts(const Island& island) { return island.contactEnd - island.contactBegin; }
inline bool IsWide(const Island& island) { return CountContacts(island) >= leastWideContacts; }

class LaneSolver {
public:
    /// Chooses the islands.
    LaneSolver(const SolverSettings& settings, const IslandTable& islands, const ContactEvents& events,
               SolverTables tables, SolverScratch& scratch);

    /// The island with this number is one of those chosen.
    [[nodiscard]] bool Has(size_t island) const { return m_s.lanes.isChosen[island] != 0; }
    [[nodiscard]] SolverCounts Solve(const FixtureTable& fixtures);

private:
    using Member = LaneScratch::Member;

    void Choose();
    [[nodiscard]] bool Fits(const Island& island) const;
    void Prepare(const FixtureTable& fixtures);
    [[nodiscard]] SolverCounts SolveGroup(std::span<const int> group, IslandLanes& lanes);
    void Sleep();
    [[nodiscard]] const Island& IslandOf(const Member& member) const {
        return m_islands.islands[ToSize(member.island)];
    }

    const SolverSettings& m_settings;
    const IslandTable& m_islands;
    SolverTables m_tables;
    SolverScratch& m_s;
};

}  // namespace scree
