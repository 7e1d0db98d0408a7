// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree overlap`: the same scene in several engines. How many nodes of each broad-phase tree cover every pixel, and
// the broad-phase time of every step (Tsamis 2020, section 3.8, figures 7 to 10).

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/engines/side_by_side.h"
#include "testbed/jobs/overlap/commands.h"
#include "testbed/jobs/overlap/metrics.h"
#include "testbed/jobs/overlap/picture_session.h"
#include "testbed/jobs/overlap/show_steps.h"
#include "testbed/jobs/overlap/summary.h"
#include "testbed/jobs/overlap/timing_plot.h"
#include "testbed/options/options.h"
#include "testbed/page/gnuplot.h"
#include "testbed/page/markdown.h"

namespace testbed {

namespace {

struct OverlapArguments {
    std::vector<std::string> scenes;
    SceneArguments run;
    PictureArguments picture;
    StepArguments steps;
    SequenceArguments sequence;
    std::string markdown;
};

/// The plot shows at least the steps that the dissertation's figures show.
constexpr int plotSteps = 100;

/// Draws, counts and saves the pictures of one step; returns a row of numbers per pane.
std::vector<MetricsRow> SaveOverlap(PictureSession& session, std::span<const Snapshot> snapshots,
                                    std::size_t baseline) {
    std::vector<PaneInput> inputs;
    PictureRecord all{.kind = "compare", .snapshots = {}, .rows = {}, .stats = {}, .camera = {}};
    for (const Snapshot& snapshot : snapshots) {
        all.snapshots.push_back(&snapshot);
        // The overlap counts follow below, when the picture exists.
        all.rows.push_back(MeasureSnapshot(snapshot, {}));
        inputs.push_back({&snapshot, fmt::format("sibling overlap {:.3f}", all.rows.back().siblingOverlap)});
    }
    OverlapResult result =
        session.maker.MakeOverlap(inputs, session.options, session.ChooseCamera(all.snapshots), baseline);
    all.camera = result.camera;
    all.scaleMax = result.scaleMax;
    for (std::size_t i = 0; i < result.panes.size(); ++i) {
        const OverlapStats& stats = result.panes[i].count.stats;
        all.stats.push_back(stats);
        all.rows[i].overlapMax = stats.max;
        all.rows[i].overlapMean = stats.mean;
        all.rows[i].overlapP99 = stats.p99;
    }

    for (std::size_t i = 0; i < result.panes.size(); ++i) {
        PictureRecord one = all;
        one.kind = "overlap";
        one.snapshots = {all.snapshots[i]};
        one.rows = {all.rows[i]};
        one.stats = {all.stats[i]};
        session.Save(result.panes[i].name, std::move(result.panes[i].image), one);
    }
    if (result.panes.size() > 1) session.Save("compare", std::move(result.compare), all);
    for (OverlapDifference& one : result.differences) {
        PictureRecord difference = all;
        difference.kind = "difference";
        difference.difference = &one.stats;
        const std::string name = result.differences.size() == 1 ? "" : "-" + result.panes[one.pane].name;
        session.Save("difference" + name, std::move(one.image), difference);
    }
    return all.rows;
}

void SaveTiming(PictureSession& session, const SceneJob& job, const std::vector<TimingSeries>& timing) {
    const std::filesystem::path folder(job.input.name);
    session.output.WriteText(folder / "timing.csv", WriteTimingCsv(timing));
    const std::string title = fmt::format("{}, size {}: broad phase of steps {}-{}", job.input.name, job.input.size,
                                          timing.front().steps.front().step, timing.front().steps.back().step);
    session.output.WriteBy(folder / "timing.png", [&](const std::filesystem::path& place) {
        DrawPlot(MakeTimingPlot(timing, title), "pngcairo", place);
    });
}

/// Returns the table of the scene.
PageSection RunScene(PictureSession& session, const OverlapArguments& arguments, const SceneJob& job) {
    const Panes panes = MakePanes(arguments.run, job.input);
    const int runTo = job.input.motion == nullptr ? plotSteps : std::min(plotSteps, job.input.steps);
    const bool isSequence = job.selection.worst == 0 && job.selection.Count() > 1;
    const double work = job.selection.range.last + workPerPicture * job.selection.Count();
    Progress progress(job.input.name, std::max(runTo - job.selection.range.last, 0) + (isSequence ? 3 * work : work));
    session.Begin(job.selection.Count());
    session.origin.poses = FindPoses(arguments.run, job.input);
    const auto share = [&](const StepVisits& steps) { session.Share(steps, panes.baseline); };
    if (isSequence) {
        share([&](const auto& visit) {
            SideBySide preview(job.input.Start(), panes);
            ShowSteps(preview, job.selection, 1, progress, visit);
        });
    }
    SideBySide engines(job.input.Start(), panes);
    RunSummary summary{job.input.name, job.input.size, {}, {}, panes.baseline};
    const auto show = [&](std::span<const Snapshot> snapshots) {
        session.Make([&] {
            const std::vector<MetricsRow> rows = SaveOverlap(session, snapshots, panes.baseline);
            summary.rows.insert(summary.rows.end(), rows.begin(), rows.end());
        });
    };
    ShowSteps(engines, job.selection, runTo, progress, show, share);
    session.Finish();
    summary.timing = engines.GetTiming();
    SaveMetrics(session.output, job.input.name, {summary.scene, job.input.size, session.origin.command}, summary.rows);
    SaveTiming(session, job, summary.timing);
    progress.Finish(session.Describe(engines.GetStep(), job.selection.Count()));
    fmt::print("{}{}\n", FormatSummary(summary), FormatSettings(panes));
    std::fflush(stdout);
    return MakeSummarySection(summary, panes);
}

int RunOverlap(const OverlapArguments& arguments, const Request& request) {
    const std::vector<SceneJob> jobs = MakeJobs(arguments.scenes, arguments.run, arguments.steps);
    for (const SceneJob& job : jobs) (void)MakePanes(arguments.run, job.input);
    const PictureOptions options = MakePictureOptions(arguments.picture);
    const SequenceOptions sequence = MakeSequenceOptions(arguments.sequence, options.width, options.theme);
    for (const SceneJob& job : jobs) CheckSheet(sequence, job.selection.Count());
    CheckGnuplot();
    PictureSession session = MakePictureSession(
        {arguments.picture, arguments.run, arguments.sequence, options, DescribeCommand(request.arguments)},
        request.contextOptions);
    std::vector<PageSection> tables;
    for (const SceneJob& job : jobs) tables.push_back(RunScene(session, arguments, job));
    if (!arguments.markdown.empty())
        WriteMarkdown(arguments.markdown, MakeSummaryPage(std::move(tables), DescribeCommand(request.arguments)));
    fmt::print("{}", FormatFiles(session.output.GetFiles()));
    return exitDone;
}

}  // namespace

void AddOverlapCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand(
        "overlap",
        "Overlap of broad-phase trees in every engine, as pictures and numbers, with the times of all steps");
    auto arguments = std::make_shared<OverlapArguments>();
    command->add_option("SCENE", arguments->scenes, DescribeSceneArgument("Scenes"));
    AddStepOptions(*command, arguments->steps);
    AddSequenceOptions(*command, arguments->sequence);
    AddRunOptions(*command, arguments->run);
    AddCountOptions(*command, arguments->picture);
    AddLookOptions(*command, arguments->picture);
    AddMarkdownOption(*command, arguments->markdown);
    command->callback([&request, arguments] {
        request.action = [&request, arguments] {
            return SkipMissingBackend(arguments->picture, [&] { return RunOverlap(*arguments, request); });
        };
    });
}

}  // namespace testbed
