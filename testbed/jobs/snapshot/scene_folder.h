// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which pictures `scree snapshot --scenes DIR` keeps of scene files and motions in a folder of somebody else: what
// snapshots.json there says.
//
//     {"format": "scree-snapshots", "version": 1,
//      "image": "480x300",                            pixels of all pictures; this if not given
//      "snapshots": [{"scene": "levels/tower.scene.json",   below DIR; "*": every scene and motion there
//                     "steps": [60, 120],             the scene's show step, a motion's last one if not given
//                     "kind": "render",               or "overlap": where the boxes of the tree lie over each other
//                     "layers": "bodies,contacts",    as --layers takes them; overlap: nodes, as --nodes takes them
//                     "theme": "light",
//                     "settings": "solver=soft@4",    as --set takes them, with spaces between
//                     "name": "contacts"}]}           of the picture; its kind if not given
//
// A folder without the file has a render and an overlap of each scene.

#pragma once

#include <filesystem>
#include <vector>

#include "testbed/jobs/snapshot/catalog.h"

namespace testbed {

/// All pictures; those of one scene and settings follow each other, in the order of their steps. Reads every file that
/// is drawn. Throws FileError and UsageError with the place in snapshots.json ("snapshots[2].steps") and the cure.
[[nodiscard]] std::vector<SnapshotCase> ReadSceneFolder(const std::filesystem::path& folder);

}  // namespace testbed
