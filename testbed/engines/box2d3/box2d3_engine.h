// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D 3 as an engine of the testbed, built where CMake finds it (box2d3_ROOT names where it is installed). Both
// versions of Box2D call their header and their types alike. So this folder is compiled apart, and only types of the
// testbed cross its border.

#pragma once

#include <memory>
#include <string>

#include "testbed/engines/engine_run.h"
#include "testbed/engines/lab.h"

namespace testbed {

/// "3.2.0".
[[nodiscard]] std::string GetBox2d3Version();

/// Throws std::invalid_argument for what Box2D 3 has not: gears, pulleys, and motor joints that correct a share of
/// their error.
std::unique_ptr<InteractiveRun> MakeBox2d3Run(const scenes::Scene& scene, const RunSpec& spec,
                                              const RunNeeds& needs = {});
std::unique_ptr<EngineRun> MakeBox2d3Follower(const scenes::Scene& scene, const RunSpec& spec,
                                              std::unique_ptr<EngineRun> source);
std::unique_ptr<LabWorld> MakeBox2d3Lab(const scenes::Scene& scene, const RunSpec& spec, const LabNeeds& needs);

}  // namespace testbed
