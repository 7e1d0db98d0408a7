// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree requires`: what a scene needs of our engine, who needs it, and what everything else costs.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/csv.h"
#include "testbed/base/errors.h"
#include "testbed/base/new_file.h"
#include "testbed/base/output.h"
#include "testbed/base/progress.h"
#include "testbed/engines/panes.h"
#include "testbed/engines/provenance.h"
#include "testbed/jobs/requires/ablation.h"
#include "testbed/jobs/requires/break_even.h"
#include "testbed/jobs/requires/commands.h"
#include "testbed/jobs/requires/requirement.h"
#include "testbed/options/options.h"
#include "testbed/page/facts.h"
#include "testbed/page/gnuplot.h"
#include "testbed/page/markdown.h"
#include "testbed/page/plot.h"

namespace testbed {

namespace {

struct RequiresArguments {
    std::string scene;
    std::optional<int> size;
    InputArguments input;
    int steps = 0;
    SettingArguments settings;
    bool quick = false;
    bool ablation = false;
    bool breakEven = false;
    std::string header;
    std::string output = "out/requires";
    std::string markdown;
};

constexpr int mostSteps = 200, quickSteps = 60;

/// Caps on speed and continuous collision are what few scenes ask for: only those that --set asks for are required.
constexpr std::string_view requirementBase = "continuous=off";

RequirementTask MakeTask(const RequiresArguments& arguments, const scenes::Scene& scene) {
    const std::vector<TypedSetting>& typed = arguments.settings.typed;
    for (const TypedSetting& one : typed) {
        if (!one.setting.starts_with("features=")) continue;
        throw UsageError(one.source + ": features are what `scree requires` finds out");
    }
    RequirementTask task{.spec = ParseSpec("scree", typed, requirementBase)};
    task.steps =
        arguments.steps > 0 ? arguments.steps : std::min(scene.steps, arguments.quick ? quickSteps : mostSteps);
    task.repeats = arguments.quick ? 3 : 9;
    return task;
}

bool AreHashesEqual(const Requirement& requirement) {
    return std::ranges::all_of(requirement.variants, &VariantCost::sameHash);
}

struct SceneRequest {
    scenes::Scene scene;
    RequirementTask task;
};

/// Scenes of an ablation without SCENE: one of each theme, small enough that all of them take minutes; size 0: default.
constexpr std::pair<const char*, int> ablationScenes[] = {
    {"slow-explosion", 6000}, {"mixed", 3000},  {"add-pair", 2000}, {"falling-circles", 40},
    {"falling-squares", 40},  {"pyramid", 20},  {"tiles", 60},      {"mostly-static-multi", 100},
    {"multi-fixture", 20},    {"ragdolls", 12}, {"big-mobile", 8},  {"restitution-row", 0},
    {"conveyor", 1},          {"tumbler", 300}};

std::vector<SceneRequest> ChooseScenes(const RequiresArguments& arguments) {
    std::vector<SceneRequest> chosen;
    const auto add = [&](const std::string& given, std::optional<int> size, const InputArguments& input) {
        scenes::Scene scene = ChooseScene(given, size, input).Build();
        RequirementTask task = MakeTask(arguments, scene);
        chosen.push_back({std::move(scene), std::move(task)});
    };
    if (!arguments.scene.empty()) {
        add(arguments.scene, arguments.size, arguments.input);
    } else {
        for (const auto& [name, size] : ablationScenes) {
            add(name, size > 0 ? std::optional(size) : std::nullopt, {});
        }
    }
    return chosen;
}

/// The parts of a report, as they come.
struct Report {
    OutputFolder output;
    Page page;
    std::vector<PageSection> details;  ///< for the end of the page
    bool same = true;                  ///< all hashes

    Report(const RequiresArguments& arguments, const Request& request)
        : output(arguments.output),
          page{.title = "What a scene requires",
               .intro =
                   "Every feature of the engine has a neutral value at which leaving it out changes no bit. A "
                   "world leaves out what nobody in it uses; here is what that saves, and where parts of the "
                   "engine begin to pay.",
               .facts = {}} {
        AddFacts(page, DescribeCommand(request.arguments), ToJson(FindProvenance()));
        page.facts.push_back({"settings", PrintSettings(MakeTask(arguments, scenes::Scene{}).spec)});
    }

