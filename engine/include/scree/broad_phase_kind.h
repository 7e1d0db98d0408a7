// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The names of the broad-phase algorithms, selectable in WorldDef and by the testbed's --broad-phase.

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace scree {

enum class BroadPhaseKind : uint8_t {
    automatic,      ///< the fastest algorithm that keeps a tree: `keys`
    bruteForce,     ///< every box against every box: the oracle
    sweepAndPrune,  ///< sort along one axis, kept sorted between steps
    bvhBarycentre,  ///< top-down tree, split at the middle of the centres' bounds; pairs by dual descent
    bvhSah,         ///< top-down tree, split by the surface area heuristic; pairs by dual descent
    fatTree,        ///< Box2D's strategy: incremental insertion, rotations, fattened boxes, move buffer
    global1,        ///< barycentre tree, one query per box
    global2,        ///< barycentre tree, batch query in place
    global3,        ///< barycentre tree, candidate sets handed to one sibling
    unified,        ///< build and detect in one pass: the reference
    keys,           ///< build on 16-bit centre keys, wide leaves, candidate sets: the production form
};

inline constexpr std::array<std::string_view, 11> broadPhaseNames = {
    "auto",     "brute-force", "sweep-and-prune", "bvh-barycentre", "bvh-sah", "fat-tree",
    "global-1", "global-2",    "global-3",        "unified",        "keys"};

constexpr std::string_view GetName(BroadPhaseKind kind) { return broadPhaseNames[static_cast<size_t>(kind)]; }

/// The algorithm with that name, if there is one.
constexpr std::optional<BroadPhaseKind> BroadPhaseFromName(std::string_view name) {
    for (size_t i = 0; i < broadPhaseNames.size(); ++i) {
        if (broadPhaseNames[i] == name) return static_cast<BroadPhaseKind>(i);
    }
    return std::nullopt;
}

}  // namespace scree
