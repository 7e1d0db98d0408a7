// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree snapshot check | update | accept | merge | verify | list`: pictures of every scene against references.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "testbed/base/case_lines.h"
#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/base/output.h"
#include "testbed/base/shard.h"
#include "testbed/base/standard_error.h"
#include "testbed/base/text.h"
#include "testbed/engines/panes.h"
#include "testbed/jobs/snapshot/accept.h"
#include "testbed/jobs/snapshot/artifact.h"
#include "testbed/jobs/snapshot/check.h"
#include "testbed/jobs/snapshot/commands.h"
#include "testbed/jobs/snapshot/merge.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/jobs/snapshot/report.h"
#include "testbed/jobs/snapshot/scene_folder.h"
#include "testbed/jobs/snapshot/verify.h"
#include "testbed/options/options.h"

#ifndef SCREE_REFERENCE_FOLDER
#define SCREE_REFERENCE_FOLDER "tests/snapshots"
#endif

namespace testbed {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct SnapshotArguments {
    std::string action;
    std::vector<std::string> artifacts;
    std::string pattern;
    std::string update;
    std::string state = "close";
    std::string scenes;
    std::string references;
    std::string report;
    std::string junit;
    bool annotations = false;
    ShardArguments shard;
    SettingArguments settings;
    PictureArguments picture;  ///< of these only the backend
};

constexpr std::array<std::string_view, 6> actionNames = {"check", "update", "accept", "merge", "verify", "list"};
constexpr std::array<std::string_view, 3> updateNames = {"missing", "changed", "all"};
constexpr std::array<std::string_view, 2> stateNames = {"close", "exact"};
/// Where a check without --report leaves what differs.
constexpr const char* defaultReport = "out/snapshots";

/// The pictures that there are, and where those that were accepted lie.
struct Catalog {
    std::vector<SnapshotCase> cases;
    std::string references;
    std::string program;  ///< that a reader is told to run
    std::string place;    ///< options that name scenes and references
};

Catalog ChooseCatalog(const SnapshotArguments& arguments) {
    if (arguments.scenes.empty()) {
        Catalog catalog{GetSnapshotCatalog(), arguments.references, "testbed/run", ""};
        if (!catalog.references.empty()) {
            catalog.place = " --references " + QuoteForShell(catalog.references);
            return catalog;
        }
        catalog.references = SCREE_REFERENCE_FOLDER;
        if (!fs::exists(catalog.references)) {
            throw UsageError(
                "this program lies outside of its checkout, which has the references of its own scenes; give --scenes "
                "DIR for yours, or --references DIR");
        }
        return catalog;
    }
    const std::string references =
        arguments.references.empty() ? (fs::path(arguments.scenes) / "references").string() : arguments.references;
    return {ReadSceneFolder(arguments.scenes), references, "scree",
            fmt::format(" --scenes {} --references {}", QuoteForShell(arguments.scenes), QuoteForShell(references))};
}

UpdateMode ParseUpdate(const SnapshotArguments& arguments) {
    const bool accepts = arguments.action == "update" || arguments.action == "accept";
    const std::string text = accepts && arguments.update.empty() ? "all" : arguments.update;
    if (text.empty()) return UpdateMode::none;
    const auto place = std::ranges::find(updateNames, text);
    if (place == updateNames.end()) throw UsageError(DescribeUnknown("kind of --update", text, updateNames));
    constexpr std::array modes{UpdateMode::missing, UpdateMode::changed, UpdateMode::all};
    return modes[static_cast<std::size_t>(place - updateNames.begin())];
}

StateRule ParseState(const std::string& text) {
    const auto place = std::ranges::find(stateNames, text);
    if (place == stateNames.end()) throw UsageError(DescribeUnknown("kind of --state", text, stateNames));
    return text == "exact" ? StateRule::exact : StateRule::close;
}

/// Files that the user named get their folder made first: an unwritable place is known before the work.
void CheckWritable(const std::string& file) {
    if (file.empty()) return;
    const fs::path parent = fs::path(file).parent_path();
    const OutputFolder probe(parent.empty() ? fs::path(".") : parent);
}

void PrintOutcome(const SnapshotOutcome& outcome, const SnapshotJob& job) {
    for (const std::string& id : outcome.rewritten) fmt::print("written  {}\n", id);
    for (const std::string& id : outcome.removed) fmt::print("removed  {}\n", id);
    for (const SnapshotResult& result : outcome.results) {
        if (result.status != SnapshotStatus::equal) fmt::print("{}", FormatResult(result));
    }
    fmt::print("{} of {} snapshots: {}", outcome.results.size(), outcome.caseCount, FormatCounts(outcome.results));
    if (job.update != UpdateMode::none) {
        fmt::print("; {} written, {} removed", outcome.rewritten.size(), outcome.removed.size());
    }
    fmt::print("\n");
    if (outcome.structureOnly > 0) {
        fmt::print(
            "{} equal in their pixels alone: the state changed by less (--state exact fails for it, `snapshot update` "
            "renews the sidecars)\n",
            outcome.structureOnly);
    }
    if (job.making.spec != SnapshotMaking{}.spec) {
        fmt::print("made with --set, unlike the references: nothing of it is to be accepted\n");
    }
    if (outcome.page.empty()) return;
    fmt::print("report: {}\n", outcome.page.string());
    const auto canBeAccepted = [](const SnapshotResult& result) { return !result.update.empty(); };
    if (std::ranges::none_of(outcome.results, canBeAccepted)) return;
    fmt::print("to accept all that is in the report: {} {}\n", FormatSnapshotCommand(job, "accept"),
               QuoteForShell(job.report.string()));
    fmt::print("to make all again and accept them: {}{}\n", FormatSnapshotCommand(job, "update"),
               FormatPattern(job.pattern));
}

SnapshotMaking MakeMaking(const SnapshotArguments& arguments) {
    return {.spec = ParseSpec("scree", arguments.settings.typed, comparisonBase)};
}

int RunCheck(const SnapshotArguments& arguments, const Request& request) {
    Catalog catalog = ChooseCatalog(arguments);
    SnapshotJob job;
    job.catalog = std::move(catalog.cases);
    job.program = std::move(catalog.program);
    job.place = std::move(catalog.place);
    job.state = ParseState(arguments.state);
    job.references = catalog.references;
    job.pattern = arguments.pattern;
    job.shard = ParseShard(arguments.shard.shard);
    job.update = ParseUpdate(arguments);
    job.alwaysReport = !arguments.report.empty();
    job.report = job.alwaysReport ? arguments.report : defaultReport;
    job.command = "scree snapshot " + arguments.action;
    if (!arguments.scenes.empty()) job.command += " --scenes " + arguments.scenes;
    for (const TypedSetting& one : arguments.settings.typed) job.command += " " + one.source;
    job.making = MakeMaking(arguments);
    if (job.update != UpdateMode::none && job.making.spec != SnapshotMaking{}.spec) {
        throw UsageError("--set: references are made with preset=like-box2d alone");
    }
    const Backend backend = CheckedBackend(arguments.picture);
    CheckWritable(arguments.junit);
    CheckWritable(arguments.shard.json);

    PictureMaker maker(backend, request.contextOptions);
    const SnapshotOutcome outcome = CheckSnapshots(job, maker);
    CaseLines lines("snapshot " + arguments.action, outcome.caseCount);
    for (const SnapshotResult& result : outcome.results) lines.Add(result.number, DescribeResult(result));
    if (!arguments.shard.json.empty()) WriteTextFile(arguments.shard.json, lines.GetText());
    if (!arguments.junit.empty()) WriteTextFile(arguments.junit, WriteJunit(job.command, outcome.results));
    if (arguments.annotations) {
        // Relative to where CI stands: annotations of files outside the checkout are not shown.
        const std::string folder = fs::proximate(job.references).generic_string();
        fmt::print("{}", FormatAnnotations(outcome.results, folder));
    }
    PrintOutcome(outcome, job);
    return IsClean(outcome.results) ? exitDone : exitDiffers;
}

std::vector<SnapshotArtifact> ReadGivenArtifacts(const SnapshotArguments& arguments) {
    if (arguments.artifacts.empty()) {
        throw UsageError(
            fmt::format("snapshot {}: give the folder that `snapshot check` wrote its report to", arguments.action));
    }
    return ReadArtifacts(arguments.artifacts);
}

int RunAccept(const SnapshotArguments& arguments) {
    const std::vector<SnapshotArtifact> artifacts = ReadGivenArtifacts(arguments);
    Catalog catalog = ChooseCatalog(arguments);
    const AcceptOutcome outcome = AcceptArtifacts({.catalog = std::move(catalog.cases),
                                                   .references = catalog.references,
                                                   .pattern = arguments.pattern,
                                                   .update = ParseUpdate(arguments)},
                                                  artifacts);
    for (const std::string& id : outcome.rewritten) fmt::print("written  {}\n", id);
    for (const std::string& id : outcome.removed) fmt::print("removed  {}\n", id);
    for (const std::string& id : outcome.already) fmt::print("already  {}\n", id);
    for (const SnapshotResult& result : outcome.left) {
        fmt::print("left     {}, {}: {}\n", result.id, GetStatusName(result.status), result.message);
    }
    fmt::print("{} written, {} removed, {} already as in the artifact, {} left; references: {}\n",
               outcome.rewritten.size(), outcome.removed.size(), outcome.already.size(), outcome.left.size(),
               catalog.references);
    return outcome.left.empty() ? exitDone : exitDiffers;
}

int RunMerge(const SnapshotArguments& arguments) {
    const std::vector<SnapshotArtifact> artifacts = ReadGivenArtifacts(arguments);
    CheckWritable(arguments.junit);
    const MergedReport merged =
        MergeReports(artifacts, arguments.report.empty() ? defaultReport : arguments.report.c_str());
    const std::vector<SnapshotResult>& results = merged.written.results;
    if (!arguments.junit.empty()) WriteTextFile(arguments.junit, WriteJunit(merged.written.origin.command, results));
    fmt::print("{} of {} snapshots: {}\nreport: {}\n", results.size(), merged.written.origin.caseCount,
               FormatCounts(results), merged.page.string());
    if (!merged.missing.empty()) {
        PrintError("scree: {} of {} cases are in no report, the first is case {}: did every shard finish?\n",
                   merged.missing.size(), merged.written.origin.caseCount, merged.missing.front());
    }
    return IsClean(results) && merged.missing.empty() ? exitDone : exitDiffers;
}

/// Cases of the shard, and their numbers in the whole run.
struct ShardCases {
    std::vector<SnapshotCase> cases;
    std::vector<std::size_t> numbers;
    std::size_t total = 0;
    std::string references;
};

ShardCases SelectShard(const SnapshotArguments& arguments) {
    const Shard shard = ParseShard(arguments.shard.shard);
    Catalog catalog = ChooseCatalog(arguments);
    const std::vector<SnapshotCase> all = SelectCases(std::move(catalog.cases), arguments.pattern);
    if (all.empty()) {
        throw UsageError(fmt::format("-g {}: no snapshot matches; `scree snapshot list` shows all", arguments.pattern));
    }
    ShardCases chosen;
    chosen.references = std::move(catalog.references);
    std::size_t group = 0;
    for (const std::span<const SnapshotCase> scene : GroupByScene(all)) {
        const bool isOurs = shard.Contains(group++);
        for (const SnapshotCase& snapshotCase : scene) {
            if (isOurs) {
                chosen.cases.push_back(snapshotCase);
                chosen.numbers.push_back(chosen.total);
            }
            ++chosen.total;
        }
    }
    return chosen;
}

int RunVerify(const SnapshotArguments& arguments, const Request& request) {
    const ShardCases chosen = SelectShard(arguments);
    CheckWritable(arguments.shard.json);
    const std::vector<VerifyWay> ways = GetVerifyWays();
    const int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const std::vector<VerifyRun> runs =
        VerifySnapshots(chosen.cases, ways, request.contextOptions, jobs, {}, MakeMaking(arguments));
    std::string missing;
    for (const VerifyRun& run : runs) {
        if (run.isBackendMissing) {
            missing = run.problem;
        } else if (!run.problem.empty()) {
            throw std::runtime_error(fmt::format("{}: {}", run.way.GetName(), run.problem));
        }
    }
    if (!missing.empty() && !arguments.picture.skipMissingBackend) throw BackendError(missing);

    CaseLines lines("snapshot verify", chosen.total);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < chosen.cases.size(); ++i) {
        const std::string id = chosen.cases[i].GetId();
        const std::vector<std::string> deviants = FindDeviants(runs, i);
        lines.Add(chosen.numbers[i], {{"id", id},
                                      {"status", deviants.empty() ? "equal" : "changed"},
                                      {"pixels_and_state", runs.front().hashes[i]},
                                      {"differing", deviants}});
        if (deviants.empty()) continue;
        ++differing;
        fmt::print("differs  {}: {} against {}\n", id, fmt::join(deviants, "; "), ways.front().GetName());
    }
    if (!arguments.shard.json.empty()) WriteTextFile(arguments.shard.json, lines.GetText());
    fmt::print("{} of {} snapshots made in {} ways: {}\n", chosen.cases.size(), chosen.total,
               std::ranges::count_if(runs, [](const VerifyRun& run) { return !run.hashes.empty(); }),
               differing == 0 ? "all equal" : fmt::format("{} differ", differing));
    if (SupportedThreads(2) == 1) fmt::print("the engine takes one thread; the rasteriser was tried with 1 and 2\n");
    return differing == 0 ? exitDone : exitDiffers;
}

