// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of a comparison of pictures: `scree snapshot check --report DIR`, `scree diff A B -o DIR`. It has a list of
// cases with a filter. Of the chosen case it shows both pictures (side by side, under a slider, blinking, or their
// difference) and the pixels and overlap counts under the cursor. It also says what changed in the structure, what made
// each picture, which rule applied, and which command accepts the new picture. The pictures are embedded: the page can
// be moved or sent without the folder.

#pragma once

#include <filesystem>
#include <span>

#include "testbed/jobs/snapshot/result.h"
#include "testbed/page/page.h"

namespace testbed {

/// The files that the results name are read from `folder`. Throws FileError for one that cannot be read.
[[nodiscard]] Page MakeSnapshotPage(const std::filesystem::path& folder, const SnapshotOrigin& origin,
                                    std::span<const SnapshotResult> results);

/// Writes folder/index.html and returns its path. Throws FileError.
std::filesystem::path WriteSnapshotPage(const std::filesystem::path& folder, const SnapshotOrigin& origin,
                                        std::span<const SnapshotResult> results);

}  // namespace testbed
