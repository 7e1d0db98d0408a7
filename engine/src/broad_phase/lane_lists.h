// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// From a mask of four lanes to a list of those that are set, written without a branch.

#pragma once

#include <cstdint>

#include "base/simd.h"

namespace scree::broadphase {

/// The lanes set in a mask, first ones first, and how many they are.
struct LaneList {
    uint32_t lanes[4];
    uint32_t count;
};
/// By mask.
inline constexpr LaneList laneLists[16] = {{{0, 0, 0, 0}, 0}, {{0, 0, 0, 0}, 1}, {{1, 0, 0, 0}, 1}, {{0, 1, 0, 0}, 2},
                                           {{2, 0, 0, 0}, 1}, {{0, 2, 0, 0}, 2}, {{1, 2, 0, 0}, 2}, {{0, 1, 2, 0}, 3},
                                           {{3, 0, 0, 0}, 1}, {{0, 3, 0, 0}, 2}, {{1, 3, 0, 0}, 2}, {{0, 1, 3, 0}, 3},
                                           {{2, 3, 0, 0}, 2}, {{0, 2, 3, 0}, 3}, {{1, 2, 3, 0}, 3}, {{0, 1, 2, 3}, 4}};

/// Writes `value` and `base + lane` for each lane of the list without a branch; four places must be free in both
/// arrays. Returns how many count.
SCREE_KERNEL uint32_t EmitLanes(const LaneList& list, uint32_t value, uint32_t base, uint32_t* values,
                                uint32_t* positions) {
    StoreU4(positions, LoadU4(list.lanes) + SplatU4(base));
    StoreU4(values, SplatU4(value));
    return list.count;
}

}  // namespace scree::broadphase
