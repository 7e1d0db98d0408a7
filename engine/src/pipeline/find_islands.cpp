// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands by depth-first search over an adjacency built anew from the touching contacts: a counting sort costs a few
// nanoseconds a contact and spares every contact its four list links.

#include "pipeline/find_islands.h"

#include <algorithm>
#include <functional>

namespace scree {

namespace {

constexpr uint8_t solvedFlags = ContactFlag::alive | ContactFlag::touching | ContactFlag::enabled;

/// A contact is solved if it touches, is enabled and has no sensor.
bool IsSolved(uint8_t flags) { return (flags & (solvedFlags | ContactFlag::sensor)) == solvedFlags; }

/// A joint is solved if both its bodies are enabled.
bool IsSolved(const JointInfo& joint, const BodyTable& bodies) {
    return bodies.Has(joint.bodyA, BodyFlag::enabled) && bodies.Has(joint.bodyB, BodyFlag::enabled);
}
bool HasSolvedJoint(const JointTable& joints, const BodyTable& bodies, int body) {
    if (bodies.info[static_cast<size_t>(body)].jointCount == 0) return false;
    for (const int joint : joints.OfBody(body)) {
        if (IsSolved(joints.info[static_cast<size_t>(joint)], bodies)) return true;
    }
    return false;
}

/// Makes the column 0 for all listed movers, other bodies left aside if they are many: in worlds where most is static
/// or rests their rows would cost more than the rest.
template <typename T>
void ClearForListed(const BodyTable& bodies, std::vector<T>& column) {
    EnsureRows(column, static_cast<size_t>(bodies.slots.Size()));
    if (bodies.Listed().size() * 8 >= column.size()) {
        std::fill(column.begin(), column.end(), T{0});
        return;
    }
    for (const int body : bodies.Listed()) column[static_cast<size_t>(body)] = 0;
}

/// The rows of the solved contacts that do not rest. The choice is no branch, for it follows no pattern.
std::span<const int> GatherSolved(const ContactTable& contacts, std::vector<int>& rows) {
    const size_t count = contacts.flags.size();
    EnsureRows(rows, count);
    size_t used = 0;
    const auto take = [&](size_t c) {
        rows[used] = static_cast<int>(c);
        used += IsSolved(contacts.flags[c]) ? 1 : 0;
    };
    if (contacts.RestingCount() > 0) {
        contacts.active.ForEach([&](int c) { take(static_cast<size_t>(c)); });
    } else {
        for (size_t c = 0; c < count; ++c) take(c);
    }
    return {rows.data(), used};
}

/// Lists the movers that have one of the contacts, since the search may reach them.
void ListMoversOf(std::span<const int> rows, const ContactTable& contacts, BodyTable& bodies) {
    if (bodies.AreAllListed()) return;
    for (const int row : rows) {
        const ContactPair& pair = contacts.pair[static_cast<size_t>(row)];
        for (const int body : {pair.bodyA, pair.bodyB}) {
            if (bodies.type[static_cast<size_t>(body)] != staticBody) bodies.List(body);
        }
    }
}

/// Contacts of each mover that has some, the newest row first; these movers become `touched`, the others `untouched`.
/// Returns the number of contacts.
size_t BuildAdjacency(const ContactTable& contacts, BodyTable& bodies, IslandScratch& s) {
    const std::span<const int> rows = GatherSolved(contacts, s.rows);
    ListMoversOf(rows, contacts, bodies);
    ClearForListed(bodies, s.end);
    ClearForListed(bodies, s.progress);
    EnsureRows(s.first, s.end.size());
    const auto mover = [&](int body) { return bodies.type[static_cast<size_t>(body)] != staticBody ? body : -1; };
    int total = 0;
    for (const int row : rows) {
        const ContactPair& pair = contacts.pair[static_cast<size_t>(row)];
        for (const int body : {mover(pair.bodyA), mover(pair.bodyB)}) {
            if (body >= 0) ++s.end[static_cast<size_t>(body)], ++total;
        }
    }
    EnsureRows(s.entries, static_cast<size_t>(total));
    int used = 0;
    const auto add = [&](int body, IslandScratch::Entry entry) {
        if (body < 0) return;
        const auto b = static_cast<size_t>(body);
        if (s.progress[b] == IslandScratch::untouched) {
            s.progress[b] = IslandScratch::touched;
            used += s.end[b];
            s.first[b] = s.end[b] = used;  // filling moves the start down
        }
        s.entries[static_cast<size_t>(--s.first[b])] = entry;
    };
    for (const int row : rows) {
        const ContactPair& pair = contacts.pair[static_cast<size_t>(row)];
        const int a = mover(pair.bodyA), b = mover(pair.bodyB);
        add(a, {row, b});
        add(b, {row, a});
    }
    return rows.size();
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
          m_anyJoints(joints.listHead >= 0),
          m_someRest(contacts.RestingCount() > 0 || !bodies.AreAllListed()) {}

    void Grow(int seed) {
        Island island{};
        island.bodyBegin = static_cast<int>(m_islands.bodies.size());
        island.contactBegin = static_cast<int>(m_islands.contacts.size());
        island.jointBegin = static_cast<int>(m_islands.joints.size());
        ReachOther(seed);
        while (!m_scratch.stack.empty()) {
            const int body = m_scratch.stack.back();
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
    void Rouse(int body) {
        if (!m_someRest || m_bodies.isListed[static_cast<size_t>(body)] != 0) return;
        m_bodies.List(body);
        const auto b = static_cast<size_t>(body);
        m_scratch.first[b] = m_scratch.end[b] = 0;
        m_scratch.progress[b] = m_contacts.HasResting(body) ? IslandScratch::touched : IslandScratch::untouched;
    }

    void Reach(int body, bool isTouched) {
        m_scratch.progress[static_cast<size_t>(body)] = isTouched ? IslandScratch::seen : IslandScratch::seenUntouched;
        m_scratch.stack.push_back(body);
    }

    void ReachOther(int other) {
        if (m_bodies.type[static_cast<size_t>(other)] == staticBody) return;
        Rouse(other);
        const uint8_t progress = m_scratch.progress[static_cast<size_t>(other)];
        if (progress < IslandScratch::seen) Reach(other, progress == IslandScratch::touched);
    }

    void VisitContacts(int body) {
        const auto b = static_cast<size_t>(body);
        if (m_scratch.progress[b] != IslandScratch::seen) return;
        m_scratch.progress[b] = IslandScratch::visited;
        if (m_someRest && m_contacts.HasResting(body)) return VisitRoused(body);
        for (int e = m_scratch.first[b]; e < m_scratch.end[b]; ++e)
            VisitContact(m_scratch.entries[static_cast<size_t>(e)]);
    }

    /// Of a body some of whose contacts have rested until now: all of them, the newest row first.
    void VisitRoused(int body) {
        const auto b = static_cast<size_t>(body);
        std::vector<int>& rows = m_scratch.roused;
        rows.clear();
        m_contacts.ListResting(body, rows);
        std::erase_if(rows, [this](int row) { return !IsSolved(m_contacts.flags[static_cast<size_t>(row)]); });
        for (int e = m_scratch.first[b]; e < m_scratch.end[b]; ++e)
            rows.push_back(m_scratch.entries[static_cast<size_t>(e)].contact);
        std::sort(rows.begin(), rows.end(), std::greater<>());
        for (const int row : rows) {
            const ContactPair& pair = m_contacts.pair[static_cast<size_t>(row)];
            const int other = pair.bodyA == body ? pair.bodyB : pair.bodyA;
            const bool isMover = m_bodies.type[static_cast<size_t>(other)] != staticBody;
            if (isMover) Rouse(other);
            VisitContact({row, isMover ? other : -1});
        }
    }

    void VisitContact(IslandScratch::Entry entry) {
        const uint8_t progress =
            entry.other < 0 ? uint8_t{IslandScratch::seen} : m_scratch.progress[static_cast<size_t>(entry.other)];
        if (progress == IslandScratch::visited) return;  // it has listed the contact
        m_islands.contacts.push_back(entry.contact);
        if (progress < IslandScratch::seen) Reach(entry.other, true);
    }

    void VisitJoints(int body) {
        if (!m_anyJoints || m_bodies.info[static_cast<size_t>(body)].jointCount == 0) return;
        for (const int joint : m_joints.OfBody(body)) {
            if (m_scratch.jointSeen[static_cast<size_t>(joint)]) continue;
            const JointInfo& row = m_joints.info[static_cast<size_t>(joint)];
            const int other = row.bodyA == body ? row.bodyB : row.bodyA;
            if (!m_bodies.Has(other, BodyFlag::enabled)) continue;
            m_scratch.jointSeen[static_cast<size_t>(joint)] = 1;
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

void FindIslands(const ContactTable& contacts, JointTable& joints, BodyTable& bodies, IslandScratch& scratch,
                 IslandTable& islands, IsolatedPath path) {
    islands.Clear();
    islands.contacts.reserve(BuildAdjacency(contacts, bodies, scratch));
    scratch.jointSeen.assign(joints.info.size(), 0);

    const bool anyJoints = joints.listHead >= 0;
    IslandSearch search(contacts, joints, bodies, scratch, islands);
    const std::span<const int> listed = bodies.Listed();  // as it is now; what the search lists, it has visited
    for (size_t m = listed.size(); m-- > 0;) {            // newest first, as Box2D walks its body list
        const int body = listed[m];
        const auto b = static_cast<size_t>(body);
        constexpr uint16_t active = BodyFlag::awake | BodyFlag::enabled;
        if ((bodies.flags[b] & active) != active || scratch.progress[b] >= IslandScratch::seen) continue;
        if (path == IsolatedPath::apart && scratch.progress[b] == IslandScratch::untouched &&
            (!anyJoints || !HasSolvedJoint(joints, bodies, body))) {
            islands.isolated.push_back(body);
        } else {
            search.Grow(body);
        }
    }
}

bool NeedsIslands(const ContactTable& contacts, const JointTable& joints, const BodyTable& bodies, float dt) {
    bool allAwake = bodies.AreAllListed();
    for (const int body : bodies.Listed()) {
        if (!bodies.IsActive(body)) {
            allAwake = false;
        } else if (bodies.sleepTime[static_cast<size_t>(body)] + dt >= timeToSleep) {
            return true;
        }
    }
    if (allAwake) return false;
    const auto wakes = [&](int a, int b) {
        const auto isMover = [&](int body) { return bodies.type[static_cast<size_t>(body)] != staticBody; };
        return isMover(a) && isMover(b) && bodies.IsActive(a) != bodies.IsActive(b);
    };
    for (int contact = contacts.Size(); (contact = contacts.Before(contact)) >= 0;) {
        const auto c = static_cast<size_t>(contact);
        if (IsSolved(contacts.flags[c]) && wakes(contacts.pair[c].bodyA, contacts.pair[c].bodyB)) return true;
    }
    for (int joint = joints.listHead; joint >= 0; joint = joints.info[static_cast<size_t>(joint)].listNext) {
        const JointInfo& info = joints.info[static_cast<size_t>(joint)];
        if (IsSolved(info, bodies) && wakes(info.bodyA, info.bodyB)) return true;
    }
    return false;
}

void GatherActive(const ContactTable& contacts, const JointTable& joints, const BodyTable& bodies,
                  IslandScratch& scratch, IslandTable& active, IsolatedPath path) {
    active.Clear();
    ClearForListed(bodies, scratch.progress);
    const auto note = [&](int body) { scratch.progress[static_cast<size_t>(body)] = IslandScratch::touched; };
    for (const int row : GatherSolved(contacts, scratch.rows)) {
        const ContactPair& pair = contacts.pair[static_cast<size_t>(row)];
        if (!bodies.IsActive(pair.bodyA) && !bodies.IsActive(pair.bodyB)) continue;
        active.contacts.push_back(row);
        note(pair.bodyA), note(pair.bodyB);
    }
    for (int joint = joints.listHead; joint >= 0; joint = joints.info[static_cast<size_t>(joint)].listNext) {
        const JointInfo& info = joints.info[static_cast<size_t>(joint)];
        if (!IsSolved(info, bodies) || (!bodies.IsActive(info.bodyA) && !bodies.IsActive(info.bodyB))) continue;
        active.joints.push_back(joint);
        note(info.bodyA), note(info.bodyB);
    }
    for (const int body : bodies.Listed()) {
        if (!bodies.IsActive(body)) continue;
        const bool isIsolated =
            path == IsolatedPath::apart && scratch.progress[static_cast<size_t>(body)] == IslandScratch::untouched;
        (isIsolated ? active.isolated : active.bodies).push_back(body);
    }
}

}  // namespace scree
