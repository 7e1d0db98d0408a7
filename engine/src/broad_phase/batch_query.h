// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Batch query in place (Tsamis 2020, §3.5, Query-All2). All query boxes go down the tree together. At every node those
// that overlap it are swapped to the front of the batch, and only that front goes on to both children. The front's
// order changes below, its set does not, so one array serves the whole walk.

#pragma once

#include <vector>

#include "broad_phase/flat_tree.h"

namespace scree::broadphase {

struct BatchItem {
    Bounds box;
    uint32_t position;  ///< in the tree of the queries
};

/// Pairs of boxes of two trees. Returns the number of box tests. `batch` is a buffer.
uint64_t QueryBatch(const FlatTree& queries, const FlatTree& tree, std::vector<BatchItem>& batch, PairSink& sink);
/// Pairs inside one tree, each once.
uint64_t QueryBatchSelf(const FlatTree& tree, std::vector<BatchItem>& batch, PairSink& sink);

}  // namespace scree::broadphase
