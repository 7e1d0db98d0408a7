// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Groups of bodies and of contacts, for the layers that colour by group: islands, and the colours in which a solver may
// work on contacts at the same time.

#pragma once

#include <vector>

#include "testbed/engines/snapshot.h"

namespace testbed {

/// For each body the smallest index of a body in its island; −1 for static and kinematic ones. Dynamic bodies are of
/// one island when touching contacts (sensors excepted) or joints connect them. O(bodies + contacts).
[[nodiscard]] std::vector<int> FindIslands(const Snapshot& snapshot);

struct Partitions {
    bool fromEngine = false;         ///< whether the engine's own colours are shown
    int colorCount = 0;              ///< colours are 0 … colorCount − 1
    std::vector<int> contactColors;  ///< of each of Snapshot::contacts; −1: the solver does not see it
};

/// The engine's colours when the snapshot has any (ContactState::color ≥ 0), else a greedy colouring. That one goes
/// through touching contacts without sensors in the snapshot's order. Each gets the lowest colour that no contact of
/// its dynamic bodies has yet (Welsh and Powell, "An upper bound for the chromatic number of a graph", 1967).
/// O(contacts · colours).
[[nodiscard]] Partitions FindPartitions(const Snapshot& snapshot);

}  // namespace testbed
