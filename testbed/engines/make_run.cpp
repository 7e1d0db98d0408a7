// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Chooses the run for an engine's name and for the motion it is to follow.

#include <stdexcept>

#include "testbed/engines/engine_run.h"
#include "testbed/engines/poses.h"

namespace testbed {

std::unique_ptr<InteractiveRun> MakeInteractiveRun(std::string_view engine, const scenes::Scene& scene,
                                                   const RunOptions& options) {
    if (engine == "scree") return MakeScreeRun(scene, options);
    if (engine == "box2d") return MakeBox2dRun(scene, options);
    throw std::invalid_argument("unknown engine '" + std::string(engine) + "': use scree or box2d");
}

std::unique_ptr<EngineRun> MakeRun(std::string_view engine, const scenes::Scene& scene, const RunOptions& options) {
    if (options.poses == "own" || options.poses == engine) return MakeInteractiveRun(engine, scene, options);
    if (options.poses != "scree" && options.poses != "box2d") {
        throw std::invalid_argument("unknown poses '" + options.poses + "': use own, scree or box2d");
    }
    std::unique_ptr<EngineRun> source = MakeInteractiveRun(options.poses, scene, options);
    if (engine == "box2d") return MakeBox2dFollower(scene, std::move(source));
    if (engine == "scree") return MakeScreeFollower(scene, options, std::move(source));
    throw std::invalid_argument("unknown engine '" + std::string(engine) + "': use scree or box2d");
}

}  // namespace testbed
