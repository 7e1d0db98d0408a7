// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a scene requires of our engine, and what it costs to model more than that. Variants of one scene run in
// lockstep, step by step in turn, so that a disturbance of the machine hits all alike. All repeats do the same work, so
// of every step the fastest repeat counts.

#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/feature_facts.h"

namespace testbed {

/// What is measured of a scene, and how it is run; the features of the spec are the variants' to choose.
struct RequirementTask {
    RunSpec spec;
    int steps = 100;
    int repeats = 9;
};

/// One way to run the scene, and what came of it.
struct VariantCost {
    std::string name;     ///< "full", "automatic", "minimal", "without damping"
    std::string kernels;  ///< of the last step
    double nsPerBodyStep = 0;
    std::size_t bytesPerBody = 0, bytesPerFixture = 0, bytesPerContact = 0, bytesPerJoint = 0;
    bool sameHash = true;  ///< as the first variant's, after every step
    int firstDifference = -1;
};

struct Requirement {
    std::string scene;
    int size = 0;
    int steps = 0;
    std::vector<FeatureUse> uses;  ///< of every feature, the most at any step
    std::vector<VariantCost> variants;

    /// The features that have users, joined by +, as RunSpec::features takes them.
    [[nodiscard]] std::string GetMinimalSet() const;
};

/// The most users of each feature in a run.
[[nodiscard]] std::vector<FeatureUse> FindUses(const scenes::Scene& scene, const RequirementTask& task);

struct Variant {
    std::string name;
    std::string features;  ///< RunSpec::features
};
/// Runs the variants in lockstep. `onRepeat` is called after each repeat.
[[nodiscard]] std::vector<VariantCost> RunVariants(const scenes::Scene& scene, const RequirementTask& task,
                                                   std::span<const Variant> variants,
                                                   const std::function<void()>& onRepeat = {});

/// Uses, and the three variants full, automatic and minimal.
[[nodiscard]] Requirement MeasureRequirement(const scenes::Scene& scene, const RequirementTask& task,
                                             const std::function<void()>& onRepeat = {});

/// "automatic −3.1 %, minimal −3.0 % against full".
[[nodiscard]] std::string FormatChange(const Requirement& requirement);
/// As a terminal shows it.
[[nodiscard]] std::string FormatRequirement(const Requirement& requirement);
/// A C++ header with the minimal set as a constant; `command` is named in it.
[[nodiscard]] std::string MakeFeatureHeader(const Requirement& requirement, std::string_view command);

}  // namespace testbed
