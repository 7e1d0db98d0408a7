// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The joints that a direct solve takes over. Trees go to groves. Of loops, and what hangs on them, it has the
// order in which they are eliminated, and which are coupled with which later ones. It also has the numbers that factors
// and motion work on. Nets, whose elimination would cost too much, go to soft rows.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "constraints/joint_groves.h"
#include "constraints/joint_net.h"
#include "constraints/joint_tree_rows.h"
#include "constraints/load_bearers.h"

namespace scree {

struct TreeBody {
    BodyIndex body;
    double invMass, invI;  ///< 0 if joints cannot push it
    double steadyInvI;     ///< of the solve: smaller where a pull would swing the body too far in a sub-step
    double spinLeft;       ///< share of the spin of the last solve, TakeSpin
    double pull;           ///< sub-step times what recent pulls turn it back with
    double startCos, startSin;
    TreePose pose, next;   ///< now, and where its velocity leads
    double v[3];           ///< x, y, turning; of the last solve
    double coasted[3];     ///< these before the last aim
    double left;           ///< the most that its turn in the last aim may leave of an error, in shares of an arm
    bool isLoaded;         ///< a body of its loops bears a load
    bool isForVelocities;  ///< the factors are not for aiming
};

/// Coupling of a joint with a later one: first G·M⁻¹·Gᵀ, then the block of L.
struct TreeLink {
    int later;
    double block[maxTreeRows][maxTreeRows];  ///< [row of the later joint][row of this one]
};

struct TreeSums {
    double total[maxTreeRows];   ///< impulses of the step
    double recent[maxTreeRows];  ///< impulses since bodies last moved
};

struct TreeJoint : TreeSums {
    TreeShape shape;
    JointIndex joint;
    int a, b;                ///< rows of the bodies
    int part;                ///< those of one number may be coupled
    int linkBegin, linkEnd;  ///< in the order of elimination
    double give;             ///< compliance beside that of all
    double coasted;          ///< largest error to which the velocities before an aim lead
    TreeRows rows;
    double inverse[maxTreeRows][maxTreeRows];  ///< of its pivot
    double rhs[maxTreeRows];                   ///< right side, then impulses
};

class JointForest {
public:
    JointGroves trees;
    JointNet nets;
    std::vector<TreeBody> bodies;     ///< of `joints`
    std::vector<TreeJoint> joints;    ///< not of trees, in the order of elimination
    std::vector<TreeSums> before;     ///< of `joints`, before an aim
    std::vector<TreeLink> links;      ///< of each joint, [linkBegin, linkEnd)
    std::vector<JointIndex> others;   ///< joints of the list that are no candidates
    std::vector<JointIndex> bounded;  ///< joints held here that have limits, motors or springs besides
    TaskPool* pool = nullptr;         ///< shares trees
    double compliance = 0.0;          ///< of `joints`
    bool isForVelocities = false;     ///< some factors of `joints` are not for aiming

    struct How {
        double recentScale;          ///< makes impulses of a sub-step of the stored ones
        double compliance;           ///< jointCompliance
        bool direct;                 ///< otherwise all joints are taken for nets
        TaskPool& pool;              ///< until the next call
        const LoadBearers* bearers;  ///< may be null
    };
    /// Finds the joints to hold and their order, which stays while the same joints hold the same bodies. O(bodies +
    /// joints) for trees.
    void Build(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const JointIndex> list, How how);
    [[nodiscard]] size_t GetMemoryBytes() const;

    /// By TreeJoint::part: 1 if isChosen(body) of one of its bodies.
    template <typename IsChosen>
    [[nodiscard]] std::vector<uint8_t> ChooseParts(IsChosen&& isChosen) const {
        std::vector<uint8_t> chosen(m_parts.size(), 0);
        for (const TreeJoint& joint : joints) {
            for (const int row : {joint.a, joint.b}) {
                if (isChosen(bodies[ToSize(row)])) chosen[ToSize(joint.part)] = 1;
            }
        }
        return chosen;
    }

