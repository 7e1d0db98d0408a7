// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One engine's broad phase driven by another engine's motion (`--poses`). Two simulations of one scene part after the
// first contact; with one motion, pictures differ by the tree alone. A following run steps its source and repeats the
// poses in a broad phase without a world. For bodies that were awake it gives the boxes of both ends of the step and
// the true displacement. So Box2D fattens boxes as in a world of its own; SetTransform would lose the displacement.

#pragma once

#include <memory>

#include "testbed/engines/engine_run.h"

namespace testbed {

/// Stand-alone b2BroadPhase following `source`, which must be at step 0 of `scene`.
std::unique_ptr<EngineRun> MakeBox2dFollower(const scenes::Scene& scene, const RunSpec& spec,
                                             std::unique_ptr<EngineRun> source);

/// Stand-alone broad phase of ours, of the kind in `spec`, following `source`.
std::unique_ptr<EngineRun> MakeScreeFollower(const scenes::Scene& scene, const RunSpec& spec,
                                             std::unique_ptr<EngineRun> source);

}  // namespace testbed
