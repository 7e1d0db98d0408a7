// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree render`: the scene itself in each engine, drawn in layers.

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/engines/side_by_side.h"
#include "testbed/jobs/overlap/commands.h"
#include "testbed/jobs/overlap/picture_session.h"
#include "testbed/jobs/overlap/show_steps.h"
#include "testbed/jobs/overlap/summary.h"
#include "testbed/options/options.h"
#include "testbed/view/layers.h"

namespace testbed {

namespace {

struct RenderArguments {
    std::string scene;
    std::string layers = "bodies,contacts,normals,joints";
    bool noLegend = false;
    SceneArguments run;
    PictureArguments picture;
    StepArguments steps;
    SequenceArguments sequence;
};

/// render-<pane>.png, so that both commands can share a folder.
void SaveRender(PictureSession& session, std::span<const Snapshot> snapshots) {
    std::vector<const Snapshot*> pointers;
    for (const Snapshot& snapshot : snapshots) pointers.push_back(&snapshot);
    const Camera camera = session.ChooseCamera(pointers);
    for (const Snapshot* snapshot : pointers) {
        const PaneInput input{snapshot, fmt::format("{} contacts", snapshot->contactCount)};
        const PictureRecord record{
            .kind = "render", .snapshots = {snapshot}, .rows = {}, .stats = {}, .camera = camera};
        session.Save("render-" + snapshot->GetName(), session.maker.MakeRender(input, session.options, camera), record);
    }
}

int RunRender(const RenderArguments& arguments, const Request& request) {
    std::vector<std::string> names;
    if (!arguments.scene.empty()) names.push_back(arguments.scene);
    const SceneJob job = MakeJobs(names, arguments.run, arguments.steps).front();
    const Panes panes = MakePanes(arguments.run, job.input);
    PictureOptions options = MakePictureOptions(arguments.picture);
    options.layers = ParseLayers(arguments.layers);
    options.legend = !arguments.noLegend;
    CheckSheet(MakeSequenceOptions(arguments.sequence, options.width, options.theme), job.selection.Count());
    PictureSession session = MakePictureSession(
        {arguments.picture, arguments.run, arguments.sequence, options, DescribeCommand(request.arguments)},
        request.contextOptions);

    session.Begin(job.selection.Count());
    session.origin.poses = FindPoses(arguments.run, job.input);
    const bool isSequence = job.selection.worst == 0 && job.selection.Count() > 1;
    const double work = job.selection.range.last + workPerPicture * job.selection.Count();
    Progress progress(job.input.name, isSequence ? 2 * work : work);
    const auto share = [&](const StepVisits& steps) { session.Share(steps, std::nullopt); };
    if (isSequence) {
        share([&](const auto& visit) {
            SideBySide preview(job.input.Start(), panes);
            ShowSteps(preview, job.selection, 1, progress, visit);
        });
    }
    SideBySide engines(job.input.Start(), panes, {.sweptBoxes = options.layers.Has(Layer::swept)});
    const auto show = [&](std::span<const Snapshot> snapshots) {
        session.Make([&] { SaveRender(session, snapshots); });
    };
    ShowSteps(engines, job.selection, 1, progress, show, share);
    session.Finish();
    progress.Finish(session.Describe(engines.GetStep(), job.selection.Count()));
    fmt::print("{}", FormatFiles(session.output.GetFiles()));
    return exitDone;
}

}  // namespace

void AddRenderCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("render", "The scene itself in each engine, drawn in layers");
    auto arguments = std::make_shared<RenderArguments>();
    command->add_option("SCENE", arguments->scene, DescribeSceneArgument("A scene"));
    command->add_option("--layers", arguments->layers, "What to draw, names with commas:\n" + DescribeLayers())
        ->capture_default_str();
    command->add_flag("--no-legend", arguments->noLegend, "Leave out the legend");
    AddStepOptions(*command, arguments->steps);
    AddSequenceOptions(*command, arguments->sequence);
    AddRunOptions(*command, arguments->run);
    AddCountOptions(*command, arguments->picture);
    AddLookOptions(*command, arguments->picture);
    command->callback([&request, arguments] {
        request.action = [&request, arguments] {
            return SkipMissingBackend(arguments->picture, [&] { return RunRender(*arguments, request); });
        };
    });
}

}  // namespace testbed