    /// Calls visit(const TreeResult&) for each joint; on the workers of the pool.
    template <typename Visit>
    void ForEachResult(TaskPool& workers, Visit&& visit) const {
        trees.ForEachResult(workers, visit);
        ForEachResultBut(visit);
    }
    template <typename Visit>
    void ForEachResult(Visit&& visit) const {
        trees.ForEachResult(visit);
        ForEachResultBut(visit);
    }

private:
    /// Without the trees.
    template <typename Visit>
    void ForEachResultBut(Visit&& visit) const {
        nets.ForEachResult(visit);
        const auto side = [&](int row) {
            const TreeBody& b = bodies[ToSize(row)];
            return TreeResult::Side{b.body, b.invMass, b.invI};
        };
        for (const TreeJoint& joint : joints)
            visit(TreeResult{joint.joint, joint.shape, joint.rows, joint.total, side(joint.a), side(joint.b)});
    }

    /// A joint to hold that belongs to no tree.
    struct Candidate {
        int key;         ///< its place in the list of joints
        int a, b;        ///< rows of its bodies
        int place = -1;  ///< in the order of elimination
        int part = -1;   ///< what it is connected with, by a row of it
        bool isNet = false;
    };
    /// Bodies that joints connect, statics not counted. One per row; those count that stand for the others.
    struct Part {
        int parent;  ///< union-find
        size_t candidates = 0;
        size_t work = 0;  ///< of its elimination so far: products of blocks
        bool isNet = false;
    };
    /// What an order depends on.
    struct Key {
        JointIndex joint;
        BodyIndex bodyA = BodyIndex::none, bodyB = BodyIndex::none;
        TreeKind kind = {};
        bool movesA = false, movesB = false;
        bool isHeld = false;  ///< a joint to hold; of others nothing else is told
        bool operator==(const Key&) const = default;
    };

    int RowOf(const BodyTable& table, BodyIndex body);
    [[nodiscard]] bool Moves(int row) const;
    void Collect(const BodyTable& bodyTable, const JointTable& jointTable, std::span<const JointIndex> list);
    void PlanAll(const BodyTable& bodyTable);
    void PlanTrees();
    void CollectBodies(const BodyTable& bodyTable);
    int FindPart(int row);
    void FindParts();
    [[nodiscard]] bool IsNet(const Candidate& c) const { return c.part >= 0 && m_parts[ToSize(c.part)].isNet; }
    void Couple();
    void Order();
    void LeaveOutNets();
    void ColourNets();
    void ListOthers();
    void Enqueue(int candidate);
    int TakeLeast();
    void Eliminate(int candidate);
    void MakeLinks();
    void Refresh(const BodyTable& bodyTable, const JointTable& jointTable, const How& how);
    void MarkLoaded(const LoadBearers& bearers);

    [[nodiscard]] const Key& KeyOf(const Candidate& c) const { return m_keys[ToSize(c.key)]; }

    std::vector<Key> m_keys;           ///< of the list
    std::vector<TreeShape> m_shapes;   ///< of the list
    std::vector<uint8_t> m_isBounded;  ///< of the list: it has limits, motors or springs besides
    std::vector<Key> m_oldKeys;        ///< of the order that is there
    bool m_direct = true, m_isPlanned = true;
    std::vector<Candidate> m_candidates;
    std::vector<TreeEdge> m_links;            ///< of joints to hold
    Column<BodyIndex, int> m_rowOf;           ///< per body of the world, −1: none
    std::vector<std::vector<int>> m_near;     ///< per candidate: those it is coupled with, rising
    std::vector<std::vector<int>> m_ofBody;   ///< per row: its candidates
    std::vector<std::vector<int>> m_waiting;  ///< candidates by how many they are coupled with; some out of date
    std::vector<Part> m_parts;                ///< per row
    std::vector<int> m_netOrder;              ///< candidates that are, by colour
    std::vector<JointNet::Member> m_members;  ///< these
    std::vector<TreeShape> m_memberShapes;    ///< of these
    std::vector<int> m_order;                 ///< candidates as they are eliminated
    std::vector<int> m_merged;                ///< scratch of Eliminate
};

}  // namespace scree
