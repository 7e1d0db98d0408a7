// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A snapshot's bodies, contacts, joints and boxes as a DrawList: which colour and size each has on the picture.

#pragma once

#include <vector>

#include "testbed/adapters/snapshot.h"
#include "testbed/view/camera.h"
#include "testbed/view/draw_list.h"
#include "testbed/view/layers.h"
#include "testbed/view/nodes.h"

namespace testbed {

/// For each body the smallest index of a body in its island; −1 for static and kinematic ones. Dynamic bodies are of
/// one island when touching contacts (sensors excepted) or joints connect them. O(bodies + contacts).
[[nodiscard]] std::vector<int> FindIslands(const Snapshot& snapshot);

/// `nodes` are those that the bvh layer outlines.
[[nodiscard]] DrawList BuildDrawList(const Snapshot& snapshot, const Camera& camera, const Layers& layers,
                                     const NodeSelection& nodes, int supersampling);

}  // namespace testbed
