// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pictures of the snapshot catalogue made now against the references: `scree snapshot check` and `update`.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "testbed/base/shard.h"
#include "testbed/jobs/snapshot/render.h"
#include "testbed/jobs/snapshot/result.h"

namespace testbed {

/// Which differences become the new references.
enum class UpdateMode {
    none,
    missing,  ///< only pictures without a reference
    changed,  ///< only those whose pixels, size or structure changed
    all,      ///< both, and references without a picture are removed
};

struct SnapshotJob {
    std::vector<SnapshotCase> catalog;  ///< all pictures that there are
    /// What accepts pictures, before --update MODE -g PATTERN.
    std::string updateCommand = "testbed/run snapshot update";
    std::filesystem::path references;
    std::string pattern;  ///< regular expression, searched for in the ids; empty: all
    Shard shard;
    UpdateMode update = UpdateMode::none;
    std::filesystem::path report;  ///< created with the first difference
    bool alwaysReport = false;     ///< also without one
    std::string command;
    SnapshotMaking making;
};

/// What was found, and what was done about it.
struct SnapshotOutcome {
    std::vector<SnapshotResult> results;   ///< of this shard
    std::vector<std::size_t> caseNumbers;  ///< of the results, in the whole run
    std::size_t caseCount = 0;             ///< of the whole run
    int structureOnly = 0;                 ///< equal pixels, other structure
    std::vector<std::string> rewritten;    ///< ids
    std::vector<std::string> removed;      ///< ids
    std::filesystem::path page;            ///< of the report; empty: none was needed
};

/// Cases whose id matches. Throws UsageError for a bad expression.
[[nodiscard]] std::vector<SnapshotCase> SelectCases(std::vector<SnapshotCase> catalog, const std::string& pattern);

/// Renders, compares, reports, and updates as the job says. Throws UsageError, FileError.
[[nodiscard]] SnapshotOutcome CheckSnapshots(const SnapshotJob& job, PictureMaker& maker);

}  // namespace testbed
