// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pictures of an artifact become references.

#include "testbed/jobs/snapshot/accept.h"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <stdexcept>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/filter.h"
#include "testbed/base/json_print.h"
#include "testbed/base/text.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/jobs/snapshot/render.h"
#include "testbed/jobs/snapshot/structure.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

/// A reference without the rule, which is written by hand and stays.
Json WithoutRule(Json sidecar) {
    if (sidecar.is_object()) sidecar.erase("compare");
    return sidecar;
}

bool IsSameImage(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.pixels == b.pixels;
}

bool IsSame(const Reference& a, const Reference& b) {
    return a.hasImage == b.hasImage && a.hasSidecar == b.hasSidecar && IsSameImage(a.image, b.image) &&
           WithoutRule(a.sidecar) == WithoutRule(b.sidecar);
}

/// Throws FileError if the sidecar is not one of the case, or the picture has another size.
void CheckBelongs(const SnapshotCase& snapshotCase, const Reference& actual, const fs::path& file) {
    Json wanted = DescribeCase(snapshotCase);
    if (!snapshotCase.settings.empty()) wanted["settings"] = snapshotCase.settings;
    if (!wanted.contains("settings")) wanted["settings"] = nullptr;
    for (const auto& [key, value] : wanted.items()) {
        const Json found = actual.sidecar.contains(key) ? actual.sidecar[key] : Json();
        if (found == value) continue;
        throw FileError(
            fmt::format("{}: made with {} {}, but this case has {}; accept from a check of these sources, "
                        "without --set",
                        file.string(), key, PrintJson(found), PrintJson(value)));
    }
    const auto damaged = [&](const std::string& problem) {
        return FileError(fmt::format("{}: {}; copy the artifact again", file.string(), problem));
    };
    const Json hash = actual.sidecar.contains("state_hash") ? actual.sidecar["state_hash"] : Json();
    if (!hash.is_string() || !ParseHash(hash.get_ref<const std::string&>())) throw damaged("it has no state hash");
    if (!actual.sidecar.contains("structure")) throw damaged("it has no structure");
    try {
        (void)CompareStructures(actual.sidecar["structure"], actual.sidecar["structure"]);
    } catch (const std::invalid_argument&) {
        throw damaged("its structure is damaged");
    }
    if (actual.image.width != snapshotCase.width || actual.image.height != snapshotCase.height) {
        throw damaged(fmt::format("the picture beside it has {}x{} pixels, this case has {}x{}", actual.image.width,
                                  actual.image.height, snapshotCase.width, snapshotCase.height));
    }
}

class Acceptor {
public:
    explicit Acceptor(const AcceptJob& job) : m_job(job), m_change(job.references) {
        for (const SnapshotCase& snapshotCase : job.catalog) m_cases.emplace(snapshotCase.GetId(), &snapshotCase);
    }

    void Take(const SnapshotArtifact& artifact, const SnapshotResult& result);
    AcceptOutcome Finish() {
        m_change.Finish();
        return std::move(m_outcome);
    }

private:
    void TakeOrphan(const SnapshotArtifact& artifact, const SnapshotResult& result);
    void TakePicture(const SnapshotArtifact& artifact, const SnapshotResult& result);
    [[nodiscard]] Reference ReadCurrent(const SnapshotResult& result) const;

    const AcceptJob& m_job;
    ReferenceChange m_change;
    std::map<std::string, const SnapshotCase*> m_cases;  ///< by id
    AcceptOutcome m_outcome;
};

void Acceptor::Take(const SnapshotArtifact& artifact, const SnapshotResult& result) {
    if (!IsAccepted(UpdateMode::all, result)) return;  // nothing differs
    const bool isMade = result.status == SnapshotStatus::orphan || result.actual;
    if (!isMade || !IsAccepted(m_job.update, result)) {
        m_outcome.left.push_back(result);
    } else if (result.status == SnapshotStatus::orphan) {
        TakeOrphan(artifact, result);
    } else {
        TakePicture(artifact, result);
    }
}

void Acceptor::TakeOrphan(const SnapshotArtifact& artifact, const SnapshotResult& result) {
    if (m_cases.contains(result.id)) {
        throw FileError(fmt::format("{}: {} belongs to no snapshot there, but to one here; check again and accept that",
                                    artifact.folder.string(), result.id));
    }
    if (ListReferences(m_job.references).contains(result.id)) {
        m_change.Remove(result.id);
        m_outcome.removed.push_back(result.id);
    } else {
        m_outcome.already.push_back(result.id);
    }
}

/// The reference as it is now. One that the check could not read, either, is as if there were none.
Reference Acceptor::ReadCurrent(const SnapshotResult& result) const {
    try {
        return ReadReference(m_job.references, result.id);
    } catch (const FileError&) {
        if (result.status != SnapshotStatus::failed) throw;
        return {};
    }
}

void Acceptor::TakePicture(const SnapshotArtifact& artifact, const SnapshotResult& result) {
    const auto known = m_cases.find(result.id);
    if (known == m_cases.end()) {
        throw FileError(fmt::format("{}: there is no snapshot {} here; `scree snapshot list` shows all",
                                    artifact.folder.string(), result.id));
    }
    const fs::path actualFile = artifact.folder / "actual" / (result.id + ".json");
    const Reference actual = ReadReference(artifact.folder / "actual", result.id);
    if (!actual.hasImage || !actual.hasSidecar) {
        throw FileError(fmt::format("{}: {} is not there; copy the artifact again", artifact.folder.string(),
                                    actual.hasImage ? result.actual->sidecar : result.actual->image));
    }
    CheckBelongs(*known->second, actual, actualFile);

    const Reference expected = ReadReference(artifact.folder / "expected", result.id);
    const Reference current = ReadCurrent(result);
    if (IsSame(current, actual)) {
        m_outcome.already.push_back(result.id);
        return;
    }
    if (!IsSame(current, expected)) {
        throw FileError(fmt::format(
            "{}: the reference {} is not the one that the check saw; check again, or leave this one out with -g",
            artifact.folder.string(), result.id));
    }
    m_change.Write(result.id, actual.image, WithoutRule(actual.sidecar), current.sidecar);
    m_outcome.rewritten.push_back(result.id);
}

}  // namespace

AcceptOutcome AcceptArtifacts(const AcceptJob& job, std::span<const SnapshotArtifact> artifacts) {
    const std::regex pattern = CompileFilter(job.pattern);
    Acceptor acceptor(job);
    bool matches = job.pattern.empty();
    for (const SnapshotArtifact& artifact : artifacts) {
        for (const SnapshotResult& result : artifact.written.results) {
            if (!std::regex_search(result.id, pattern)) continue;
            matches = true;
            acceptor.Take(artifact, result);
        }
    }
    if (!matches) throw UsageError(fmt::format("-g {}: no case of the artifact matches", job.pattern));
    return acceptor.Finish();
}

}  // namespace testbed
