// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree snapshot accept`: the pictures and sidecars that a failed check left become the references, without making
// them again. All is read and compared first; if anything is wrong, no reference changes.

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/snapshot/artifact.h"
#include "testbed/jobs/snapshot/catalog.h"
#include "testbed/jobs/snapshot/check.h"

namespace testbed {

struct AcceptJob {
    std::vector<SnapshotCase> catalog;  ///< all pictures that there are
    std::filesystem::path references;
    std::string pattern;                  ///< as SnapshotJob::pattern
    UpdateMode update = UpdateMode::all;  ///< not none
};

/// What became of the results that differed in the artifact, by id.
struct AcceptOutcome {
    std::vector<std::string> rewritten, removed;
    std::vector<std::string> already;  ///< the references are so already
    std::vector<SnapshotResult> left;  ///< not accepted: no picture was made, or the mode leaves it out
};

/// Throws FileError for an artifact that does not belong to these references. It has an unknown case or a picture made
/// in another way, or a reference is another than the one that the check saw. Throws UsageError for a bad pattern and
/// one that matches nothing.
[[nodiscard]] AcceptOutcome AcceptArtifacts(const AcceptJob& job, std::span<const SnapshotArtifact> artifacts);

}  // namespace testbed
