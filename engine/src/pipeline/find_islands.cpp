// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands by depth-first search over an adjacency built anew from the touching contacts. That takes one pass, of a few
// nanoseconds a contact, and spares the table its four list links.

#include "pipeline/find_islands.h"

#include <algorithm>
#include <array>

#include "base/gather_parts.h"
#include "base/shared_count.h"
#include "pipeline/parts/solved_rows.h"

namespace scree {

namespace {

bool HasSolvedJoint(const JointTable& joints, const BodyTable& bodies, BodyIndex body) {
    if (bodies.info[body].jointCount == 0) return false;
    for (const JointIndex joint : joints.OfBody(body)) {
        if (IsSolved(joints.info[joint], bodies)) return true;
    }
    return false;
}

/// The solved joints with an active body, in the order of the list.
void GatherActiveJoints(const JointTable& joints, const BodyTable& bodies, std::vector<JointIndex>& active) {
    active.clear();
    if (!AreFewListed(joints, bodies)) {
        for (JointIndex joint = joints.listHead; IsSome(joint); joint = joints.info[joint].listNext) {
            const JointInfo& info = joints.info[joint];
            const bool isActive = bodies.IsActive(info.bodyA) || bodies.IsActive(info.bodyB);
            if (isActive && IsSolved(info, bodies)) active.push_back(joint);
        }
        return;
    }
    for (const BodyIndex body : bodies.Listed()) {
        if (!bodies.IsActive(body) || bodies.info[body].jointCount == 0) continue;
        for (const JointIndex joint : joints.OfBody(body)) {
            const JointInfo& info = joints.info[joint];
            const bool isOther = body != info.bodyA && bodies.IsActive(info.bodyA);  // which has it already
            if (!isOther && IsSolved(info, bodies)) active.push_back(joint);
        }
    }
    std::ranges::sort(active, [&](JointIndex a, JointIndex b) { return joints.IsNewer(a, b); });
}

/// Lists the movers that have one of the contacts, since the search may reach them.
void ListMoversOf(std::span<const ContactIndex> rows, const ContactTable& contacts, BodyTable& bodies) {
    if (bodies.AreAllListed()) return;
    for (const ContactIndex row : rows) {
        const ContactPair& pair = contacts.pair[row];
        for (const BodyIndex body : {pair.bodyA, pair.bodyB}) {
            if (bodies.type[body] != staticBody) bodies.List(body);
        }
    }
}

/// Calls visit(mover, other, row) for both sides of contacts [begin, end) of the rows, as far as they are movers; the
/// other one is −1 if it is static.
template <typename Visit>
void ForEachSide(const ContactTable& contacts, const BodyTable& bodies, std::span<const ContactIndex> rows,
                 Visit&& visit) {
    const auto mover = [&](BodyIndex body) { return bodies.type[body] != staticBody ? body : BodyIndex::none; };
    for (const ContactIndex row : rows) {
        const ContactPair& pair = contacts.pair[row];
        const BodyIndex a = mover(pair.bodyA), b = mover(pair.bodyB);
        if (IsSome(a)) visit(a, b, row);
        if (IsSome(b)) visit(b, a, row);
    }
}

/// Chains the contacts of each mover in `entries`, the newest row first; movers that have some become `touched`.
void ListByBody(const ContactTable& contacts, const BodyTable& bodies, IslandScratch& s) {
    int used = 0;
    ForEachSide(contacts, bodies, s.rows, [&](BodyIndex body, BodyIndex other, ContactIndex row) {
        s.entries[ToSize(++used)] = {row, other, s.first[body]};
        s.first[body] = used;
        s.progress[body] = IslandScratch::touched;
    });
}

/// The same by many workers. Where a mover's entries are depends on who came first, which is of no consequence.
void ListByBodyShared(const ContactTable& contacts, const BodyTable& bodies, TaskPool& pool, IslandScratch& s) {
    const std::span<const BodyIndex> listed = bodies.Listed();
    const auto forRows = [&](auto&& visit) {
        pool.For(static_cast<int>(s.rows.size()), leastRowsToShare, [&](int begin, int end, int /*worker*/) {
            ForEachSide(contacts, bodies, std::span(s.rows).subspan(ToSize(begin), ToSize(end - begin)), visit);
        });
    };
    const auto forListed = [&](auto&& visit) {
        pool.For(static_cast<int>(listed.size()), leastRowsToShare, [&](int begin, int end, int /*worker*/) {
            visit(listed.subspan(ToSize(begin), ToSize(end - begin)));
        });
    };
    ClearForListed(bodies, s.count);
    forRows([&](BodyIndex body, BodyIndex, ContactIndex) { AddShared(s.count[body], 1); });
    int used = 1;
    forListed([&](std::span<const BodyIndex> part) {
        int count = 0;
        for (const BodyIndex body : part) count += s.count[body];
        int next = AddShared(used, count);
        for (const BodyIndex body : part) {
            if (s.count[body] == 0) continue;
            s.progress[body] = IslandScratch::touched;
            s.first[body] = next += s.count[body];  // filling moves it down
        }
    });
    forRows([&](BodyIndex body, BodyIndex other, ContactIndex row) {
        s.entries[ToSize(AddShared(s.first[body], -1) - 1)] = {row, other, 0};
    });
    forListed([&](std::span<const BodyIndex> part) {
        for (const BodyIndex body : part) {
            if (s.progress[body] != IslandScratch::touched) continue;
            const auto first = s.entries.begin() + s.first[body];
            std::ranges::sort(first, first + s.count[body], std::greater<>(), &IslandScratch::Entry::contact);
            for (int i = 0; i + 1 < s.count[body]; ++i) first[i].next = s.first[body] + i + 1;
        }
    });
}

/// Contacts of each mover that has some of `rows`; these movers become `touched`, the others `untouched`.
void BuildAdjacency(const ContactTable& contacts, TaskPool& pool, const BodyTable& bodies, IslandScratch& s) {
    ClearForListed(bodies, s.first);
    ClearForListed(bodies, s.progress);
    EnsureRows(s.entries, 2 * s.rows.size() + 1);
    if (pool.IsWide() && s.rows.size() >= leastRowsToShare) {
        ListByBodyShared(contacts, bodies, pool, s);
    } else {
        ListByBody(contacts, bodies, s);
    }
}

class IslandSearch {
public:
    IslandSearch(const ContactTable& contacts, JointTable& joints, BodyTable& bodies, IslandScratch& scratch,
                 IslandTable& islands)
        : m_contacts(contacts),
          m_joints(joints),
          m_bodies(bodies),
          m_scratch(scratch),
          m_islands(islands),
          m_anyJoints(IsSome(joints.listHead)),
          m_someRest(contacts.RestingCount() > 0 || !bodies.AreAllListed()) {}

