// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A direct solve of joints whose bodies form trees: chains, bridges between fixed points, ragdolls, cars. All joints of
// a tree are held at once, exactly, in time that grows with their number, however unequal the masses are.
//
// The rows of all joints form the system G·M⁻¹·Gᵀ·λ = b. Taken from the leaves to the root, a joint is coupled with the
// joints after it on one body only. So elimination makes nothing new (Baraff, "Linear-Time Dynamics using Lagrange
// Multipliers", SIGGRAPH 1996). It is a block LDLᵀ in a perfect elimination order of a chordal graph, in double.
//
// In time the joints are held as by RATTLE (Andersen, "Rattle: a 'velocity' version of the Shake algorithm", J. Comput.
// Phys. 52, 1983; Hairer, Lubich, Wanner, "Geometric Numerical Integration", 2006, VII.1.4). Before a move come
// impulses along the Jacobians of the present pose such that the joints are closed at the next pose. After it come
// impulses that leave no speed along the joints. Both push at shared points, so momentum and angular momentum are kept.

#pragma once

#include <memory>
#include <span>

#include "base/task_pool.h"
#include "constraints/joint_net.h"
#include "constraints/joint_phases.h"
#include "constraints/joint_tree_rows.h"
#include "constraints/load_bearers.h"

namespace scree {

class JointForest;

struct JointTreeInput {
    TaskPool& pool;  ///< shares trees, until the next Build
    const BodyTable& bodies;
    const JointTable& joints;
    std::span<const JointIndex> list;  ///< joints to hold
    float substepScale;                ///< makes impulses of a sub-step of those that the joints keep
    double compliance = jointCompliance;
    bool direct = true;                    ///< otherwise all are taken for nets
    const LoadBearers* bearers = nullptr;  ///< their trees count as loaded until the next Build; may be null
};

class JointTree {
public:
    JointTree();
    ~JointTree();
    JointTree(const JointTree&) = delete;
    JointTree& operator=(const JointTree&) = delete;

    /// Finds the trees among the joints. O(bodies + joints).
    void Build(const JointTreeInput& input);
    [[nodiscard]] bool IsEmpty() const;
    /// Joints of the list of types without exact rows, in its order.
    [[nodiscard]] std::span<const JointIndex> GetOthers() const;
    /// Those of the rest that have limits, motors or springs besides.
    [[nodiscard]] std::span<const JointIndex> GetBounded() const;

    /// Where bodies stand within the step.
    struct Poses {
        const BodyTable& bodies;                   ///< start positions of the step
        const Column<BodyIndex, Velocity>& delta;  ///< per body: motion since then
    };
    /// At the present poses, from which both solves below take their Jacobians. `h` is the length of a sub-step, s.
    void Factorize(const Poses& poses, float h);
    /// Changes velocities so that a move of `h` seconds ends with closed joints, to O(h³).
    void SolveBeforeMove(const Poses& poses, float h, Column<BodyIndex, Velocity>& velocity);
    /// Removes all speed along the joints; after Factorize at the new poses.
    void SolveAfterMove(Column<BodyIndex, Velocity>& velocity);
    /// Factorize and SolveAfterMove: what is read for the one is still in the cache for the other.
    void FactorizeAndStop(const Poses& poses, float h, Column<BodyIndex, Velocity>& velocity);
    /// Joints that are so much coupled that they are solved in turn; of them only Build and Store are here.
    [[nodiscard]] JointNet& GetNets();
    /// Writes the impulses of the last two solves, times `scale`, into the joints.
    void Store(float scale, JointTable& joints) const;
    /// After a step of `dt` seconds: raises BodyDemand::pullRate to √(T/(m·l)) of a pull T of a joint at a link of mass
    /// m and length l, 1/s. A step needs at least twice as many sub-steps as it has such times, or the pull swings its
    /// links too far in one.
    void NotePullRates(float dt, Column<BodyIndex, BodyDemand>& demand) const;
    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    void FactorizeLoops(const Poses& poses, float h);
    void StopLoops(Column<BodyIndex, Velocity>& velocity);

    std::unique_ptr<JointForest> m;
};

}  // namespace scree
