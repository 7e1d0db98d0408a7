// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The nodes of Box2D's private broad-phase tree: b2BroadPhase in, NodeState list out (pre-order, root first).

#pragma once

#include <functional>
#include <vector>

#include "testbed/engines/snapshot.h"

class b2BroadPhase;

namespace testbed {

/// Replaces `nodes`. `fixtureOf` maps a leaf's user data to an index into Snapshot::fixtures.
void DumpBox2dTree(const b2BroadPhase& broadPhase, const std::function<int(void* userData)>& fixtureOf,
                   std::vector<NodeState>& nodes);

}  // namespace testbed
