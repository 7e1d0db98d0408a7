// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rules that split a range of boxes in two, both of Tsamis 2020, §3.2 (list 4) and §3.6. The barycentre rule takes the
// middle of the bounds of the centres. The surface area heuristic works over bins (Wald 2007, On fast construction of
// SAH-based bounding volume hierarchies).

#pragma once

#include <cstdint>

#include "broad_phase/bounds.h"
#include "broad_phase/pair_sink.h"

namespace scree::broadphase {

/// A box while it is being sorted into a tree.
struct BuildItem {
    Bounds box;
    ItemId id;
};

/// What splitting must know of a range of boxes.
struct RangeBounds {
    Bounds box = emptyBounds;
    Bounds centre = emptyBounds;  ///< twice the bounds of the centres, lower and negated upper like a box
};

RangeBounds Measure(const BuildItem* items, uint32_t count);

/// Reorders `count` >= 2 items into two parts and returns the size of the first; 0 or `count` if it cannot tell them
/// apart.
using SplitRule = uint32_t (*)(BuildItem* items, uint32_t count, const Bounds& centre);

/// By the middle of the centres' bounds along their longer side.
uint32_t SplitBarycentre(BuildItem* items, uint32_t count, const Bounds& centre);
/// By the cheapest of the bin borders of both axes: perimeter × count, the surface area of 2D.
uint32_t SplitSah(BuildItem* items, uint32_t count, const Bounds& centre);

/// Splits by a rule may go this deep; below it halves of equal count end every recursion within 32 more levels.
inline constexpr int maxRuleDepth = 64;

/// The rule's split, or equal halves where it does not separate or has gone too deep. In 1 … count − 1.
uint32_t SplitOrHalve(SplitRule rule, BuildItem* items, uint32_t count, const Bounds& centre, int depth);

}  // namespace scree::broadphase
