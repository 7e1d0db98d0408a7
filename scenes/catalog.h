// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The list of all scenes: name → description, legal sizes, builder. One row per scene, in an explicit table
// (suite_rows.h, classic_rows.h, joint_rows.h), so that nothing depends on the order of static initialisation.

#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scenes/scene.h"

namespace scenes {

/// Sizes begin, begin + increment, … end (inclusive): the x axis of a published plot.
struct Sweep {
    int begin = 0;
    int end = 0;
    int increment = 1;
};

/// What is known of a scene without building it.
struct SceneInfo {
    std::string_view name;       ///< kebab-case, unique: what the command line takes
    std::string_view title;      ///< one line: what stands in the world
    std::string_view exercises;  ///< what it stresses in an engine
    std::string_view folder;     ///< theme: the folder below scenes/ that holds its file
    bool isClassic = false;      ///< false: of the published benchmark suite
    bool hasSize = true;         ///< false: only defaultSize is legal
    int defaultSize = 0;
    int minSize = 1;
    int maxSize = 0;  ///< far above the sweep; the bound keeps memory (bodies or pairs) sane
    std::optional<Sweep> sweep{};
    int steps = 0;                       ///< of a full run at defaultSize
    int showStep = 0;                    ///< the step whose picture tells most
    Scene (*build)(int size) = nullptr;  ///< use Build(), which checks the size and fills in the header fields
};

/// All scenes, in the order in which they are listed to users.
[[nodiscard]] std::span<const SceneInfo> Catalog();

/// The row of that name, or nullptr.
[[nodiscard]] const SceneInfo* Find(std::string_view name);

/// At most `count` names by edit distance, nearest first; ties keep the catalogue's order. None where more than half of
/// the longer name differs.
[[nodiscard]] std::vector<std::string_view> NearestNames(std::string_view name, int count = 3);

/// Builds a scene at its default size. Throws std::invalid_argument for an unknown name; the message holds the nearest.
[[nodiscard]] Scene Build(std::string_view name);

/// The same at another size. Throws std::out_of_range, with the legal range in the message, when the size is not legal.
[[nodiscard]] Scene Build(std::string_view name, int size);

}  // namespace scenes
