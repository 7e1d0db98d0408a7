// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The forest that joints make of bodies, and the order in which its joints are eliminated: which joints form trees,
// which are coupled with which, and the numbers of each that factors and motion work on.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "constraints/joint_tree_rows.h"

namespace scree {

struct TreeBody {
    int body;
    double invMass, invI;  ///< 0 if joints cannot push it
    double startCos, startSin;
    TreePose pose, next;  ///< now, and where its velocity leads
    double v[3];          ///< x, y, turning
};

/// Coupling of a joint with a later one on the same body: first G·M⁻¹·Gᵀ, then the block of L.
struct TreeLink {
    int later;
    double block[maxTreeRows][maxTreeRows];  ///< [row of the later joint][row of this one]
};

struct TreeJoint {
    TreeShape shape;
    int joint;
    int a, b;  ///< rows of the bodies
    int up;    ///< the one on which it is coupled with later joints
    int linkBegin, linkEnd;
    TreeRows rows;
    double inverse[maxTreeRows][maxTreeRows];  ///< of its pivot
    double rhs[maxTreeRows];                   ///< right side, then impulses
    double total[maxTreeRows];                 ///< impulses of the step
};

class JointForest {
public:
    std::vector<TreeBody> bodies;
    std::vector<TreeJoint> joints;  ///< in the order of elimination: from the leaves
    std::vector<TreeLink> links;    ///< of each joint, [linkBegin, linkEnd)
    std::vector<int> others;        ///< joints of the list that belong to no tree
    std::vector<int> bounded;       ///< joints of trees that have limits, motors or springs besides

    /// Finds the trees among the joints of the list. O(bodies + joints).
    void Build(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const int> list);
    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    struct Candidate {
        int joint, a, b;
        TreeShape shape;
        bool bounded, used;
        int place;  ///< in the order of elimination
    };

    int RowOf(const BodyTable& table, int body);
    [[nodiscard]] bool Moves(int row) const;
    int Root(int row);
    void Join(int a, int b);
    void Collect(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const int> list);
    void FindTrees();
    void Order();
    void LinkList(int row);
    void MakeJoints();

    // Scratch of Build.
    std::vector<Candidate> m_candidates;
    std::vector<int> m_rowOf;             ///< per body of the world, −1: none
    std::vector<int> m_parent;            ///< union–find over rows
    std::vector<uint8_t> m_spoilt;        ///< per row: its tree is none
    std::vector<int> m_first, m_entries;  ///< per row: its candidates
    std::vector<int> m_order;             ///< bodies breadth first
    std::vector<int> m_parentJoint;       ///< per row: candidate towards the root
    std::vector<int> m_list;              ///< one body's candidates
};

}  // namespace scree
