// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a pointer asks of a snapshot: which body and which tree node are under it, how a node is reached from the root,
// and which nodes a query visits.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "testbed/engines/snapshot.h"
#include "testbed/view/nodes.h"

namespace testbed {

/// Index of the dynamic body whose fixture contains the point, the last drawn of several; −1: none. Edges have no
/// inside. O(fixtures).
[[nodiscard]] int FindBodyAt(const Snapshot& snapshot, Vec2 point);

/// The world point in a body's coordinates, and back.
[[nodiscard]] Vec2 ToLocal(const BodyState& body, Vec2 point);
[[nodiscard]] Vec2 ToWorld(const BodyState& body, Vec2 localPoint);

/// The smallest selected node whose box contains the point, the deepest of equals; −1: none. O(nodes).
[[nodiscard]] int FindNodeAt(const Snapshot& snapshot, const NodeSelection& selection, Vec2 point);

/// The indices of the nodes from the root to the node, both included.
[[nodiscard]] std::vector<int> GetPath(std::span<const NodeState> nodes, int node);
/// "root" and then 1 or 2 for each child taken: "root 1 2 2".
[[nodiscard]] std::string DescribePath(std::span<const NodeState> nodes, int node);

/// Leaves at and below the node. O(nodes).
[[nodiscard]] int CountLeaves(std::span<const NodeState> nodes, int node);

/// What a query of the tree does: it tests the root, and both children of every node that overlaps the query's box.
struct QueryTrace {
    std::vector<int> visited;  ///< nodes whose box overlaps the query's, in the order of the visit (depth first)
    int tested = 0;            ///< box tests, the root's included
    int leaves = 0;            ///< leaves among the visited: what the query reports
};

/// A closed box as query; a point is a box of no size. O(visited).
[[nodiscard]] QueryTrace TraceQuery(std::span<const NodeState> nodes, const Box& query);

}  // namespace testbed
