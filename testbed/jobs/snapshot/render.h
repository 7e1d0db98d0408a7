// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Makes the pictures of the snapshot catalogue: one simulation per scene, every picture with its sidecar. Our engine
// alone: the other one's state depends on the machine's mathematics library and on the version that is installed.

#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>

#include "scenes/scene.h"
#include "testbed/engines/run_spec.h"
#include "testbed/jobs/snapshot/catalog.h"
#include "testbed/view/picture.h"

namespace testbed {

/// A picture as it was made now.
struct SnapshotPicture {
    Image image;
    nlohmann::ordered_json sidecar;  ///< without "compare", the rule, which belongs to the reference
    double simulateMs = 0;           ///< since the scene's last picture
    double renderMs = 0;
};

/// How the pictures are made.
struct SnapshotMaking {
    RunSpec spec = MakeSpec("scree", likeBox2dPreset);  ///< references have this one
    std::function<void(scenes::Scene&)> perturb = {};   ///< applied to every scene before it is loaded
};

/// What a sidecar says of its case, and what it has to say for a picture of this case.
[[nodiscard]] nlohmann::ordered_json DescribeCase(const SnapshotCase& snapshotCase);

/// Calls `take` for every case in order; the cases are of one scene and settings, sorted by step.
void RenderSnapshots(std::span<const SnapshotCase> cases, const SnapshotMaking& making, PictureMaker& maker,
                     const std::function<void(const SnapshotCase&, SnapshotPicture)>& take);

/// The largest number of threads up to `wanted` that the engine takes.
[[nodiscard]] int SupportedThreads(int wanted);

/// Cases that follow each other and share a scene and settings.
[[nodiscard]] std::vector<std::span<const SnapshotCase>> GroupByScene(std::span<const SnapshotCase> cases);

}  // namespace testbed
