// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Reports of `snapshot check` that were left by other runs.

#include "testbed/jobs/snapshot/artifact.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/text.h"
#include "testbed/jobs/snapshot/report.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// Whether a results.json is of `snapshot`: `diff` and other programs write files of this name, too. Throws FileError
/// for one that is cut off.
bool IsOfSnapshot(const fs::path& file) {
    const nlohmann::ordered_json json = ReadJsonObject(file);
    return json.contains("command") && json["command"].is_string() &&
           json["command"].get_ref<const std::string&>().starts_with("scree snapshot ");
}

/// Folders of reports at the place and below it, in the order of their names.
std::vector<fs::path> FindReports(const fs::path& place) {
    std::error_code error;
    if (!fs::exists(place, error)) throw FileError(fmt::format("{}: there is no such folder", place.string()));
    if (!fs::is_directory(place)) {
        const std::string name = place.string();
        const std::string cure = place.extension() == ".zip"
                                     ? fmt::format("unpack it (unzip {} -d {}) and give the folder",
                                                   QuoteForShell(name), QuoteForShell(place.stem().string()))
                                     : std::string("give the folder that `snapshot check` wrote its report to");
        throw UsageError(fmt::format("{}: not a folder; {}", name, cure));
    }
    if (fs::exists(place / resultsName)) return {place};
    std::vector<fs::path> folders;
    for (fs::recursive_directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().filename() == resultsName && IsOfSnapshot(entry->path())) {
            folders.push_back(entry->path().parent_path());
        }
    }
    if (error) throw FileError(fmt::format("{}: cannot be read: {}", place.string(), error.message()));
    if (folders.empty()) {
        throw UsageError(fmt::format(
            "{}: no report of `scree snapshot check` is in it or below it; give a folder with a {} of that command",
            place.string(), resultsName));
    }
    std::ranges::sort(folders);
    return folders;
}

}  // namespace

std::vector<SnapshotArtifact> ReadArtifacts(std::span<const std::string> places) {
    std::vector<SnapshotArtifact> artifacts;
    std::map<std::string, fs::path> folderOf;  // by id
    for (const std::string& place : places) {
        for (const fs::path& folder : FindReports(place)) {
            const fs::path file = folder / resultsName;
            if (!IsOfSnapshot(file)) {
                throw UsageError(
                    fmt::format("{}: not of `scree snapshot check`; its references are unknown", file.string()));
            }
            SnapshotArtifact artifact{folder, ReadResults(file)};
            for (const SnapshotResult& result : artifact.written.results) {
                const auto [other, isNew] = folderOf.emplace(result.id, folder);
                if (isNew) continue;
                throw FileError(fmt::format("{} is in {} and in {}; give reports of one run", result.id,
                                            other->second.string(), folder.string()));
            }
            artifacts.push_back(std::move(artifact));
        }
    }
    return artifacts;
}

}  // namespace testbed
