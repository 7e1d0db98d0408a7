// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A node of the broad-phase tree as inspectors see it.

#pragma once

#include <cstdint>

#include "scree/math.h"

namespace scree {

/// One node of a tree. A leaf of the engine's tree may hold many boxes. For inspection it is split further, down to one
/// box per leaf, so n proxies always make n − 1 internal nodes. Children come after their parent; the root is 0.
struct BvhNode {
    AABB box;
    int32_t parent = -1;               ///< index of the parent, −1 for the root
    int32_t child1 = -1, child2 = -1;  ///< −1 for leaves
    int32_t fixture = -1;              ///< Fixture::GetIndex of a leaf, −1 for internal nodes
    int32_t level = 0;                 ///< root 0
};

}  // namespace scree
