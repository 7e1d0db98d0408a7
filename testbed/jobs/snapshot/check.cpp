// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pictures of the snapshot catalogue made now against the references.

#include "testbed/jobs/snapshot/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/filter.h"
#include "testbed/base/json_print.h"
#include "testbed/base/progress.h"
#include "testbed/base/text.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/jobs/snapshot/report.h"
#include "testbed/jobs/snapshot/structure.h"
#include "testbed/picture/image.h"
#include "testbed/picture/image_compare.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

SnapshotResult MakeResult(const SnapshotCase& snapshotCase) {
    SnapshotResult result;
    result.id = snapshotCase.GetId();
    result.scene = snapshotCase.scene;
    result.name = snapshotCase.name;
    result.kind = snapshotCase.kind;
    result.layers = snapshotCase.layers;
    result.size = snapshotCase.size;
    result.step = snapshotCase.step;
    return result;
}

/// The id as a regular expression that the shell leaves alone.
std::string PatternOf(const std::string& id) {
    std::string pattern;
    for (const char c : id) {
        if (c == '\'') {
            pattern += '.';  // it would end the quotes
            continue;
        }
        if (std::string_view("^$\\.*+?()[]{}|").find(c) != std::string_view::npos) pattern += '\\';
        pattern += c;
    }
    return pattern;
}

/// How the structures of two sidecars differ, as text; empty when they agree or one has none.
std::string DescribeStructureChange(const Json& expected, const Json& actual) {
    if (!expected.is_object() || !expected.contains("structure") || !actual.contains("structure")) return {};
    const Json change = CompareStructures(expected["structure"], actual["structure"]);
    return change["equal"].get<bool>() ? std::string() : PrintJson(change);
}

/// Null: the sidecar has none.
Json GetStateHash(const Json& sidecar) { return sidecar.contains("state_hash") ? sidecar["state_hash"] : Json(); }

void JudgePair(SnapshotResult& result, const Reference& reference, const SnapshotPicture& picture, StateRule rule) {
    const Image &expected = reference.image, &actual = picture.image;
    const Json before = GetStateHash(reference.sidecar), after = GetStateHash(picture.sidecar);
    result.structure = DescribeStructureChange(reference.sidecar, picture.sidecar);
    result.isStateChanged = !result.structure.empty() || before != after;
    if (expected.width != actual.width || expected.height != actual.height) {
        result.status = SnapshotStatus::size;
        result.message = fmt::format("{}x{} pixels, the reference has {}x{}", actual.width, actual.height,
                                     expected.width, expected.height);
        return;
    }
    result.pixels = ComparePixels(expected, actual, result.rule);
    result.status = result.pixels.changed == 0 ? SnapshotStatus::equal : SnapshotStatus::changed;
    result.message = DescribePixels(result);
    if (result.status != SnapshotStatus::equal || !result.isStateChanged) return;
    if (rule == StateRule::exact) {
        result.status = SnapshotStatus::state;
        result.message +=
            fmt::format("; the state hash is {}, the reference has {}", PrintJson(after), PrintJson(before));
        if (before == after) result.message += "; bodies, tree nodes or contacts differ, as the report shows";
    } else {
        result.message += "; the state below the pixels changed";
    }
}

std::string UpdateCommand(const SnapshotJob& job, const std::string& id, const char* mode) {
    if (job.making.spec != SnapshotMaking{}.spec) return {};  // references are made in one way
    return fmt::format("{} --update {} -g '^{}$'", FormatSnapshotCommand(job, "update"), mode, PatternOf(id));
}

void Judge(const SnapshotJob& job, SnapshotResult& result, const Reference& reference, const SnapshotPicture& picture) {
    result.rule = reference.rule;
    result.update = UpdateCommand(job, result.id, "all");
    if (!reference.hasImage && !reference.hasSidecar) {
        result.status = SnapshotStatus::missing;
        result.message = "there is no reference";
        result.update = UpdateCommand(job, result.id, "missing");
    } else if (!reference.hasImage || !reference.hasSidecar) {
        result.status = SnapshotStatus::deleted;
        result.message = fmt::format("the reference's {} is gone", reference.hasImage ? "sidecar" : "picture");
    } else {
        JudgePair(result, reference, picture, job.state);
        if (result.status == SnapshotStatus::equal) result.update.clear();
    }
}

class Checker {
public:
    Checker(const SnapshotJob& job, PictureMaker& maker) : m_job(job), m_maker(maker) {
        if (job.alwaysReport) m_report.emplace(job.report);
    }

    SnapshotOutcome Run();

private:
    void CheckScene(std::span<const SnapshotCase> cases, std::size_t firstNumber);
    void CheckPicture(const SnapshotCase& snapshotCase, const SnapshotPicture& picture, std::size_t number);
    void CheckOrphan(const std::string& id, std::size_t number);
    void Report(SnapshotResult& result, const ReportedPair& pair);
    void Keep(SnapshotResult result, std::size_t number) {
        m_outcome.results.push_back(std::move(result));
        m_outcome.results.back().number = number;
    }

    const SnapshotJob& m_job;
    PictureMaker& m_maker;
    std::optional<SnapshotReport> m_report;
    SnapshotOutcome m_outcome;
};

void Checker::Report(SnapshotResult& result, const ReportedPair& pair) {
    if (result.status == SnapshotStatus::equal && !result.isStateChanged) return;
    if (!m_report) m_report.emplace(m_job.report);
    m_report->Add(result, pair);
}

