// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The page of a comparison of pictures (`scree snapshot check --report DIR`, `scree diff A B -o DIR`): the list of
// cases with a filter; of the chosen one both pictures side by side, under a slider, blinking, or their difference; the
// pixels and overlap counts under the cursor, what changed in the structure, what made each picture, the rule, and the
// command that accepts it. The pictures are embedded: the page can be moved or sent without the folder.

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
