// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The direct solve over a forest of joints: G·M⁻¹·Gᵀ as a block LDLᵀ without fill-in, in time that grows with the
// number of joints.

#pragma once

#include "constraints/joint_tree_forest.h"

namespace scree {

/// From the rows of all joints at the present poses: their pivots' inverses and the blocks of L.
void FactorizeForest(JointForest& forest);
/// Right sides → impulses, which are added to the joints' sums and push the bodies.
void SolveForest(JointForest& forest);

}  // namespace scree