    void Grow(BodyIndex seed) {
        Island island{};
        island.bodyBegin = static_cast<int>(m_islands.bodies.size());
        island.contactBegin = static_cast<int>(m_islands.contacts.size());
        island.jointBegin = static_cast<int>(m_islands.joints.size());
        ReachOther(seed);
        while (!m_scratch.stack.empty()) {
            const BodyIndex body = m_scratch.stack.back();
            m_scratch.stack.pop_back();
            m_islands.bodies.push_back(body);
            // Reached bodies wake without a new sleep timer, so that a whole island can fall asleep together.
            m_bodies.WakeReached(body);
            VisitContacts(body);
            VisitJoints(body);
        }
        island.bodyEnd = static_cast<int>(m_islands.bodies.size());
        island.contactEnd = static_cast<int>(m_islands.contacts.size());
        island.jointEnd = static_cast<int>(m_islands.joints.size());
        m_islands.islands.push_back(island);
    }

private:
    /// A body that rested begins with nothing in the scratch.
    void Rouse(BodyIndex body) {
        if (!m_someRest || m_bodies.isListed[body] != 0) return;
        m_bodies.List(body);
        m_scratch.first[body] = 0;
        m_scratch.progress[body] = m_contacts.HasResting(body) ? IslandScratch::touched : IslandScratch::untouched;
    }

    void Reach(BodyIndex body, bool isTouched) {
        m_scratch.progress[body] = isTouched ? IslandScratch::seen : IslandScratch::seenUntouched;
        m_scratch.stack.push_back(body);
    }

    void ReachOther(BodyIndex other) {
        if (m_bodies.type[other] == staticBody) return;
        Rouse(other);
        const uint8_t progress = m_scratch.progress[other];
        if (progress < IslandScratch::seen) Reach(other, progress == IslandScratch::touched);
    }

    void VisitContacts(BodyIndex body) {
        if (m_scratch.progress[body] != IslandScratch::seen) return;
        m_scratch.progress[body] = IslandScratch::visited;
        if (m_someRest && m_contacts.HasResting(body)) return VisitRoused(body);
        for (int e = m_scratch.first[body]; e != 0; e = m_scratch.entries[ToSize(e)].next)
            VisitContact(m_scratch.entries[ToSize(e)]);
    }

    /// Of a body some of whose contacts have rested until now: all of them, the newest row first.
    void VisitRoused(BodyIndex body) {
        std::vector<ContactIndex>& rows = m_scratch.roused;
        rows.clear();
        m_contacts.ListResting(body, rows);
        std::erase_if(rows, [this](ContactIndex row) { return !IsSolved(m_contacts.flags[row]); });
        for (int e = m_scratch.first[body]; e != 0; e = m_scratch.entries[ToSize(e)].next)
            rows.push_back(m_scratch.entries[ToSize(e)].contact);
        std::sort(rows.begin(), rows.end(), std::greater<>());
        for (const ContactIndex row : rows) {
            const ContactPair& pair = m_contacts.pair[row];
            const BodyIndex other = pair.bodyA == body ? pair.bodyB : pair.bodyA;
            const bool isMover = m_bodies.type[other] != staticBody;
            if (isMover) Rouse(other);
            VisitContact({row, isMover ? other : BodyIndex::none, 0});
        }
    }

