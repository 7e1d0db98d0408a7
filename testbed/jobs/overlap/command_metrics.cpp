// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree metrics`: the numbers of every step without any picture; overlap is counted on the CPU, no GL is opened.

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"
#include "testbed/engines/side_by_side.h"
#include "testbed/jobs/overlap/commands.h"
#include "testbed/jobs/overlap/metrics.h"
#include "testbed/jobs/overlap/show_steps.h"
#include "testbed/jobs/overlap/summary.h"
#include "testbed/options/options.h"
#include "testbed/page/markdown.h"

namespace testbed {

namespace {

struct MetricsArguments {
    std::string scene;
    std::string steps;
    SceneArguments run;
    PictureArguments picture;
    std::string markdown;
};

int RunMetrics(const MetricsArguments& arguments, const Request& request) {
    std::vector<std::string> names;
    if (!arguments.scene.empty()) names.push_back(arguments.scene);
    SceneJob job = MakeJobs(names, arguments.run, {}).front();
    job.selection.range = arguments.steps.empty() ? FullRun(job.input) : ParseSteps(arguments.steps, true);
    CheckSteps(job.selection.range, job.input);
    const Panes panes = MakePanes(arguments.run, job.input);
    const PictureOptions options = MakePictureOptions(arguments.picture);
    OutputFolder output(arguments.run.output);

    const std::string& name = job.input.name;
    Progress progress(name, job.selection.range.last + workPerPicture * job.selection.Count());
    SideBySide engines(job.input.Start(), panes);
    RunSummary summary{name, job.input.size, {}, {}, panes.baseline};
    ShowSteps(engines, job.selection, 1, progress, [&](std::span<const Snapshot> snapshots) {
        std::vector<const Snapshot*> pointers;
        for (const Snapshot& snapshot : snapshots) pointers.push_back(&snapshot);
        const Camera camera = ChooseCamera(pointers, options);
        for (const Snapshot& snapshot : snapshots) {
            summary.rows.push_back(MeasureSnapshot(snapshot, CountOverlap(snapshot, camera, options).stats));
        }
    });
    summary.timing = engines.GetTiming();
    SaveMetrics(output, name, {name, job.input.size, DescribeCommand(request.arguments)}, summary.rows);
    if (!arguments.markdown.empty())
        WriteMarkdown(arguments.markdown,
                      MakeSummaryPage({MakeSummarySection(summary, panes)}, DescribeCommand(request.arguments)));
    progress.Finish(fmt::format("{} steps, {} measured", engines.GetStep(), job.selection.Count()));
    fmt::print("{}{}\n{}", FormatSummary(summary), FormatSettings(panes), FormatFiles(output.GetFiles()));
    return exitDone;
}

}  // namespace

void AddMetricsCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("metrics", "The numbers of every step, without pictures");
    auto arguments = std::make_shared<MetricsArguments>();
    command->add_option("SCENE", arguments->scene, DescribeSceneArgument("A scene"));
    command
        ->add_option("--steps", arguments->steps,
                     "Number of steps, or first:last or first:last:stride; a full run if not given")
        ->type_name("N|A:B:S");
    AddRunOptions(*command, arguments->run);
    AddCountOptions(*command, arguments->picture);
    AddMarkdownOption(*command, arguments->markdown);
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunMetrics(*arguments, request); }; });
}

}  // namespace testbed
