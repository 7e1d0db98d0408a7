// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Reports of `snapshot check` that were left by other runs, as CI keeps them: read back to accept pictures out of them
// (accept.h), and joined into one page (merge.h).

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/snapshot/result.h"

namespace testbed {

/// One report folder of `snapshot check` or `update`.
struct SnapshotArtifact {
    std::filesystem::path folder;
    WrittenResults written;
};

/// The reports in these places, each a report folder or a folder with some below it, such as all that a CI job kept.
/// Throws UsageError for a place without a report and for an archive that is not unpacked, FileError for a damaged
/// report and for a case that two of them have.
[[nodiscard]] std::vector<SnapshotArtifact> ReadArtifacts(std::span<const std::string> places);

}  // namespace testbed
