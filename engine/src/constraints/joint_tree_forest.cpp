// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints are coupled where they share a body that can be pushed. Eliminating one couples those that it is coupled with.
// The one with fewest comes next (minimum degree: Tinney and Walker, "Direct Solutions of Sparse Network Equations by
// Optimally Ordered Triangular Factorization", Proc. IEEE 55, 1967). Trees are eliminated from their leaves, and
// nothing new becomes coupled; loops couple a little more.

#include "constraints/joint_tree_forest.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "base/gather_parts.h"

namespace scree {

namespace {

/// Products of blocks that the elimination of a part may take, per joint. Rings, ladders and trusses take up to 7,
/// however long they are; a square net of 5 × 5 bodies takes 11.6, one of 25 × 25 takes 178.
constexpr size_t mostWork = 12;
/// A body with more joints in loops would couple all of them with each other: a net.
constexpr size_t mostJointsOfBody = 24;
/// Fewer joints are not worth sharing.
constexpr int leastJointsToShare = 256;

}  // namespace

size_t JointForest::GetMemoryBytes() const {
    size_t bytes = trees.GetMemoryBytes() + bodies.capacity() * sizeof(TreeBody) +
                   joints.capacity() * sizeof(TreeJoint) + before.capacity() * sizeof(TreeSums) +
                   links.capacity() * sizeof(TreeLink) + m_candidates.capacity() * sizeof(Candidate) +
                   m_shapes.capacity() * sizeof(TreeShape) + m_links.capacity() * sizeof(TreeEdge) +
                   m_isBounded.capacity() + m_rowOf.capacity() * sizeof(int) +
                   (m_keys.capacity() + m_oldKeys.capacity()) * sizeof(Key);
    bytes += nets.GetMemoryBytes() + m_parts.capacity() * sizeof(Part) + m_netOrder.capacity() * sizeof(int) +
             m_members.capacity() * sizeof(JointNet::Member) + m_memberShapes.capacity() * sizeof(TreeShape);
    for (const auto* lists : {&m_near, &m_ofBody, &m_waiting}) {
        for (const std::vector<int>& list : *lists) bytes += list.capacity() * sizeof(int);
    }
    return bytes;
}

int JointForest::RowOf(const BodyTable& table, BodyIndex body) {
    int& row = m_rowOf[body];
    if (row >= 0) return row;
    row = static_cast<int>(bodies.size());
    TreeBody& b = bodies.emplace_back();
    b.body = body;
    const bool moves = table.type[body] == dynamicBody;
    b.invMass = moves ? double{table.mass[body].invMass} : 0.0;
    b.invI = b.steadyInvI = moves ? double{table.mass[body].invI} : 0.0;
    b.spinLeft = 1.0;
    b.isLoaded = b.isForVelocities = false;
    const Rot& q = table.transform[body].q;
    b.startCos = double{q.c}, b.startSin = double{q.s};
    return row;
}

bool JointForest::Moves(int row) const { return bodies[ToSize(row)].invMass > 0.0 || bodies[ToSize(row)].invI > 0.0; }

void JointForest::Collect(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const JointIndex> list) {
    m_keys.resize(list.size());
    m_shapes.resize(list.size());
    m_isBounded.resize(list.size());
    const auto moves = [&](BodyIndex body) {
        const MassRow& mass = bodyTable.mass[body];
        return bodyTable.type[body] == dynamicBody && (mass.invMass > 0.0f || mass.invI > 0.0f);
    };
    pool->For(static_cast<int>(list.size()), leastJointsToShare, [&](int begin, int end, int /*worker*/) {
        for (auto i = ToSize(begin); i < ToSize(end); ++i) {
            bool isBounded = false;
            const bool isExact = MakeTreeShape(bodyTable, jointTable, list[i], m_shapes[i], isBounded);
            m_isBounded[i] = isBounded ? 1 : 0;
            m_keys[i] = {.joint = list[i]};
            if (!isExact) continue;
            const JointInfo& info = jointTable.info[list[i]];
            const bool movesA = moves(info.bodyA), movesB = moves(info.bodyB);
            if (movesA || movesB) m_keys[i] = {list[i], info.bodyA, info.bodyB, m_shapes[i].kind, movesA, movesB, true};
        }
    });
}

/// What is no tree becomes a candidate.
void JointForest::PlanTrees() {
    m_links.clear(), m_candidates.clear();
    for (size_t i = 0; i < m_keys.size(); ++i) {
        const Key& key = m_keys[i];
        const auto shape = static_cast<int>(i);
        if (key.isHeld) m_links.push_back({key.joint, key.bodyA, key.bodyB, key.movesA, key.movesB, key.kind, shape});
    }
    trees.Plan(*pool, m_direct ? std::span<TreeEdge>(m_links) : std::span<TreeEdge>());
    for (const TreeEdge& link : m_links) {
        if (!link.isTree) m_candidates.push_back({.key = link.shape, .a = -1, .b = -1});
    }
}

/// Rows of the bodies of joints that belong to no tree, and to no net that is known.
void JointForest::CollectBodies(const BodyTable& bodyTable) {
    for (const TreeBody& b : bodies) m_rowOf[b.body] = -1;
    m_rowOf.resize(ToSize(bodyTable.slots.Size()), -1);
    bodies.clear();
    for (Candidate& c : m_candidates) {
        if (c.isNet) continue;
        c.a = RowOf(bodyTable, KeyOf(c).bodyA);
        c.b = RowOf(bodyTable, KeyOf(c).bodyB);
    }
}

int JointForest::FindPart(int row) {
    while (m_parts[ToSize(row)].parent != row) {
        int& parent = m_parts[ToSize(row)].parent;
        parent = m_parts[ToSize(parent)].parent;
        row = parent;
    }
    return row;
}

void JointForest::FindParts() {
    m_parts.clear();
    for (size_t row = 0; row < bodies.size(); ++row) m_parts.push_back({.parent = static_cast<int>(row)});
    for (const Candidate& c : m_candidates) {
        if (Moves(c.a) && Moves(c.b)) m_parts[ToSize(FindPart(c.a))].parent = FindPart(c.b);
    }
    for (Candidate& c : m_candidates) {
        c.part = FindPart(Moves(c.a) ? c.a : c.b);
        ++m_parts[ToSize(c.part)].candidates;
        m_parts[ToSize(c.part)].isNet = !m_direct;
    }
}

/// With which others each candidate is coupled.
void JointForest::Couple() {
    for (std::vector<int>& list : m_ofBody) list.clear();
    if (m_ofBody.size() < bodies.size()) m_ofBody.resize(bodies.size());
    if (m_near.size() < m_candidates.size()) m_near.resize(m_candidates.size());
    for (size_t i = 0; i < m_candidates.size(); ++i) {
        Candidate& c = m_candidates[i];
        m_near[i].clear();
        for (const int row : {c.a, c.b}) {
            if (Moves(row) && m_ofBody[ToSize(row)].size() >= mostJointsOfBody) m_parts[ToSize(c.part)].isNet = true;
        }
        if (IsNet(c)) continue;
        for (const int row : {c.a, c.b}) {
            if (!Moves(row)) continue;
            for (const int other : m_ofBody[ToSize(row)]) {
                if (m_near[i].empty() || std::find(m_near[i].begin(), m_near[i].end(), other) == m_near[i].end()) {
                    m_near[i].push_back(other);
                    m_near[ToSize(other)].push_back(static_cast<int>(i));
                }
            }
        }
        for (const int row : {c.a, c.b}) {
            if (Moves(row)) m_ofBody[ToSize(row)].push_back(static_cast<int>(i));
        }
    }
    for (size_t i = 0; i < m_candidates.size(); ++i) std::sort(m_near[i].begin(), m_near[i].end());
}

void JointForest::Enqueue(int candidate) {
    const size_t count = m_near[ToSize(candidate)].size();
    if (m_waiting.size() <= count) m_waiting.resize(count + 1);
    m_waiting[count].push_back(candidate);
}

/// The candidate that is coupled with fewest, −1 at the end.
int JointForest::TakeLeast() {
    for (size_t count = 0; count < m_waiting.size(); ++count) {
        std::vector<int>& list = m_waiting[count];
        while (!list.empty()) {
            const int candidate = list.back();
            list.pop_back();
            const Candidate& c = m_candidates[ToSize(candidate)];
            if (c.place < 0 && !IsNet(c) && m_near[ToSize(candidate)].size() == count) return candidate;
        }
    }
    return -1;
}

/// Those it is coupled with are coupled with each other from now on.
void JointForest::Eliminate(int candidate) {
    Candidate& c = m_candidates[ToSize(candidate)];
    const std::vector<int>& near = m_near[ToSize(candidate)];
    Part& part = m_parts[ToSize(c.part)];
    part.work += near.size() * (near.size() + 1) / 2;
    part.isNet = part.work > mostWork * part.candidates;
    if (part.isNet) return;
    c.place = 0;
    m_order.push_back(candidate);
    for (const int other : near) {
        std::vector<int>& list = m_near[ToSize(other)];
        m_merged.clear();
        std::set_union(list.begin(), list.end(), near.begin(), near.end(), std::back_inserter(m_merged));
        std::erase_if(m_merged, [&](int i) { return i == candidate || i == other; });
        list.assign(m_merged.begin(), m_merged.end());
        Enqueue(other);
    }
}

void JointForest::Order() {
    m_order.clear();
    for (std::vector<int>& list : m_waiting) list.clear();
    for (size_t i = m_candidates.size(); i-- > 0;) Enqueue(static_cast<int>(i));
    for (int next = TakeLeast(); next >= 0; next = TakeLeast()) Eliminate(next);
}

/// Parts that turned out to be nets on the way.
void JointForest::LeaveOutNets() {
    std::erase_if(m_order, [&](int candidate) { return IsNet(m_candidates[ToSize(candidate)]); });
    for (size_t place = 0; place < m_order.size(); ++place)
        m_candidates[ToSize(m_order[place])].place = static_cast<int>(place);

    m_netOrder.clear();
    for (size_t i = 0; i < m_candidates.size(); ++i) {
        if (!IsNet(m_candidates[i])) continue;
        m_candidates[i].isNet = true;
        m_netOrder.push_back(static_cast<int>(i));
    }
    ColourNets();
}

/// Each joint in the first colour that no other joint of its bodies has.
void JointForest::ColourNets() {
    std::vector<uint64_t> taken(bodies.size(), 0);
    std::vector<int> colours(m_candidates.size(), 0);
    for (const int candidate : m_netOrder) {
        const Candidate& c = m_candidates[ToSize(candidate)];
        uint64_t others = 0;
        for (const int row : {c.a, c.b}) others |= Moves(row) ? taken[ToSize(row)] : 0;
        const int colour = std::countr_one(others);
        colours[ToSize(candidate)] = colour;
        if (colour == JointNet::mostColours) continue;
        for (const int row : {c.a, c.b}) {
            if (Moves(row)) taken[ToSize(row)] |= uint64_t{1} << colour;
        }
    }
    std::stable_sort(m_netOrder.begin(), m_netOrder.end(),
                     [&](int a, int b) { return colours[ToSize(a)] < colours[ToSize(b)]; });
    m_members.clear();
    for (const int candidate : m_netOrder) {
        const Key& key = KeyOf(m_candidates[ToSize(candidate)]);
        m_members.push_back({key.joint, key.bodyA, key.bodyB, key.movesA, key.movesB, colours[ToSize(candidate)]});
    }
}

void JointForest::MakeLinks() {
    joints.clear(), links.clear();
    for (const int candidate : m_order) {
        const Candidate& c = m_candidates[ToSize(candidate)];
        std::vector<int>& near = m_near[ToSize(candidate)];
        for (int& other : near) other = m_candidates[ToSize(other)].place;
        std::sort(near.begin(), near.end());
        TreeJoint& joint = joints.emplace_back();
        joint.joint = KeyOf(c).joint;
        joint.a = c.a, joint.b = c.b;
        joint.part = c.part;
        joint.rows.count = RowCount(KeyOf(c).kind);
        joint.linkBegin = static_cast<int>(links.size());
        for (const int later : near) links.push_back({later, {}});
        joint.linkEnd = static_cast<int>(links.size());
    }
}

void JointForest::PlanAll(const BodyTable& bodyTable) {
    m_isPlanned = false;
    PlanTrees();
    CollectBodies(bodyTable);
    FindParts();
    Couple();
    Order();
    LeaveOutNets();
    CollectBodies(bodyTable);
    MakeLinks();
    m_oldKeys = m_keys;
    m_isPlanned = true;
}

/// What may change from step to step under the same order.
void JointForest::Refresh(const BodyTable& bodyTable, const JointTable& jointTable, const How& how) {
    const double recentScale = how.recentScale;
    const LoadBearers* bearers = how.bearers != nullptr && !how.bearers->IsEmpty() ? how.bearers : nullptr;
    trees.Refresh(*pool, bodyTable, jointTable, {m_shapes, recentScale, compliance, bearers});
    if (bearers != nullptr) MarkLoaded(*bearers);
    const auto shapeOf = [this](int candidate) { return m_shapes[ToSize(m_candidates[ToSize(candidate)].key)]; };
    m_memberShapes.clear();
    for (const int candidate : m_netOrder) m_memberShapes.push_back(shapeOf(candidate));
    nets.Take(bodyTable, jointTable, m_members, m_memberShapes, recentScale);
    for (size_t i = 0; i < joints.size(); ++i) {
        TreeJoint& joint = joints[i];
        joint.shape = shapeOf(m_order[i]);
        for (double& t : joint.total) t = 0.0;
        LoadImpulse(joint.joint, jointTable, recentScale, joint.recent);
    }
}

void JointForest::MarkLoaded(const LoadBearers& bearers) {
    const std::vector<uint8_t> areLoaded = ChooseParts([&](const TreeBody& b) { return bearers.Has(b.body); });
    for (const TreeJoint& joint : joints) {
        if (areLoaded[ToSize(joint.part)] == 0) continue;
        for (const int row : {joint.a, joint.b}) bodies[ToSize(row)].isLoaded = true;
    }
}

void JointForest::ListOthers() {
    GatherParts<JointIndex, 2>(
        *pool, static_cast<int>(m_keys.size()), leastJointsToShare, {&others, &bounded},
        [&](int begin, int end, const std::array<JointIndex*, 2>& places) {
            JointIndex *other = places[0], *some = places[1];
            for (auto i = ToSize(begin); i < ToSize(end); ++i) {
                const Key& key = m_keys[i];
                if (!key.isHeld) *other++ = key.joint;
                if (key.isHeld && m_isBounded[i] != 0) *some++ = key.joint;
            }
            return std::array{static_cast<size_t>(other - places[0]), static_cast<size_t>(some - places[1])};
        });
}

void JointForest::Build(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const JointIndex> list,
                        How how) {
    pool = &how.pool;
    compliance = how.compliance;
    Collect(bodyTable, jointTable, list);
    if (m_isPlanned && m_keys == m_oldKeys && m_direct == how.direct) {
        CollectBodies(bodyTable);
    } else {
        m_direct = how.direct;
        PlanAll(bodyTable);
    }
    Refresh(bodyTable, jointTable, how);
    ListOthers();
}

}  // namespace scree
