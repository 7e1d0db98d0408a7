// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pairs inside one tree by dual descent (Gottschalk, Lin, Manocha 1996, OBBTree, §5). A node against itself is each
// child against itself and both against each other. Two nodes that overlap go on with the children of the larger one.

#pragma once

#include "broad_phase/flat_tree.h"

namespace scree::broadphase {

/// Returns the number of box tests.
uint64_t DescendSelf(const FlatTree& tree, PairSink& sink);

}  // namespace scree::broadphase
