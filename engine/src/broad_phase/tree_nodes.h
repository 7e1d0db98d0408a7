// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Inspection: the two trees of an algorithm as one list of nodes with one box per leaf.

#pragma once

#include <vector>

#include "broad_phase/flat_tree.h"
#include "broad_phase/split_rules.h"
#include "scree/bvh_node.h"

namespace scree::broadphase {

/// Writes both trees, each continued by `rule` to one box per leaf, children behind parents. Where neither is empty
/// they are joined under a root of both.
void WriteNodes(const FlatTree& main, const FlatTree& statics, SplitRule rule, std::vector<BvhNode>& nodes);

}  // namespace scree::broadphase