void Checker::CheckPicture(const SnapshotCase& snapshotCase, const SnapshotPicture& picture, std::size_t number) {
    const Clock::time_point start = Clock::now();
    SnapshotResult result = MakeResult(snapshotCase);
    Reference reference;
    try {
        reference = ReadReference(m_job.references, result.id);
        Judge(m_job, result, reference, picture);
    } catch (const std::exception& error) {  // a damaged reference must not hide the other results
        result.status = SnapshotStatus::failed;
        result.message = error.what();
        result.update = UpdateCommand(m_job, result.id, "all");
    }
    result.simulateMs = picture.simulateMs;
    result.renderMs = picture.renderMs;
    result.compareMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (IsAccepted(m_job.update, result)) {
        ReferenceChange change(m_job.references);
        change.Write(result.id, picture.image, picture.sidecar, reference.sidecar);
        change.Finish();
        m_outcome.rewritten.push_back(result.id);
        result = MakeResult(snapshotCase);
        result.message = "accepted";
    } else {
        if (result.status == SnapshotStatus::equal && result.isStateChanged) ++m_outcome.structureOnly;
        Report(result, {.expected = reference.hasImage ? &reference.image : nullptr,
                        .actual = &picture.image,
                        .expectedSidecar = reference.hasSidecar ? FormatSidecar(reference.sidecar) : "",
                        .actualSidecar = FormatSidecar(picture.sidecar)});
    }
    Keep(std::move(result), number);
}

void Checker::CheckScene(std::span<const SnapshotCase> cases, std::size_t firstNumber) {
    Progress progress(cases.front().scene, static_cast<double>(cases.size()));
    const std::size_t first = m_outcome.results.size();
    std::size_t number = firstNumber;
    const auto take = [&](const SnapshotCase& snapshotCase, SnapshotPicture picture) {
        CheckPicture(snapshotCase, picture, number++);
        progress.Advance(1);
    };
    try {
        RenderSnapshots(cases, m_job.making, m_maker, take);
    } catch (const std::invalid_argument& error) {  // a scene that cannot be loaded: the others still can
        for (; number < firstNumber + cases.size(); ++number) {
            SnapshotResult result = MakeResult(cases[number - firstNumber]);
            result.status = SnapshotStatus::failed;
            result.message = error.what();
            Report(result, {});
            Keep(std::move(result), number);
        }
    }
    progress.Finish(FormatCounts(std::span(m_outcome.results).subspan(first)));
}

void Checker::CheckOrphan(const std::string& id, std::size_t number) {
    SnapshotResult result;
    result.id = id;
    result.scene = id.substr(0, id.rfind('/'));
    result.name = id.substr(id.rfind('/') + 1);
    result.status = SnapshotStatus::orphan;
    result.message = "a reference that the catalogue of snapshots does not have";
    result.update = UpdateCommand(m_job, id, "all");
    if (IsAccepted(m_job.update, result)) {
        ReferenceChange change(m_job.references);
        change.Remove(id);
        change.Finish();
        m_outcome.removed.push_back(id);
        return;
    }
    Report(result, {});
    Keep(std::move(result), number);
}

SnapshotOutcome Checker::Run() {
    const std::vector<SnapshotCase> cases = SelectCases(m_job.catalog, m_job.pattern);
    std::set<std::string> orphans = ListReferences(m_job.references);
    for (const SnapshotCase& snapshotCase : m_job.catalog) orphans.erase(snapshotCase.GetId());
    const std::regex pattern = CompileFilter(m_job.pattern);
    std::erase_if(orphans, [&](const std::string& id) { return !std::regex_search(id, pattern); });
    if (cases.empty() && orphans.empty()) {
        throw UsageError(fmt::format("-g {}: no snapshot matches; `scree snapshot list` shows all", m_job.pattern));
    }
    m_outcome.caseCount = cases.size() + orphans.size();
    std::size_t group = 0, number = 0;
    for (const std::span<const SnapshotCase> scene : GroupByScene(cases)) {
        if (m_job.shard.Contains(group++)) CheckScene(scene, number);
        number += scene.size();
    }
    for (const std::string& id : orphans) {
        if (m_job.shard.IsFirst()) CheckOrphan(id, number);
        ++number;
    }
    if (m_report) {
        m_outcome.page = m_report->Finish({m_job.command, GetBackendName(m_maker.GetBackend()),
                                           m_maker.GetRendererName(), m_maker.GetVersion(), m_outcome.caseCount},
                                          m_outcome.results);
    }
    return std::move(m_outcome);
}

}  // namespace

std::vector<SnapshotCase> SelectCases(std::vector<SnapshotCase> catalog, const std::string& pattern) {
    const std::regex expression = CompileFilter(pattern);
    std::erase_if(catalog, [&](const SnapshotCase& c) { return !std::regex_search(c.GetId(), expression); });
    return catalog;
}

std::string FormatSnapshotCommand(const SnapshotJob& job, std::string_view action) {
    return fmt::format("{} snapshot {}{}", job.program, action, job.place);
}

std::string FormatPattern(const std::string& pattern) {
    return pattern.empty() ? std::string() : " -g " + QuoteForShell(pattern);
}

bool IsAccepted(UpdateMode mode, const SnapshotResult& result) {
    const bool isMissing = result.status == SnapshotStatus::missing;
    const bool isSame = result.status == SnapshotStatus::equal && !result.isStateChanged;
    switch (mode) {
        case UpdateMode::none:
            return false;
        case UpdateMode::missing:
            return isMissing;
        case UpdateMode::changed:
            return !isMissing && !isSame && result.status != SnapshotStatus::orphan;
        case UpdateMode::all:
            return !isSame;
    }
    return false;
}

SnapshotOutcome CheckSnapshots(const SnapshotJob& job, PictureMaker& maker) { return Checker(job, maker).Run(); }

}  // namespace testbed
