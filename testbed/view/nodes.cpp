// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Parsing and applying a node selection.

#include "testbed/view/nodes.h"

#include <stdexcept>

#include "testbed/base/text.h"

namespace testbed {

NodeSelection ParseNodeSelection(std::string_view text) {
    using Kind = NodeSelection::Kind;
    if (text == "internal") return {Kind::internal, 0, 0};
    if (text == "leaves") return {Kind::leaves, 0, 0};
    if (text == "all") return {Kind::all, 0, 0};
    std::string problem;
    if (text.starts_with("level=")) {
        const Parsed<int> level = ParseNumber<int>(text.substr(6));
        if (level && *level >= 0) return {Kind::levels, *level, *level};
        problem = level.problem;
    }
    if (const size_t dots = text.find(".."); text.starts_with("levels=") && dots != std::string_view::npos) {
        const Parsed<int> first = ParseNumber<int>(text.substr(7, dots - 7));
        const Parsed<int> last = ParseNumber<int>(text.substr(dots + 2));
        if (first && last && *first >= 0 && *first <= *last) return {Kind::levels, *first, *last};
        problem = !first ? first.problem : last.problem;
    }
    throw std::invalid_argument("bad nodes '" + std::string(text) + "': " + BeforeCure(problem) +
                                "use internal, leaves, all, level=K or levels=A..B (the root is level 0)");
}

std::string GetNodeSelectionName(const NodeSelection& selection) {
    switch (selection.kind) {
        case NodeSelection::Kind::internal:
            return "internal";
        case NodeSelection::Kind::leaves:
            return "leaves";
        case NodeSelection::Kind::all:
            return "all";
        case NodeSelection::Kind::levels:
            break;
    }
    if (selection.firstLevel == selection.lastLevel) return "level=" + std::to_string(selection.firstLevel);
    return "levels=" + std::to_string(selection.firstLevel) + ".." + std::to_string(selection.lastLevel);
}

bool IsSelected(const NodeSelection& selection, const NodeState& node) {
    switch (selection.kind) {
        case NodeSelection::Kind::internal:
            return node.child1 >= 0;
        case NodeSelection::Kind::leaves:
            return node.child1 < 0;
        case NodeSelection::Kind::all:
            return true;
        case NodeSelection::Kind::levels:
            break;
    }
    return selection.firstLevel <= node.level && node.level <= selection.lastLevel;
}

std::vector<Box> SelectBoxes(const Snapshot& snapshot, const NodeSelection& selection) {
    std::vector<Box> boxes;
    for (const NodeState& node : snapshot.nodes) {
        if (IsSelected(selection, node)) boxes.push_back(node.box);
    }
    return boxes;
}

}  // namespace testbed
