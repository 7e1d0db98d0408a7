// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Parsing and applying a node selection.

#include "testbed/view/nodes.h"

#include <charconv>
#include <stdexcept>

namespace testbed {

namespace {

bool ParseLevel(std::string_view text, int& level) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
    return error == std::errc{} && end == text.data() + text.size() && level >= 0;
}

}  // namespace

NodeSelection ParseNodeSelection(std::string_view text) {
    using Kind = NodeSelection::Kind;
    if (text == "internal") return {Kind::internal, 0, 0};
    if (text == "leaves") return {Kind::leaves, 0, 0};
    if (text == "all") return {Kind::all, 0, 0};
    NodeSelection selection{Kind::levels, 0, 0};
    if (text.starts_with("level=") && ParseLevel(text.substr(6), selection.firstLevel)) {
        selection.lastLevel = selection.firstLevel;
        return selection;
    }
    if (const size_t dots = text.find(".."); text.starts_with("levels=") && dots != std::string_view::npos &&
                                             ParseLevel(text.substr(7, dots - 7), selection.firstLevel) &&
                                             ParseLevel(text.substr(dots + 2), selection.lastLevel) &&
                                             selection.firstLevel <= selection.lastLevel) {
        return selection;
    }
    throw std::invalid_argument("bad nodes '" + std::string(text) +
                                "': use internal, leaves, all, level=K or levels=A..B (the root is level 0)");
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
