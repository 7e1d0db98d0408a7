// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pictures of the snapshot catalogue made now against the references: `scree snapshot check` and `update`.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
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

/// What must agree beside the pixels.
enum class StateRule {
    close,  ///< nothing: a state that is another by too little to be seen passes, and is counted
    exact,  ///< state hash and structure, so every bit of the state
};

struct SnapshotJob {
    std::vector<SnapshotCase> catalog;    ///< all pictures that there are
    std::string program = "testbed/run";  ///< that a reader is told to run
    std::string place;                    ///< options behind the action that name scenes and references
    std::filesystem::path references;
    StateRule state = StateRule::close;
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
    std::vector<SnapshotResult> results;  ///< of this shard
    std::size_t caseCount = 0;            ///< of the whole run
    int structureOnly = 0;                ///< equal pixels, other state
    std::vector<std::string> rewritten;   ///< ids
    std::vector<std::string> removed;     ///< ids
    std::filesystem::path page;           ///< of the report; empty: none was needed
};

/// Cases whose id matches. Throws UsageError for a bad expression.
[[nodiscard]] std::vector<SnapshotCase> SelectCases(std::vector<SnapshotCase> catalog, const std::string& pattern);

/// The command that accepts what was found, without -g and --update.
[[nodiscard]] std::string FormatSnapshotCommand(const SnapshotJob& job, std::string_view action);

/// Whether the mode makes this result the new reference, or removes it if it is an orphan.
[[nodiscard]] bool IsAccepted(UpdateMode mode, const SnapshotResult& result);

/// The pattern `pattern` as an option; empty: nothing.
[[nodiscard]] std::string FormatPattern(const std::string& pattern);

/// Renders, compares, reports, and updates as the job says. Throws UsageError, FileError.
[[nodiscard]] SnapshotOutcome CheckSnapshots(const SnapshotJob& job, PictureMaker& maker);

}  // namespace testbed
