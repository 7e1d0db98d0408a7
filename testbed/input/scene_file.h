// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scene files (`*.scene.json`): a scenes::Scene as JSON, and back. Keys are the names of scenes/scene.h; floats are the
// shortest decimals that read back to the same bits; what has its default is left out. scene.schema.json describes
// them.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scenes/scene.h"
#include "testbed/input/json_tree.h"

namespace testbed {

inline constexpr std::string_view sceneFormat = "scree-scene";
inline constexpr int sceneVersion = 1;

/// The scene as text. Throws FileError for a scene that a file cannot hold: a support function without a name.
[[nodiscard]] std::string WriteScene(const scenes::Scene& scene);

/// The scene in a text. `source` names it in messages and, by its file name, a scene that has no name. Throws FileError
/// with the place (`bodies[12].fixtures[0].shape.vertices`) and the cure for anything that is not a scene both engines
/// can make. Such are wrong keys or types, numbers that are not finite or out of range, shapes without area, and joints
/// of no body.
[[nodiscard]] scenes::Scene ReadScene(std::string_view text, std::string_view source);

/// The same from a tree of any syntax; what stands below "user" is left out.
[[nodiscard]] scenes::Scene ReadScene(const JsonNode& root, std::string_view source);

/// The scene in a file. Throws FileError, also when it cannot be read.
[[nodiscard]] scenes::Scene ReadSceneFile(const std::filesystem::path& file);

/// What a scene without a name is called: the name of its file without folder and endings.
[[nodiscard]] std::string NameOfScene(std::string_view source);

/// What is wrong with a scene, "place: fault; cure"; empty if nothing is.
[[nodiscard]] std::string DescribeFault(const scenes::Scene& scene);

}  // namespace testbed
