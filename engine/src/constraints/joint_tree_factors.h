// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The direct solve over a forest of joints: G·M⁻¹·Gᵀ as a block LDLᵀ without fill-in, in time that grows with the
// number of joints.

#pragma once

#include "constraints/joint_tree_forest.h"

namespace scree {

/// The spin with which a solve on velocities begins that takes a body for more inert than it is. Of `last`, what the
/// solve before ended with, `left` stays, since the inertia has grown. What contacts and forces have brought since then
/// was made with the body's own inertia: without the last factor it would bring energy.
inline double TakeSpin(double spin, double last, double left, double invI, double steadyInvI) {
    if (!(steadyInvI < invI) && left == 1.0) return spin;
    return left * last + (spin - last) * (steadyInvI / invI);
}

// Joints that are open, as where anchors were not made to meet, may ask for turns that the Jacobians of the present
// pose know nothing of. A chain that is nearly straight would rather turn its links far than move a load at its end,
// which closes nothing and throws them. Such a solve is done again with joints that give way, the more, the less that
// helps. They close in the next sub-steps then. Source: Levenberg, "A Method for the Solution of Certain Non-Linear
// Problems in Least Squares", 1944.
inline constexpr double leastGive = 1e-4, mostGive = 1.0, giveFactor = 10.0;  ///< as jointCompliance
/// By what the new turns may leave of an error, in shares of an arm: rad².
inline bool TurnsTooFar(double left) { return left > 0.1; }
/// Of a tree: where velocities lead, and their energy.
struct TreeCourse {
    double error = 0.0;   ///< largest of a joint after a move
    double energy = 0.0;  ///< twice the kinetic
};
/// True if an aim is to be done again: large turns leave more open than there was, or double the energy. A whip may
/// turn far in good order, but what closes a gap that fast throws what it closed.
inline bool Misleads(double left, const TreeCourse& aimed, const TreeCourse& coasted) {
    return TurnsTooFar(left) && (aimed.error > coasted.error || aimed.energy > 2.0 * coasted.energy);
}
/// What a body with the inertia of the solve adds to TreeCourse::energy.
inline double EnergyOf(const double* velocity, double invMass, double steadyInvI) {
    const double moving = invMass > 0.0 ? (velocity[0] * velocity[0] + velocity[1] * velocity[1]) / invMass : 0.0;
    return moving + (steadyInvI > 0.0 ? velocity[2] * velocity[2] / steadyInvI : 0.0);
}

/// Replaces the first `count` rows of a symmetric matrix by its inverse. Rows whose pivot is only rounding beside
/// `scale` get zeros: they repeat others.
void InvertRows(double (&m)[maxTreeRows][maxTreeRows], int count, const double (&scale)[maxTreeRows]);
/// From the rows of all joints at the present poses: their pivots' inverses and the blocks of L.
void FactorizeForest(JointForest& forest, double compliance);
/// Right sides → impulses, which are added to the joints' sums and push the bodies.
void SolveForest(JointForest& forest);

}  // namespace scree