    int Finish(const std::string& markdown) {
        std::ranges::move(details, std::back_inserter(page.sections));
        output.WriteText("index.html", MakePage(page));
        if (!markdown.empty()) WriteMarkdown(markdown, page);
        for (const std::string& file : output.GetFiles()) fmt::print("{}\n", file);
        return same ? exitDone : exitDiffers;
    }
};

void AddAblation(const RequiresArguments& arguments, Report& report) {
    std::vector<Requirement> requirements;
    std::vector<AblationRow> rows;
    for (const SceneRequest& one : ChooseScenes(arguments)) {
        Progress progress(one.scene.name, one.task.repeats * (1 + CountAblationRuns()));
        const auto advance = [&] { progress.Advance(1.0); };
        requirements.push_back(MeasureRequirement(one.scene, one.task, advance));
        const std::vector<AblationRow> more = MeasureAblation(one.scene, one.task, advance);
        rows.insert(rows.end(), more.begin(), more.end());
        progress.Finish(FormatChange(requirements.back()));
    }
    report.output.WriteText("ablation.csv", MakeAblationCsv(rows));
    report.output.WriteText("ablation.json", MakeAblationJson(rows));
    report.page.sections.push_back(MakeRequirementSection(requirements));
    report.page.sections.push_back(MakeAblationSection(rows));
    report.details.push_back(MakeAblationDetails(rows));
    report.same = report.same && std::ranges::all_of(requirements, AreHashesEqual) &&
                  std::ranges::all_of(rows, [](const AblationRow& row) { return row.without.sameHash; });
}

/// One plot of the report, and its points as text.
void AddPlot(Report& report, const std::string& name, Plot plot, const std::vector<BreakEvenPoint>& points,
             PageFigures& figures) {
    CsvTable csv{"share", "ns_without", "ns_with"};
    for (const BreakEvenPoint& point : points) {
        csv.AddRow(point.share, fmt::format("{:.2f}", point.nsWithout), fmt::format("{:.2f}", point.nsWith));
        plot.curves[0].points.push_back({point.share, point.nsWithout});
        plot.curves[1].points.push_back({point.share, point.nsWith});
    }
    report.output.WriteText(name + ".csv", csv.GetText());
    report.output.WriteBy(name + ".svg", [&](const std::filesystem::path& place) { DrawPlot(plot, "svg", place); });
    figures.figures.push_back(
        {.title = plot.title, .caption = DescribeBreakEven(points), .file = report.output.Prepare(name + ".svg")});
}

void AddBreakEven(const RequiresArguments& arguments, Report& report) {
    BreakEvenPlan plan;
    if (arguments.quick) plan.movers = 2000, plan.repeats = 3;
    plan.shares = {0.0, 0.01, 0.03, 0.06, 0.09, 0.125, 0.16, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7};
    BreakEvenPlan isolated = plan;
    for (const double share : {0.8, 0.9, 1.0}) isolated.shares.push_back(share);
    Progress progress("break-even", 3.0 * static_cast<double>(plan.shares.size()) +
                                        2.0 * static_cast<double>(isolated.shares.size()));
    const auto advance = [&] { progress.Advance(1.0); };
    PageFigures figures;
    const std::string note = fmt::format("{} moving circles, {} steps, least of {} repeats of each step", plan.movers,
                                         plan.steps, plan.repeats);
    const auto curves = [](const char* without, const char* with) {
        return std::vector<PlotCurve>{{without, ourLooks[0]}, {with, boxTwoDLook}};
    };
    for (const auto& [layout, name] :
         {std::pair(StaticLayout::scattered, "scattered"), {StaticLayout::beside, "beside"}}) {
        AddPlot(report, fmt::format("static-share-{}", name),
                {.title = fmt::format("Static circles {} moving ones: one tree or two",
                                      layout == StaticLayout::scattered ? "among" : "beside"),
                 .xLabel = "static share of the fixtures",
                 .yLabel = "broad phase [ns a mover and step]",
                 .note = note,
                 .curves = curves("in one tree", "in a tree of their own")},
                MeasureStaticShare(plan, layout, advance), figures);
    }
    for (const int substeps : {0, 4}) {
        AddPlot(report, substeps == 0 ? "isolated-share-8-3" : "isolated-share-soft-4",
                {.title = fmt::format("Bodies that nothing touches, {}",
                                      substeps == 0 ? "sequential impulses 8/3" : "soft step of 4"),
                 .xLabel = "share of the circles in free fall, others lie on the ground",
                 .yLabel = "islands and solver [ns a mover and step]",
                 .note = note,
                 .curves = curves("through the solver like all", "integrated apart")},
                MeasureIsolatedShare(isolated, substeps, advance), figures);
    }
    AddPlot(report, "fast-share",
            {.title = "Fast bodies: the price of continuous collision",
             .xLabel = "share of bodies that cross twice their size in a step",
             .yLabel = "whole step [ns a mover]",
             .note = note,
             .curves = curves("continuous collision off", "on")},
            MeasureFastShare(plan, advance), figures);
    progress.Finish(fmt::format("{} shares", plan.shares.size()));
    report.page.sections.push_back(
        {.title = "Break-even",
         .intro = "The same world with a part of the engine on and off, over the share of what it is made for. A part "
                  "pays where its curve is the lower one.",
         .blocks = {figures}});
}

int RunReport(const RequiresArguments& arguments, const Request& request) {
    const bool both = !arguments.ablation && !arguments.breakEven;
    const bool plots = both || arguments.breakEven;
    if (plots) CheckGnuplot();
    Report report(arguments, request);
    if (both || arguments.ablation) AddAblation(arguments, report);
    if (plots) AddBreakEven(arguments, report);
    return report.Finish(arguments.markdown);
}

int RunRequires(const RequiresArguments& arguments, const Request& request) {
    if (arguments.scene.empty() || arguments.ablation || arguments.breakEven) return RunReport(arguments, request);
    if (!arguments.markdown.empty()) {
        throw UsageError("--markdown writes a report: leave SCENE out, or add --ablation");
    }
    const SceneRequest chosen = ChooseScenes(arguments).front();
    const scenes::Scene& scene = chosen.scene;
    const RequirementTask& task = chosen.task;
    std::optional<NewFile> header;
    if (!arguments.header.empty()) {
        header.emplace(arguments.header);
        header->Write("");  // what cannot be written is found before the run
    }
    Progress progress(scene.name, task.repeats);
    const Requirement requirement = MeasureRequirement(scene, task, [&] { progress.Advance(1.0); });
    progress.Finish(fmt::format("{} repeats", task.repeats));
    fmt::print("{}", FormatRequirement(requirement));
    if (header) {
        header->Write(MakeFeatureHeader(requirement, DescribeCommand(request.arguments)));
        header->Finish();
        fmt::print("{}\n", arguments.header);
    }
    return AreHashesEqual(requirement) ? exitDone : exitDiffers;
}

}  // namespace

void AddRequiresCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("requires", "What a scene needs of our engine, and what the rest costs");
    auto arguments = std::make_shared<RequiresArguments>();
    command->add_option("SCENE", arguments->scene,
                        DescribeSceneArgument("A scene") + "; if not given, a report of a selection of scenes is made");
    command->add_option("SIZE", arguments->size, "Its size; the scene's default if not given");
    AddInputOptions(*command, arguments->input);
    command->add_option("--steps", arguments->steps, "Steps to run; at most 200 of the scene's if not given")
        ->check(CLI::Range(1, maxStep));
    AddSetOption(*command, arguments->settings,
                 "Runs begin with continuous=off. All keys but features, which this command finds; the plots of "
                 "--break-even have settings of their own");
    AddSettingFlags(*command, arguments->settings, {"continuous", "caps"});
    command->add_flag("--quick", arguments->quick, "At most 60 steps, and 3 repeats instead of 9");
    command->add_flag("--ablation", arguments->ablation,
                      "Only what each feature costs, in SCENE or in a selection of scenes");
    command->add_flag("--break-even", arguments->breakEven,
                      "Only the plots of where parts of the engine begin to pay; needs gnuplot");
    command->add_option("-o,--output", arguments->output, "Folder for the report")
        ->type_name("DIR")
        ->capture_default_str();
    AddMarkdownOption(*command, arguments->markdown);
    command->add_option("--header", arguments->header, "Write the features that SCENE needs as a C++ header")
        ->type_name("FILE");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunRequires(*arguments, request); }; });
}

}  // namespace testbed
