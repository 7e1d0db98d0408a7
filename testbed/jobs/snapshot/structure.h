// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a snapshot consists of, small enough to stand in a sidecar. Every body, tree node and contact has a short hash
// of its exact bits, and its rounded values while there are few. Two structures tell which bodies, nodes and contacts
// changed.
//
//     "structure": {"bodies": {"count": 3, "hashes": "4 characters each", "poses": "x y angle,…"},
//                   "nodes": {"count": 5, "hashes": "…", "boxes": "level x0 y0 x1 y1,…"},
//                   "contacts": {"count": 2, "hash": "…", "list": "A-B t 2 hash,…"}}
//
// Lengths are in mm, angles in mrad; the angle of a sleeping body is followed by s. A contact names its two fixtures,
// then t (touching) or n (not), its number of points and its hash. A fixture whose index is not that of its body is
// followed by a point and the body ("7.5-8.5"). Where there are too many, poses, boxes and list are absent, and "block"
// bodies or nodes share a hash.

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
