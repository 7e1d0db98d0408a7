// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which contacts and joints connect bodies, and the rows of these contacts.

#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "base/gather_parts.h"
#include "state/bodies.h"
#include "state/contacts.h"
#include "state/joints.h"

namespace scree {

/// A contact is solved if it touches, is enabled and has no sensor.
inline bool IsSolved(uint8_t flags) {
    constexpr uint8_t solved = ContactFlag::alive | ContactFlag::touching | ContactFlag::enabled;
    return (flags & (solved | ContactFlag::sensor)) == solved;
}
/// A joint is solved if both its bodies are enabled.
inline bool IsSolved(const JointInfo& joint, const BodyTable& bodies) {
    return bodies.Has(joint.bodyA, BodyFlag::enabled) && bodies.Has(joint.bodyB, BodyFlag::enabled);
}

/// Makes the column 0 for all listed movers. Other bodies are left aside if they are many: in worlds where most is
/// static or rests their rows would cost more than the rest.
template <typename T>
void ClearForListed(const BodyTable& bodies, Column<BodyIndex, T>& column) {
    EnsureRows(column, ToSize(bodies.slots.Size()));
    if (bodies.Listed().size() * 8 >= column.size()) {
        std::fill(column.begin(), column.end(), T{0});
        return;
    }
    for (const BodyIndex body : bodies.Listed()) column[body] = 0;
}

/// Whether so few movers are listed that asking them for their joints costs less than to look at all joints.
inline bool AreFewListed(const JointTable& joints, const BodyTable& bodies) {
    return ToSize(joints.slots.Count()) > 8 * bodies.Listed().size();
}

/// Fewer rows than this are not worth sharing.
inline constexpr int leastRowsToShare = 1024;

/// Lists contacts that do not rest, in the order of their rows. Each goes to take(contact, place), which writes it to
/// the place, and moves this on if it is to be kept. Then finish(begin, end) may drop more of a part; it returns how
/// many are left.
template <typename Take, typename Finish>
void GatherActiveRows(const ContactTable& contacts, TaskPool& pool, std::vector<ContactIndex>& rows, Take&& take,
                      Finish&& finish) {
    const bool restsSome = contacts.RestingCount() > 0;
    if (restsSome && (!pool.IsOpen() || contacts.active.Count() < leastRowsToShare)) {
        rows.resize(ToSize(contacts.active.Count()));
        ContactIndex* place = rows.data();
        contacts.active.ForEach([&](ContactIndex contact) { take(contact, place); });
        rows.resize(finish(rows.data(), place));
        return;
    }
    GatherParts<ContactIndex, 1>(pool, contacts.Size(), leastRowsToShare, {&rows},
                                 [&](int begin, int end, const std::array<ContactIndex*, 1>& places) {
                                     ContactIndex* place = places[0];
                                     if (restsSome) {
                                         contacts.active.ForEachBetween(
                                             ContactIndex{begin}, ContactIndex{end},
                                             [&](ContactIndex contact) { take(contact, place); });
                                     } else {
                                         for (int i = begin; i < end; ++i) take(ContactIndex{i}, place);
                                     }
                                     return std::array{finish(places[0], place)};
                                 });
}

/// The rows of the solved contacts that do not rest, and of which keep(contact) is true.
template <typename Keep>
void GatherSolved(const ContactTable& contacts, TaskPool& pool, std::vector<ContactIndex>& rows, Keep&& keep) {
    // Which are solved is no branch, for it follows no pattern. What is kept of them does.
    GatherActiveRows(
        contacts, pool, rows,
        [&](ContactIndex contact, ContactIndex*& place) {
            *place = contact;
            place += IsSolved(contacts.flags[contact]) ? 1 : 0;
        },
        [&](ContactIndex* begin, ContactIndex* end) {
            return static_cast<size_t>(std::remove_if(begin, end, std::not_fn(keep)) - begin);
        });
}

}  // namespace scree
