// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a run of our engine uses of it, and what that costs in memory.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "testbed/engines/engine_run.h"

namespace testbed {

/// A feature of the engine and how many objects use it.
struct FeatureUse {
    std::string name;
    int users = 0;
};

struct FeatureFacts {
    std::vector<FeatureUse> uses;  ///< of every feature, in the engine's order
    std::string kernels;           ///< what the last step ran
    std::size_t bytesPerBody = 0, bytesPerFixture = 0, bytesPerContact = 0;
    std::size_t jointBytes = 0;  ///< of all joints
    int bodies = 0, contacts = 0, joints = 0;
    std::uint64_t stateHash = 0;
};

/// Of a run of our engine. Throws std::invalid_argument for another engine's.
[[nodiscard]] FeatureFacts GetFeatureFacts(const EngineRun& run);

}  // namespace testbed
