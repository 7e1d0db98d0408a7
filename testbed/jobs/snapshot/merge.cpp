// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The reports of the shards of one check as one report.

#include "testbed/jobs/snapshot/merge.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/jobs/snapshot/report.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// A new report removes what an earlier one left in its folder; so none of the reports may be there.
void CheckApart(const SnapshotArtifact& artifact, const fs::path& folder) {
    const fs::path from = fs::weakly_canonical(artifact.folder), to = fs::weakly_canonical(folder);
    for (fs::path above = from;; above = above.parent_path()) {
        if (above == to) {
            throw UsageError(
                fmt::format("--report {}: the report {} is there, which is to be joined; give another folder",
                            folder.string(), artifact.folder.string()));
        }
        if (above == above.parent_path()) return;
    }
}

void CheckSameRun(const SnapshotArtifact& first, const SnapshotArtifact& other) {
    const SnapshotOrigin &a = first.written.origin, &b = other.written.origin;
    if (a.command == b.command && a.caseCount == b.caseCount) return;
    throw FileError(fmt::format("{} is of `{}` with {} cases, {} of `{}` with {}; give the reports of one run",
                                first.folder.string(), a.command, a.caseCount, other.folder.string(), b.command,
                                b.caseCount));
}

/// The renderers of machines may have several names for the same pixels: each of them once.
void AddName(std::string& names, const std::string& name) {
    if (fmt::format("; {}; ", names).find(fmt::format("; {}; ", name)) == std::string::npos) names += "; " + name;
}

}  // namespace

MergedReport MergeReports(std::span<const SnapshotArtifact> artifacts, const fs::path& folder) {
    MergedReport merged;
    SnapshotOrigin& origin = merged.written.origin;
    origin = artifacts.front().written.origin;
    std::map<std::size_t, std::pair<const SnapshotArtifact*, const SnapshotResult*>> cases;  // by number
    for (const SnapshotArtifact& artifact : artifacts) {
        CheckApart(artifact, folder);
        CheckSameRun(artifacts.front(), artifact);
        AddName(origin.backend, artifact.written.origin.backend);
        AddName(origin.renderer, artifact.written.origin.renderer);
        AddName(origin.version, artifact.written.origin.version);
        for (const SnapshotResult& result : artifact.written.results) {
            const auto [other, isNew] = cases.emplace(result.number, std::pair(&artifact, &result));
            if (isNew) continue;
            throw FileError(fmt::format("case {} is {} in {} and {} in {}; give the reports of one run", result.number,
                                        other->second.second->id, other->second.first->folder.string(), result.id,
                                        artifact.folder.string()));
        }
    }
    SnapshotReport report(folder);
    for (std::size_t number = 0; number < origin.caseCount; ++number) {
        const auto place = cases.find(number);
        if (place == cases.end()) {
            merged.missing.push_back(number);
            continue;
        }
        const auto [artifact, result] = place->second;
        report.Copy(*result, artifact->folder);
        merged.written.results.push_back(*result);
    }
    merged.page = report.Finish(origin, merged.written.results);
    return merged;
}

}  // namespace testbed