    void VisitContact(IslandScratch::Entry entry) {
        const uint8_t progress = IsNone(entry.other) ? uint8_t{IslandScratch::seen} : m_scratch.progress[entry.other];
        if (progress == IslandScratch::visited) return;  // it has listed the contact
        m_islands.contacts.push_back(entry.contact);
        if (progress < IslandScratch::seen) Reach(entry.other, true);
    }

    void VisitJoints(BodyIndex body) {
        if (!m_anyJoints || m_bodies.info[body].jointCount == 0) return;
        for (const JointIndex joint : m_joints.OfBody(body)) {
            if (m_scratch.jointSeen[joint]) continue;
            const JointInfo& row = m_joints.info[joint];
            const BodyIndex other = row.bodyA == body ? row.bodyB : row.bodyA;
            if (!m_bodies.Has(other, BodyFlag::enabled)) continue;
            m_scratch.jointSeen[joint] = 1;
            m_islands.joints.push_back(joint);
            ReachOther(other);
        }
    }

    const ContactTable& m_contacts;
    JointTable& m_joints;
    BodyTable& m_bodies;
    IslandScratch& m_scratch;
    IslandTable& m_islands;
    const bool m_anyJoints;  ///< the rows of bodies that know theirs are seldom in the cache
    const bool m_someRest;
};

}  // namespace

void FindIslands(const ContactTable& contacts, JointTable& joints, TaskPool& pool, BodyTable& bodies,
                 IslandScratch& scratch, IslandTable& islands, IsolatedPath path) {
    GatherSolved(contacts, pool, scratch.rows, [](ContactIndex) { return true; });
    ListMoversOf(scratch.rows, contacts, bodies);
    if (scratch.memo.IsAnswered({pool, contacts, joints, bodies, scratch.rows, path == IsolatedPath::apart}, islands))
        return;
    islands.Clear();
    islands.contacts.reserve(scratch.rows.size());
    BuildAdjacency(contacts, pool, bodies, scratch);
    scratch.jointSeen.assign(joints.info.size(), 0);

    const bool anyJoints = IsSome(joints.listHead);
    const std::span<const BodyIndex> listed = bodies.Listed();  // as it is now; what the search lists, it has visited
    const auto isIsolated = [&](BodyIndex body) {
        return path == IsolatedPath::apart && scratch.progress[body] == IslandScratch::untouched &&
               (!anyJoints || !HasSolvedJoint(joints, bodies, body));
    };
    GatherParts<BodyIndex, 2>(
        pool, static_cast<int>(listed.size()), leastRowsToShare, {&islands.isolated, &scratch.seeds},
        [&](int begin, int end, const std::array<BodyIndex*, 2>& places) {
            BodyIndex *isolated = places[0], *seed = places[1];
            for (int i = begin; i < end; ++i) {
                // Newest first, as Box2D walks its body list.
                const BodyIndex body = listed[listed.size() - 1 - ToSize(i)];
                if (!bodies.IsActive(body)) continue;
                (isIsolated(body) ? *isolated++ : *seed++) = body;
            }
            return std::array{static_cast<size_t>(isolated - places[0]), static_cast<size_t>(seed - places[1])};
        });
    IslandSearch search(contacts, joints, bodies, scratch, islands);
    for (const BodyIndex seed : scratch.seeds) {
        if (scratch.progress[seed] < IslandScratch::seen) search.Grow(seed);
    }
    scratch.memo.Stamp(islands);
}

void GatherActive(const ContactTable& contacts, const JointTable& joints, TaskPool& pool, const BodyTable& bodies,
                  IslandScratch& scratch, IslandTable& active, IsolatedPath path) {
    active.islands.clear();
    ClearForListed(bodies, scratch.progress);
    const auto note = [&](BodyIndex body) { SetSharedBits(scratch.progress[body], IslandScratch::touched); };
    GatherSolved(contacts, pool, active.contacts, [&](ContactIndex contact) {
        const ContactPair& pair = contacts.pair[contact];
        if (!bodies.IsActive(pair.bodyA) && !bodies.IsActive(pair.bodyB)) return false;
        note(pair.bodyA), note(pair.bodyB);
        return true;
    });
    GatherActiveJoints(joints, bodies, active.joints);
    for (const JointIndex joint : active.joints) note(joints.info[joint].bodyA), note(joints.info[joint].bodyB);
    const std::span<const BodyIndex> listed = bodies.Listed();
    GatherParts<BodyIndex, 2>(
        pool, static_cast<int>(listed.size()), leastRowsToShare, {&active.isolated, &active.bodies},
        [&](int begin, int end, const std::array<BodyIndex*, 2>& places) {
            BodyIndex *isolated = places[0], *other = places[1];
            for (int i = begin; i < end; ++i) {
                const BodyIndex body = listed[ToSize(i)];
                if (!bodies.IsActive(body)) continue;
                const bool isIsolated =
                    path == IsolatedPath::apart && scratch.progress[body] == IslandScratch::untouched;
                (isIsolated ? *isolated++ : *other++) = body;
            }
            return std::array{static_cast<size_t>(isolated - places[0]), static_cast<size_t>(other - places[1])};
        });
}

}  // namespace scree
