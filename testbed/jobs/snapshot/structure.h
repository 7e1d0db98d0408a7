// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a snapshot consists of, small enough to stand in a sidecar: every body, tree node and contact with a short hash
// of its exact bits, and its rounded values while there are few. Two of them say which bodies, nodes and contacts
// changed, far more than pixels can.
//
//     "structure": {"bodies": {"count": 3, "hashes": "4 characters each", "poses": "x y angle,…"},
//                   "nodes": {"count": 5, "hashes": "…", "boxes": "level x0 y0 x1 y1,…"},
//                   "contacts": {"count": 2, "hash": "…", "list": "A-B t 2 hash,…"}}
//
// Lengths in mm, angles in mrad, a sleeping body's angle is followed by s. A contact names fixtures, with their body
// after a point where its index is another ("7.5-8.5"), then t (touching) or n, and its number of points. poses, boxes
// and list are absent when there would be too many, and then bodies or nodes share a hash: "block" of them each.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "testbed/engines/snapshot.h"

namespace testbed {

[[nodiscard]] nlohmann::ordered_json DescribeStructure(const Snapshot& snapshot);

/// The field "structure" of results.json (result.h). Throws std::invalid_argument for what DescribeStructure
/// cannot have written.
[[nodiscard]] nlohmann::ordered_json CompareStructures(const nlohmann::ordered_json& expected,
                                                       const nlohmann::ordered_json& actual);

}  // namespace testbed
