// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The engines: name, how a run of each is made, and what it can do. To add one, add a row in engine_list.cpp.

#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "testbed/engines/engine_run.h"
#include "testbed/engines/lab.h"
#include "testbed/engines/run_spec.h"

namespace testbed {

/// "soft steps, threads", for readers.
[[nodiscard]] std::string DescribeAbilities(Abilities abilities);

struct EngineInfo {
    std::string_view name;   ///< as --engines takes it
    std::string_view title;  ///< for readers
    Abilities abilities;
    /// Null, as the others: known, but not in this build.
    std::unique_ptr<InteractiveRun> (*makeRun)(const scenes::Scene&, const RunSpec&, const RunNeeds&);
    /// Its broad phase alone, moved by another run.
    std::unique_ptr<EngineRun> (*makeFollower)(const scenes::Scene&, const RunSpec&, std::unique_ptr<EngineRun> source);
    std::unique_ptr<LabWorld> (*makeLab)(const scenes::Scene&, const RunSpec&, const LabNeeds&);
};
/// Those of this build.
[[nodiscard]] std::span<const EngineInfo> GetEngines();
/// Also those that a build has only where it finds their library.
[[nodiscard]] std::span<const EngineInfo> GetKnownEngines();

/// What --engines calls the tree that a motion was recorded with: nothing runs, and there are no settings. It is none
/// of the engines above.
inline constexpr std::string_view recordedEngine = "recorded";

/// Whether this build has a known engine.
[[nodiscard]] bool IsBuilt(std::string_view name);
/// Of the known ones and the recorded one. UsageError with the nearest name for another.
[[nodiscard]] const EngineInfo& FindEngine(std::string_view name);

}  // namespace testbed
