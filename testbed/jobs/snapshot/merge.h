// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree snapshot merge`: the reports of the shards of one check as one report, with one page of all cases.

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "testbed/jobs/snapshot/artifact.h"

namespace testbed {

struct MergedReport {
    WrittenResults written;            ///< in the order of an unsharded run
    std::vector<std::size_t> missing;  ///< numbers of cases that no report has
    std::filesystem::path page;
};

/// Writes the joined report to `folder`. Throws UsageError for a folder that has one of the reports in it, FileError
/// for reports of different runs.
[[nodiscard]] MergedReport MergeReports(std::span<const SnapshotArtifact> artifacts,
                                        const std::filesystem::path& folder);

}  // namespace testbed
