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
/// By the largest errors after a move with what was aimed at, and with the velocities before it. A whip may turn far in
/// good order, but not by two radians.
inline bool Misleads(double left, double aimed, double coasted) {
    return TurnsTooFar(left) && (aimed > coasted || left > 4.0);
}

/// Replaces the first `count` rows of a symmetric matrix by its inverse. Rows whose pivot is only rounding beside
/// `scale` get zeros: they repeat others.
void InvertRows(double (&m)[maxTreeRows][maxTreeRows], int count, const double (&scale)[maxTreeRows]);
/// From the rows of all joints at the present poses: their pivots' inverses and the blocks of L.
void FactorizeForest(JointForest& forest, double compliance);
/// Right sides → impulses, which are added to the joints' sums and push the bodies.
void SolveForest(JointForest& forest);

}  // namespace scree