int RunList(const SnapshotArguments& arguments) {
    const ShardCases chosen = SelectShard(arguments);
    CheckWritable(arguments.shard.json);
    CaseLines lines("snapshot list", chosen.total);
    for (std::size_t i = 0; i < chosen.cases.size(); ++i) {
        const SnapshotCase& c = chosen.cases[i];
        const bool hasReference = fs::exists(fs::path(chosen.references) / (c.GetId() + ".png"));
        fmt::print("{:<46} size {:>4}  {:<8} {:<6} {}{}\n", c.GetId(), c.size, c.kind, c.theme, c.layers,
                   hasReference ? "" : "   (no reference)");
        lines.Add(chosen.numbers[i], {{"id", c.GetId()},
                                      {"scene", c.scene},
                                      {"size", c.size},
                                      {"step", c.step},
                                      {"kind", c.kind},
                                      {"layers", c.layers},
                                      {"theme", c.theme},
                                      {"has_reference", hasReference}});
    }
    if (!arguments.shard.json.empty()) WriteTextFile(arguments.shard.json, lines.GetText());
    return exitDone;
}

/// Throws UsageError for an option that the action does not take.
void CheckOptions(const SnapshotArguments& arguments) {
    struct Option {
        const char* name;
        bool isGiven;
        std::initializer_list<std::string_view> actions;
    };
    const Option options[] = {
        {"ARTIFACT", !arguments.artifacts.empty(), {"accept", "merge"}},
        {"-g", !arguments.pattern.empty(), {"check", "update", "accept", "verify", "list"}},
        {"--update", !arguments.update.empty(), {"check", "update", "accept"}},
        {"--state", arguments.state != "close", {"check", "update"}},
        {"--scenes", !arguments.scenes.empty(), {"check", "update", "accept", "verify", "list"}},
        {"--references", !arguments.references.empty(), {"check", "update", "accept", "verify", "list"}},
        {"--report", !arguments.report.empty(), {"check", "update", "merge"}},
        {"--junit", !arguments.junit.empty(), {"check", "update", "merge"}},
        {"--annotations", arguments.annotations, {"check", "update"}},
        {"--set", !arguments.settings.typed.empty(), {"check", "update", "verify"}},
        {"--shard", arguments.shard.shard != ShardArguments{}.shard, {"check", "update", "verify", "list"}},
        {"--json", !arguments.shard.json.empty(), {"check", "update", "verify", "list"}},
    };
    for (const Option& option : options) {
        if (!option.isGiven || std::ranges::find(option.actions, arguments.action) != option.actions.end()) continue;
        throw UsageError(fmt::format("snapshot {} takes no {}; it belongs to {}", arguments.action, option.name,
                                     fmt::join(option.actions, ", ")));
    }
}

