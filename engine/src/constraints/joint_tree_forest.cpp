// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Trees by union–find over the bodies that can be pushed, their bodies breadth first, and their joints from the leaves:
// a joint is then coupled with later joints of one body only.

#include "constraints/joint_tree_forest.h"

#include <algorithm>

namespace scree {

namespace {

/// A body with more joints than this would couple all of them with each other.
constexpr int mostJointsOfBody = 12;

size_t At(int index) { return static_cast<size_t>(index); }

}  // namespace

size_t JointForest::GetMemoryBytes() const {
    return bodies.capacity() * sizeof(TreeBody) + joints.capacity() * sizeof(TreeJoint) +
           links.capacity() * sizeof(TreeLink) + m_candidates.capacity() * sizeof(Candidate) +
           (m_rowOf.capacity() + m_entries.capacity()) * sizeof(int);
}

int JointForest::RowOf(const BodyTable& table, int body) {
    int& row = m_rowOf[At(body)];
    if (row >= 0) return row;
    row = static_cast<int>(bodies.size());
    TreeBody& b = bodies.emplace_back();
    b.body = body;
    const bool moves = table.type[At(body)] == dynamicBody;
    b.invMass = moves ? double{table.mass[At(body)].invMass} : 0.0;
    b.invI = moves ? double{table.mass[At(body)].invI} : 0.0;
    const Rot& q = table.transform[At(body)].q;
    b.startCos = double{q.c}, b.startSin = double{q.s};
    m_parent.push_back(row);
    m_spoilt.push_back(0);
    return row;
}

bool JointForest::Moves(int row) const { return bodies[At(row)].invMass > 0.0 || bodies[At(row)].invI > 0.0; }
int JointForest::Root(int row) {
    while (m_parent[At(row)] != row) row = m_parent[At(row)] = m_parent[At(m_parent[At(row)])];
    return row;
}

/// A joint between two movers joins their trees, or closes a loop.
void JointForest::Join(int a, int b) {
    if (!Moves(a) || !Moves(b)) return;
    const int rootA = Root(a), rootB = Root(b);
    if (rootA == rootB) {
        m_spoilt[At(rootA)] = 1;
        return;
    }
    m_parent[At(std::max(rootA, rootB))] = std::min(rootA, rootB);
    m_spoilt[At(std::min(rootA, rootB))] |= m_spoilt[At(std::max(rootA, rootB))];
}

void JointForest::Collect(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const int> list) {
    for (const TreeBody& b : bodies) m_rowOf[At(b.body)] = -1;
    m_rowOf.resize(At(bodyTable.slots.Size()), -1);
    bodies.clear(), m_parent.clear(), m_spoilt.clear(), m_candidates.clear();
    others.clear(), bounded.clear();
    for (const int joint : list) {
        Candidate c{joint, -1, -1, {}, false, false, -1};
        if (!MakeTreeShape(bodyTable, jointTable, joint, c.shape, c.bounded)) continue;
        const JointInfo& info = jointTable.info[At(joint)];
        c.a = RowOf(bodyTable, info.bodyA);
        c.b = RowOf(bodyTable, info.bodyB);
        if (Moves(c.a) || Moves(c.b)) m_candidates.push_back(c);
    }
}

void JointForest::FindTrees() {
    m_first.assign(bodies.size() + 1, 0);
    for (const Candidate& c : m_candidates) {
        Join(c.a, c.b);
        ++m_first[At(c.a)], ++m_first[At(c.b)];
    }
    int total = 0;
    for (size_t row = 0; row < bodies.size(); ++row) {
        if (Moves(static_cast<int>(row)) && m_first[row] > mostJointsOfBody)
            m_spoilt[At(Root(static_cast<int>(row)))] = 1;
        total += m_first[row];
        m_first[row] = total;  // the end; filling moves it to the start
    }
    m_first[bodies.size()] = total;
    m_entries.resize(At(total));
    for (size_t i = m_candidates.size(); i-- > 0;) {
        Candidate& c = m_candidates[i];
        m_entries[At(--m_first[At(c.a)])] = m_entries[At(--m_first[At(c.b)])] = static_cast<int>(i);
        c.used = m_spoilt[At(Root(Moves(c.a) ? c.a : c.b))] == 0;
    }
}

/// Bodies breadth first from the first of each tree.
void JointForest::Order() {
    m_order.clear();
    m_parentJoint.assign(bodies.size(), -2);  // not seen
    for (size_t start = 0; start < bodies.size(); ++start) {
        const int root = static_cast<int>(start);
        if (m_parentJoint[start] != -2 || !Moves(root) || m_spoilt[At(Root(root))] != 0) continue;
        m_parentJoint[start] = -1;
        m_order.push_back(root);
        for (size_t next = m_order.size() - 1; next < m_order.size(); ++next) {
            const int row = m_order[next];
            for (int e = m_first[At(row)]; e < m_first[At(row) + 1]; ++e) {
                const Candidate& c = m_candidates[At(m_entries[At(e)])];
                const int other = c.a == row ? c.b : c.a;
                if (!Moves(other) || m_parentJoint[At(other)] != -2) continue;
                m_parentJoint[At(other)] = m_entries[At(e)];
                m_order.push_back(other);
            }
        }
    }
}

/// One body's joints, the one towards the root last.
void JointForest::LinkList(int row) {
    m_list.clear();
    for (int e = m_first[At(row)]; e < m_first[At(row) + 1]; ++e) {
        if (m_entries[At(e)] != m_parentJoint[At(row)]) m_list.push_back(m_entries[At(e)]);
    }
}

void JointForest::MakeJoints() {
    // From the leaves: the joints of a body but the one towards the root.
    joints.clear(), links.clear();
    for (size_t i = m_order.size(); i-- > 0;) {
        LinkList(m_order[i]);
        for (const int at : m_list) {
            Candidate& c = m_candidates[At(at)];
            c.place = static_cast<int>(joints.size());
            TreeJoint& joint = joints.emplace_back();
            joint.shape = c.shape;
            joint.joint = c.joint;
            joint.a = c.a, joint.b = c.b;
            joint.up = m_order[i];
            joint.linkBegin = joint.linkEnd = 0;
            for (double& t : joint.total) t = 0.0;
            joint.rows.count = RowCount(c.shape.kind);
        }
    }
    for (size_t i = m_order.size(); i-- > 0;) {
        LinkList(m_order[i]);
        const size_t own = m_list.size();
        if (m_parentJoint[At(m_order[i])] >= 0) m_list.push_back(m_parentJoint[At(m_order[i])]);
        for (size_t p = 0; p < own; ++p) {
            TreeJoint& joint = joints[At(m_candidates[At(m_list[p])].place)];
            joint.linkBegin = static_cast<int>(links.size());
            for (size_t q = p + 1; q < m_list.size(); ++q) links.push_back({m_candidates[At(m_list[q])].place, {}});
            joint.linkEnd = static_cast<int>(links.size());
        }
    }
}

void JointForest::Build(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const int> list) {
    Collect(bodyTable, jointTable, list);
    FindTrees();
    Order();
    MakeJoints();
    size_t next = 0;
    for (const int joint : list) {
        const bool isCandidate = next < m_candidates.size() && m_candidates[next].joint == joint;
        if (!isCandidate || !m_candidates[next].used) others.push_back(joint);
        if (isCandidate && m_candidates[next].used && m_candidates[next].bounded) bounded.push_back(joint);
        next += isCandidate ? 1 : 0;
    }
}

}  // namespace scree
