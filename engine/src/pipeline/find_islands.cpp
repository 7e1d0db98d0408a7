// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Islands by depth-first search over an adjacency built anew from the touching contacts: a counting sort costs a few
// nanoseconds a contact and spares every contact its four list links.

#include "pipeline/find_islands.h"

#include <algorithm>

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

/// Makes the column 0 for all movers, static bodies left aside if they are many: in mostly static worlds their rows
/// would cost more than the rest.
template <typename T>
void ClearForMovers(const BodyTable& bodies, std::vector<T>& column) {
    EnsureRows(column, static_cast<size_t>(bodies.slots.Size()));
    if (bodies.movers.size() * 8 >= column.size()) {
        std::fill(column.begin(), column.end(), T{0});
        return;
    }
    for (const int body : bodies.movers) column[static_cast<size_t>(body)] = 0;
}

/// The rows of the solved contacts. The choice is no branch, for it follows no pattern.
std::span<const int> GatherSolved(const ContactTable& contacts, std::vector<int>& rows) {
    const size_t count = contacts.flags.size();
    EnsureRows(rows, count);
    size_t used = 0;
    for (size_t c = 0; c < count; ++c) {
        rows[used] = static_cast<int>(c);
        used += IsSolved(contacts.flags[c]) ? 1 : 0;
    }
    return {rows.data(), used};
}

/// Contacts of each mover that has some, the newest row first; these movers become `touched`, the others `untouched`.
/// Returns the number of contacts.
size_t BuildAdjacency(const ContactTable& contacts, const BodyTable& bodies, IslandScratch& s) {
    ClearForMovers(bodies, s.end);
    ClearForMovers(bodies, s.progress);
    EnsureRows(s.first, s.end.size());
    const std::span<const int> rows = GatherSolved(contacts, s.rows);
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
    IslandSearch(JointTable& joints, BodyTable& bodies, IslandScratch& scratch, IslandTable& islands)
        : m_joints(joints),
          m_bodies(bodies),
          m_scratch(scratch),
          m_islands(islands),
          m_anyJoints(joints.listHead >= 0) {}

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
            m_bodies.flags[static_cast<size_t>(body)] |= BodyFlag::awake;
            VisitContacts(body);
            VisitJoints(body);
        }
        island.bodyEnd = static_cast<int>(m_islands.bodies.size());
        island.contactEnd = static_cast<int>(m_islands.contacts.size());
        island.jointEnd = static_cast<int>(m_islands.joints.size());
        m_islands.islands.push_back(island);
    }

private:
    void Reach(int body, bool isTouched) {
        m_scratch.progress[static_cast<size_t>(body)] = isTouched ? IslandScratch::seen : IslandScratch::seenUntouched;
        m_scratch.stack.push_back(body);
    }

    void ReachOther(int other) {
        if (m_bodies.type[static_cast<size_t>(other)] == staticBody) return;
        const uint8_t progress = m_scratch.progress[static_cast<size_t>(other)];
        if (progress < IslandScratch::seen) Reach(other, progress == IslandScratch::touched);
    }

    void VisitContacts(int body) {
        const auto b = static_cast<size_t>(body);
        if (m_scratch.progress[b] != IslandScratch::seen) return;
        m_scratch.progress[b] = IslandScratch::visited;
        for (int e = m_scratch.first[b]; e < m_scratch.end[b]; ++e) {
            const IslandScratch::Entry entry = m_scratch.entries[static_cast<size_t>(e)];
            const uint8_t progress =
                entry.other < 0 ? uint8_t{IslandScratch::seen} : m_scratch.progress[static_cast<size_t>(entry.other)];
            if (progress == IslandScratch::visited) continue;  // it has listed the contact
            m_islands.contacts.push_back(entry.contact);
            if (progress < IslandScratch::seen) Reach(entry.other, true);
        }
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

    JointTable& m_joints;
    BodyTable& m_bodies;
    IslandScratch& m_scratch;
    IslandTable& m_islands;
    const bool m_anyJoints;  ///< the rows of bodies that know theirs are seldom in the cache
};

}  // namespace

void FindIslands(const ContactTable& contacts, JointTable& joints, BodyTable& bodies, IslandScratch& scratch,
                 IslandTable& islands, IsolatedPath path) {
    islands.Clear();
    islands.contacts.reserve(BuildAdjacency(contacts, bodies, scratch));
    scratch.jointSeen.assign(joints.info.size(), 0);

    const bool anyJoints = joints.listHead >= 0;
    IslandSearch search(joints, bodies, scratch, islands);
    for (size_t m = bodies.movers.size(); m-- > 0;) {  // newest first, as Box2D walks its body list
        const int body = bodies.movers[m];
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
    const size_t awakeCount = bodies.movers.size();
    bool allAwake = true;
    for (size_t m = 0; m < awakeCount; ++m) {
        const int body = bodies.movers[m];
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
    for (size_t c = 0; c < contacts.flags.size(); ++c) {
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
    ClearForMovers(bodies, scratch.progress);
    const auto note = [&](int body) { scratch.progress[static_cast<size_t>(body)] = IslandScratch::touched; };
    for (size_t c = 0; c < contacts.flags.size(); ++c) {
        if (!IsSolved(contacts.flags[c])) continue;
        const ContactPair& pair = contacts.pair[c];
        if (!bodies.IsActive(pair.bodyA) && !bodies.IsActive(pair.bodyB)) continue;
        active.contacts.push_back(static_cast<int>(c));
        note(pair.bodyA), note(pair.bodyB);
    }
    for (int joint = joints.listHead; joint >= 0; joint = joints.info[static_cast<size_t>(joint)].listNext) {
        const JointInfo& info = joints.info[static_cast<size_t>(joint)];
        if (!IsSolved(info, bodies) || (!bodies.IsActive(info.bodyA) && !bodies.IsActive(info.bodyB))) continue;
        active.joints.push_back(joint);
        note(info.bodyA), note(info.bodyB);
    }
    for (const int body : bodies.movers) {
        if (!bodies.IsActive(body)) continue;
        const bool isIsolated =
            path == IsolatedPath::apart && scratch.progress[static_cast<size_t>(body)] == IslandScratch::untouched;
        (isIsolated ? active.isolated : active.bodies).push_back(body);
    }
}

}  // namespace scree
