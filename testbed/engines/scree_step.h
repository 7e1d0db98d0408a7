// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A run spec as our engine takes it: what a world is made with, and one step by any of its solvers.

#pragma once

#include "scree/world.h"
#include "testbed/engines/run_spec.h"

namespace testbed {

/// What every world of ours takes of a spec; gravity must be known (Resolve).
[[nodiscard]] scree::WorldDef MakeScreeWorldDef(const RunSpec& spec);

/// The spec that makes such a world; solver, time step and gravity stay the scene's.
[[nodiscard]] RunSpec DescribeScreeWorld(const scree::World& world);

/// One step of `timeStep` seconds; iterations must be known (Resolve).
scree::StepReport StepScree(scree::World& world, const Solver& solver, float timeStep);

}  // namespace testbed
