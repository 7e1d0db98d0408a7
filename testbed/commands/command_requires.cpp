// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree requires`: what a scene needs of our engine, who needs it, and what everything else costs.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/commands/arguments.h"
#include "testbed/commands/commands.h"
#include "testbed/commands/exit_code.h"
#include "testbed/report/ablation.h"
#include "testbed/report/output.h"
#include "testbed/report/progress.h"
#include "testbed/report/requirement.h"

namespace testbed {

namespace {

struct RequiresArguments {
    std::string scene;
    int size = 0;
    int steps = 0;
    int substeps = 0;
    bool continuous = false;
    bool caps = false;
    bool quick = false;
    bool ablation = false;
    std::string header;
    std::string output = "out/requires";
};

constexpr int mostSteps = 200, quickSteps = 60;

RequirementPlan MakePlan(const RequiresArguments& arguments, const scenes::Scene& scene) {
    RequirementPlan plan;
    plan.steps =
        arguments.steps > 0 ? arguments.steps : std::min(scene.steps, arguments.quick ? quickSteps : mostSteps);
    plan.repeats = arguments.quick ? 3 : 9;
    plan.substeps = arguments.substeps;
    plan.continuous = arguments.continuous;
    plan.caps = arguments.caps;
    return plan;
}

bool AreHashesEqual(const Requirement& requirement) {
    return std::ranges::all_of(requirement.variants, &VariantCost::sameHash);
}

struct SceneRequest {
    scenes::Scene scene;
    RequirementPlan plan;
};

/// Scenes of an ablation without SCENE: one of each theme, small enough that all of them take minutes; size 0: default.
constexpr std::pair<const char*, int> ablationScenes[] = {
    {"slow-explosion", 6000}, {"mixed", 3000},  {"add-pair", 2000}, {"falling-circles", 40},
    {"falling-squares", 40},  {"pyramid", 20},  {"tiles", 60},      {"mostly-static-multi", 100},
    {"multi-fixture", 20},    {"ragdolls", 12}, {"big-mobile", 8},  {"restitution-row", 0},
    {"conveyor", 1},          {"tumbler", 300}};

std::vector<SceneRequest> ChooseScenes(const RequiresArguments& arguments) {
    std::vector<SceneRequest> chosen;
    const auto add = [&](const std::string& name, int size) {
        scenes::Scene scene = size > 0 ? scenes::Build(name, size) : scenes::Build(name);
        const RequirementPlan plan = MakePlan(arguments, scene);
        chosen.push_back({std::move(scene), plan});
    };
    if (!arguments.scene.empty()) {
        add(arguments.scene, arguments.size);
    } else {
        for (const auto& [name, size] : ablationScenes) add(name, size);
    }
    return chosen;
}

int RunAblation(const RequiresArguments& arguments, const Request& request) {
    const std::vector<SceneRequest> chosen = ChooseScenes(arguments);
    OutputFolder output(arguments.output);
    std::vector<Requirement> requirements;
    std::vector<AblationRow> rows;
    for (const SceneRequest& one : chosen) {
        Progress progress(one.scene.name, one.plan.repeats * (1 + CountAblationRuns()));
        const auto advance = [&] { progress.Advance(1.0); };
        requirements.push_back(MeasureRequirement(one.scene, one.plan, advance));
        const std::vector<AblationRow> more = MeasureAblation(one.scene, one.plan, advance);
        rows.insert(rows.end(), more.begin(), more.end());
        progress.Finish(FormatChange(requirements.back()));
    }
    output.WriteText("ablation.csv", MakeAblationCsv(rows));
    output.WriteText("ablation.json", MakeAblationJson(rows));
    output.WriteText("index.html", MakePage(MakeAblationPage(requirements, rows, DescribeCommand(request.arguments))));
    for (const std::string& file : output.GetFiles()) fmt::print("{}\n", file);
    const bool same = std::ranges::all_of(requirements, AreHashesEqual) &&
                      std::ranges::all_of(rows, [](const AblationRow& row) { return row.without.sameHash; });
    return same ? exitDone : exitDiffers;
}

int RunRequires(const RequiresArguments& arguments, const Request& request) {
    if (arguments.ablation) return RunAblation(arguments, request);
    if (arguments.scene.empty()) throw UsageError("give a SCENE, or --ablation for a choice of them");
    const SceneRequest chosen = ChooseScenes(arguments).front();
    const scenes::Scene& scene = chosen.scene;
    const RequirementPlan& plan = chosen.plan;
    Progress progress(scene.name, plan.repeats);
    const Requirement requirement = MeasureRequirement(scene, plan, [&] { progress.Advance(1.0); });
    progress.Finish(fmt::format("{} repeats", plan.repeats));
    fmt::print("{}", FormatRequirement(requirement));
    if (!arguments.header.empty()) {
        WriteTextFile(arguments.header, MakeFeatureHeader(requirement, DescribeCommand(request.arguments)));
        fmt::print("{}\n", arguments.header);
    }
    return AreHashesEqual(requirement) ? exitDone : exitDiffers;
}

}  // namespace

void AddRequiresCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand("requires", "What a scene needs of our engine, and what the rest costs");
    auto arguments = std::make_shared<RequiresArguments>();
    command->add_option("SCENE", arguments->scene, "A scene; `scree list` shows them");
    command->add_option("SIZE", arguments->size, "Its size; the scene's default if not given");
    command->add_option("--steps", arguments->steps, "Steps to run; at most 200 of the scene's if not given")
        ->check(CLI::Range(1, maxStep));
    command->add_option("--substeps", arguments->substeps, "Soft step with so many sub-steps")
        ->check(CLI::Range(1, 64));
    command->add_flag("--continuous", arguments->continuous, "With continuous collision");
    command->add_flag("--caps", arguments->caps, "With Box2D's caps on speed");
    command->add_flag("--quick", arguments->quick, "Fewer steps and repeats");
    command->add_flag("--ablation", arguments->ablation,
                      "A report of what each feature costs; without SCENE of a choice");
    command->add_option("-o,--output", arguments->output, "Folder for the report of --ablation")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_option("--header", arguments->header, "Write the set as a C++ header")->type_name("FILE");
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunRequires(*arguments, request); }; });
}

}  // namespace testbed
