// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands: sets of awake bodies connected by touching contacts and joints. Scratch of one step.

#pragma once

#include <vector>

namespace scree {

/// Ranges into the order arrays below.
struct Island {
    int bodyBegin, bodyEnd;
    int contactBegin, contactEnd;
    int jointBegin, jointEnd;
};

struct IslandTable {
    std::vector<Island> islands;
    std::vector<int> bodies;    ///< bodies of all islands, island by island; static bodies are not listed
    std::vector<int> contacts;  ///< contacts in the order of discovery
    std::vector<int> joints;
    std::vector<int> isolated;  ///< awake bodies without contacts and joints
};

}  // namespace scree
