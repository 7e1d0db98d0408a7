// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Counts the pairs of a set of boxes. One routine of the testbed serves all engines, so that their numbers of pairs
// compare. A pair is two boxes of different bodies, at least one dynamic, whose closed boxes overlap. Sorted sweep
// along one axis (Shamos, Hoey 1976).

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "testbed/engines/snapshot.h"

namespace testbed {

/// A box with what the pair rule needs to know of its body.
struct PairBox {
    Box box;
    int body;
    bool dynamic;
};

/// Number of pairs. About O(n√n + pairs) for evenly spread boxes; static boxes are never compared with each other.
[[nodiscard]] int64_t CountPairs(std::span<const PairBox> boxes);

/// The tight boxes of a capture with bodies and fixtures.
[[nodiscard]] std::vector<PairBox> TightBoxes(const Snapshot& snapshot);

/// The boxes that the leaves of the tree keep (fattened, in Box2D); needs bodies, fixtures and nodes.
[[nodiscard]] std::vector<PairBox> LeafBoxes(const Snapshot& snapshot);

}  // namespace testbed
