// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Top-down building by a split rule: boxes in, flat tree out, O(n log n) unless the boxes defeat the rule. A range of
// boxes is measured, split in two and so on down to the leaves.

#pragma once

#include <cstdint>
#include <vector>

#include "broad_phase/flat_tree.h"
#include "broad_phase/proxy_store.h"
#include "broad_phase/split_rules.h"

namespace scree::broadphase {

/// Copies proxies into items, reusing the vector.
void CollectItems(const ProxyStore& store, SlotRange slots, std::vector<BuildItem>& items);

/// Builds the tree over `items`, which it reorders into leaf order.
void BuildTopDown(std::vector<BuildItem>& items, SplitRule rule, uint32_t leafSize, FlatTree& tree);

}  // namespace scree::broadphase
