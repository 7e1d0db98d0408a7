// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands: sets of awake bodies connected by touching contacts and joints. Scratch of one step.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"

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

    void Clear() {
        islands.clear();
        for (std::vector<int>* list : {&bodies, &contacts, &joints, &isolated}) list->clear();
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(islands, bodies, contacts, joints, isolated); }
};

inline std::span<const int> Range(const std::vector<int>& order, int begin, int end) {
    return {order.data() + begin, static_cast<size_t>(end - begin)};
}
inline std::span<const int> Bodies(const IslandTable& t, const Island& i) {
    return Range(t.bodies, i.bodyBegin, i.bodyEnd);
}
inline std::span<const int> Contacts(const IslandTable& t, const Island& i) {
    return Range(t.contacts, i.contactBegin, i.contactEnd);
}
inline std::span<const int> Joints(const IslandTable& t, const Island& i) {
    return Range(t.joints, i.jointBegin, i.jointEnd);
}

}  // namespace scree
