// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The question is compared as a whole, value by value, so that nothing that changes a world has to tell.

#include "pipeline/parts/island_memo.h"

#include <algorithm>

#include "base/gather_parts.h"

namespace scree {

namespace {

/// The flags that a search asks for.
uint8_t FlagsOf(const BodyTable& bodies, BodyIndex body) {
    return static_cast<uint8_t>(bodies.flags[body] & (BodyFlag::awake | BodyFlag::enabled));
}

/// Where some rest, or are static, a search looks at few of the bodies, and comparing all would take longer.
bool IsWorthwhile(const IslandMemo::Question& q) {
    constexpr size_t leastRows = 64, mostRest = 8;
    return q.rows.size() >= leastRows && q.contacts.RestingCount() == 0 && q.bodies.AreAllListed() &&
           q.bodies.Listed().size() * mostRest >= q.bodies.flags.size();
}

}  // namespace

bool IslandMemo::IsSame(const Question& q) const {
    if (q.isolatedApart != m_isolatedApart) return false;
    if (q.joints.GetBirths() != m_jointBirths || q.joints.slots.Count() != m_jointCount) return false;
    if (!std::ranges::equal(q.bodies.Listed(), m_listed)) return false;
    if (q.bodies.flags.size() != m_flags.size()) return false;
    for (const BodyIndex body : q.bodies.flags.Rows()) {
        if (FlagsOf(q.bodies, body) != m_flags[ToSize(body)]) return false;
    }
    constexpr int leastRowsToShare = 2048;
    return AllOf(q.pool, static_cast<int>(q.rows.size()), leastRowsToShare, [&](int begin, int end) {
        for (size_t i = ToSize(begin); i < ToSize(end); ++i) {
            const ContactPair& pair = q.contacts.pair[q.rows[i]];
            if (m_ends[i] != Ends{pair.bodyA, pair.bodyB}) return false;
        }
        return true;
    });
}

void IslandMemo::Keep(const Question& q) {
    m_isolatedApart = q.isolatedApart;
    m_jointBirths = q.joints.GetBirths();
    m_jointCount = q.joints.slots.Count();
    m_listed.assign(q.bodies.Listed().begin(), q.bodies.Listed().end());
    m_flags.resize(q.bodies.flags.size());
    for (const BodyIndex body : q.bodies.flags.Rows()) m_flags[ToSize(body)] = FlagsOf(q.bodies, body);
    m_ends.resize(q.rows.size());
    for (size_t i = 0; i < q.rows.size(); ++i) {
        const ContactPair& pair = q.contacts.pair[q.rows[i]];
        m_ends[i] = {pair.bodyA, pair.bodyB};
    }
    m_isKept = true;
    ++m_search;
}

bool IslandMemo::IsAnswered(const Question& q, const IslandTable& islands) {
    const bool areSameRows = IsWorthwhile(q) && std::ranges::equal(q.rows, m_rows);
    if (areSameRows && m_isKept && islands.search == m_search && IsSame(q)) return true;
    m_isKept = false;
    if (areSameRows) {
        Keep(q);  // the second time that contacts are the same: they may stay so
    } else {
        m_rows.assign(q.rows.begin(), q.rows.end());
    }
    return false;
}

}  // namespace scree