int RunSnapshot(const SnapshotArguments& arguments, const Request& request) {
    const auto isAction = [&](std::string_view name) { return arguments.action == name; };
    if (std::ranges::none_of(actionNames, isAction)) {
        throw UsageError(DescribeUnknown("action of snapshot", arguments.action, actionNames));
    }
    CheckOptions(arguments);
    if (isAction("list")) return RunList(arguments);
    if (isAction("accept")) return RunAccept(arguments);
    if (isAction("merge")) return RunMerge(arguments);
    return SkipMissingBackend(arguments.picture, [&] {
        return isAction("verify") ? RunVerify(arguments, request) : RunCheck(arguments, request);
    });
}

}  // namespace

void AddSnapshotCommand(CLI::App& app, Request& request) {
    CLI::App* command =
        app.add_subcommand("snapshot", "Pictures of every scene, or of your own scene files, against references");
    auto arguments = std::make_shared<SnapshotArguments>();
    command
        ->add_option("ACTION", arguments->action,
                     "check: compare with the references; update: make the differences the new references; accept: "
                     "take these out of the report of a check instead; merge: join the reports of shards; verify: make "
                     "each picture twice, with 1 and 2 threads and on every backend; list: show all")
        ->required();
    command->add_option("ARTIFACT", arguments->artifacts,
                        "accept, merge: folders of reports, or a folder with some below it, as CI kept them");
    command->add_option("-g,--grep", arguments->pattern, "Only snapshots whose scene/name matches")->type_name("REGEX");
    command->add_option("--update", arguments->update,
                        "Which differences to accept: missing, changed or all (also removes references that no "
                        "snapshot has); update and accept without it: all");
    command
        ->add_option("--state", arguments->state,
                     "What must agree beside the pixels. exact: state hashes, to the bit; close: nothing, a state "
                     "that differs by less than a pixel passes and is counted")
        ->capture_default_str();
    command
        ->add_option("--scenes", arguments->scenes,
                     "Pictures of scene files, tracks and recordings in this folder, in place of the built-in scenes; "
                     "which steps and layers, snapshots.json there says")
        ->type_name("DIR");
    command
        ->add_option("--references", arguments->references,
                     "Folder of the references; if not given, references/ in that of --scenes, else the checkout's own")
        ->type_name("DIR");
    command
        ->add_option(
            "--report", arguments->report,
            fmt::format("Folder for index.html, actual/, expected/, diff/ and results.json; without it {}, only when "
                        "something differs",
                        defaultReport))
        ->type_name("DIR");
    command->add_option("--junit", arguments->junit, "Write the results as JUnit XML")->type_name("FILE");
    command->add_flag("--annotations", arguments->annotations, "Print a line `::error file=…` per difference, for CI");
    AddSetOption(*command, arguments->settings,
                 "References are made with preset=like-box2d, and these begin with it; a check tells what a setting "
                 "changes, verify takes 1 and 2 threads");
    AddShardOptions(*command, arguments->shard);
    command
        ->add_option("--backend", arguments->picture.backend,
                     "What makes the pixels: auto, osmesa, egl or cpu; verify takes them all")
        ->capture_default_str();
    command->add_flag("--skip-missing-backend", arguments->picture.skipMissingBackend,
                      "Exit with 77 instead of 3 when the backend is missing; verify goes on without it");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunSnapshot(*arguments, request); }; });
}

}  // namespace testbed
