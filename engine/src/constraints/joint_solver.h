// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The joints of an island, whatever their types: prepare, iterate on velocities, iterate on positions.

#pragma once

#include <span>

#include "constraints/joint_phases.h"

namespace scree {

/// To be called once in a step before the others, if there are joints that a direct solve holds.
void PlanBounds(const JointTask& task, std::span<const JointIndex> bounded);
/// Makes the constraints of these joints, in this order, and warm-starts them. Then come limits, motors and springs of
/// those that PlanBounds had; those that are idle are left out.
void PrepareJoints(const JointTask& task, std::span<const JointIndex> joints);
/// The same for joints of an island that are all solved in turn: side by side where that gives the same bits.
/// StoreJointImpulses must follow the iterations on velocities.
void PrepareIslandJoints(const JointTask& task, std::span<const JointIndex> joints);
void StoreJointImpulses(const JointTask& task);
/// Applies the impulses that the joints have at present once more.
void WarmStartJoints(const JointTask& task);
/// Multiplies the impulses that these joints keep for warm starting by task.step.impulseScale, without pushing
/// anything; of those that PlanBounds had the impulses of limits, motors and springs.
void ScaleJointImpulses(const JointTask& task, std::span<const JointIndex> joints);
/// One iteration each.
void SolveJointVelocities(const JointTask& task);
/// True if every joint is within tolerance.
bool SolveJointPositions(const JointTask& task);
/// And WarmStartJoints, for which the poses do not matter.
void SolveJointPositionsAndWarmStart(const JointTask& task);

}  // namespace scree
