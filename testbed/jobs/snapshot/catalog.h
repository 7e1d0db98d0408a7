// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which pictures `scree snapshot` keeps of the catalogue of scenes. Every scene has two steps: the overlap of its tree
// at both, and some of the sets of layers, each of which covers a third of the scenes. To add a set, add a row to
// snapshotSets in catalog.cpp. To add a scene, add it to the catalogue of scenes: nothing else is needed.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "testbed/options/scene_input.h"

namespace testbed {

/// Pictures are this large: small files, and every scene still shows what it does.
inline constexpr int snapshotWidth = 480, snapshotHeight = 300;

/// One reference picture.
struct SnapshotCase {
    std::string scene;
    int size = 0;
    int step = 0;
    std::string name;            ///< of the files without extension, for example "step-0090-islands"
    std::string kind;            ///< overlap or render
    std::string layers;          ///< render: layers, as --layers takes them; overlap: nodes, as --nodes takes them
    std::string theme = "dark";  ///< as --theme takes it
    std::string settings{};      ///< how the scene is run, as --set takes it; empty: as all references without it
    int width = snapshotWidth, height = snapshotHeight;
    std::shared_ptr<const SceneInput> input{};  ///< from a file; null: `scene` is of the catalogue of scenes

    /// <scene>/<name>: the reference's path without extension.
    [[nodiscard]] std::string GetId() const { return scene + "/" + name; }
};

/// All pictures of the catalogue of scenes; those of one scene and settings follow each other, in the order of their
/// steps.
[[nodiscard]] std::vector<SnapshotCase> GetSnapshotCatalog();

}  // namespace testbed
