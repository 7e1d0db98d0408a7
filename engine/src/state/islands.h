// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands: sets of awake bodies connected by touching contacts and joints. Scratch of one step.

#pragma once

#include <span>
#include <vector>

#include "base/bytes.h"
#include "state/indices.h"

namespace scree {

/// Ranges into the order arrays below.
struct Island {
    int bodyBegin, bodyEnd;
    int contactBegin, contactEnd;
    int jointBegin, jointEnd;
};

struct IslandTable {
    std::vector<Island> islands;
    std::vector<BodyIndex> bodies;       ///< bodies of all islands, island by island; static bodies are not listed
    std::vector<ContactIndex> contacts;  ///< contacts in the order of discovery
    std::vector<JointIndex> joints;
    std::vector<BodyIndex> isolated;  ///< awake bodies without contacts and joints
    uint64_t search = 0;              ///< what they answer (IslandMemo); 0: nothing that is known

    void Clear() {
        search = 0;
        islands.clear();
        bodies.clear(), contacts.clear(), joints.clear(), isolated.clear();
    }
    [[nodiscard]] size_t GetMemoryBytes() const { return BytesOf(islands, bodies, contacts, joints, isolated); }
};

template <Index I>
std::span<const I> Range(const std::vector<I>& order, int begin, int end) {
    return {order.data() + begin, ToSize(end - begin)};
}
inline std::span<const BodyIndex> Bodies(const IslandTable& t, const Island& i) {
    return Range(t.bodies, i.bodyBegin, i.bodyEnd);
}
inline std::span<const ContactIndex> Contacts(const IslandTable& t, const Island& i) {
    return Range(t.contacts, i.contactBegin, i.contactEnd);
}
inline std::span<const JointIndex> Joints(const IslandTable& t, const Island& i) {
    return Range(t.joints, i.jointBegin, i.jointEnd);
}

}  // namespace scree
