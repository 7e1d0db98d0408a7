// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which nodes of a broad-phase tree a picture counts: `--nodes internal|leaves|all|level=K|levels=A..B`.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "testbed/engines/snapshot.h"

namespace testbed {

struct NodeSelection {
    enum class Kind { internal, leaves, all, levels };
    Kind kind = Kind::internal;
    int firstLevel = 0, lastLevel = 0;  ///< of `levels`, inclusive; the root is level 0
};

/// Throws std::invalid_argument that lists the forms for anything else.
[[nodiscard]] NodeSelection ParseNodeSelection(std::string_view text);
/// The text that ParseNodeSelection reads back.
[[nodiscard]] std::string GetNodeSelectionName(const NodeSelection& selection);
[[nodiscard]] bool IsSelected(const NodeSelection& selection, const NodeState& node);
/// Boxes of the selected nodes, in node order.
[[nodiscard]] std::vector<Box> SelectBoxes(const Snapshot& snapshot, const NodeSelection& selection);

}  // namespace testbed
