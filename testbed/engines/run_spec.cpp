// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The table of keys, and reading and printing by it.

#include "testbed/engines/run_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scree/broad_phase_kind.h"
#include "scree/features.h"
#include "scree/settings.h"
#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_list.h"

namespace testbed {

namespace {

constexpr int maxVelocityIterations = 200, maxPositionIterations = 200, maxSubsteps = 64;
constexpr double minTimeStep = 0.0001, maxTimeStep = 0.1;       // s
constexpr float minLengthScale = 1e-6f, maxLengthScale = 1e6f;  // m
constexpr std::array<std::string_view, 4> markNames = {"draft", "game", "fine", "precise"};
constexpr float minSoftTuning = 0.001f, maxSoftTuning = 1e6f;
constexpr std::string_view ofScene = "scene", ofEngine = "own";
constexpr std::string_view directJoints = "direct", iterativeJoints = "iterative";

/// What a reader returns for text that has not the form of a value.
std::string NotAValue() { return "is none"; }
std::string Done() { return {}; }

template <typename Number>
std::string ReadNumberInto(std::string_view value, Number& number) {
    const Parsed<Number> read = ParseNumber<Number>(value);
    if (!read) return NotAValue();
    number = *read;
    return Done();
}

/// "8/3" or "8,3".
std::vector<std::string_view> SplitNumbers(std::string_view value) {
    return Split(value, value.find('/') == std::string_view::npos ? ',' : '/');
}

/// A switch of the spec, by its member.
template <bool RunSpec::*member>
std::string ReadSwitch(std::string_view value, RunSpec& spec) {
    if (value != "on" && value != "off") return NotAValue();
    spec.*member = value == "on";
    return Done();
}
template <bool RunSpec::*member>
std::string PrintSwitch(const RunSpec& spec) {
    return spec.*member ? "on" : "off";
}

std::string ReadJoints(std::string_view value, RunSpec& spec) {
    if (value != directJoints && value != iterativeJoints) return NotAValue();
    spec.directJoints = value == directJoints;
    return Done();
}

/// A number of the spec that is the engine's own unless it is given, by its member.
template <std::optional<float> RunSpec::*member>
std::string ReadOwnOr(std::string_view value, RunSpec& spec) {
    if (value == ofEngine) {
        (spec.*member).reset();
        return Done();
    }
    float number = 0;
    const std::string problem = ReadNumberInto(value, number);
    if (problem.empty()) spec.*member = number;
    return problem;
}
template <std::optional<float> RunSpec::*member>
std::string PrintOwnOr(const RunSpec& spec) {
    return spec.*member ? fmt::format("{}", *(spec.*member)) : std::string(ofEngine);
}

std::string ReadIterations(std::string_view value, RunSpec& spec) {
    if (value == ofScene) {
        spec.solver = SequentialImpulses{};
        return Done();
    }
    const std::vector<std::string_view> parts = SplitNumbers(value);
    const Parsed<int> velocity = ParseNumber<int>(parts.front()), position = ParseNumber<int>(parts.back());
    if (parts.size() != 2 || !velocity || !position) return NotAValue();
    spec.solver = SequentialImpulses{Iterations{*velocity, *position}};
    return Done();
}

std::string ReadSubsteps(std::string_view value, RunSpec& spec) {
    const Parsed<int> substeps = ParseNumber<int>(value);
    if (!substeps) return NotAValue();
    spec.solver = SoftStep{*substeps};
    return Done();
}

std::string ReadSolver(std::string_view value, RunSpec& spec) {
    if (value == "si") return ReadIterations(ofScene, spec);
    if (value == "soft") {
        spec.solver = SoftStep{};
        return Done();
    }
    constexpr std::string_view si = "si@", soft = "soft@";
    if (value.starts_with(si)) return ReadIterations(value.substr(si.size()), spec);
    if (value.starts_with(soft)) return ReadSubsteps(value.substr(soft.size()), spec);
    return NotAValue();
}

std::string PrintSolver(const RunSpec& spec) {
    if (const auto* soft = std::get_if<SoftStep>(&spec.solver)) return fmt::format("soft@{}", soft->substeps);
    const auto* si = std::get_if<SequentialImpulses>(&spec.solver);
    if (si == nullptr) return {};
    return si->iterations ? fmt::format("si@{}/{}", si->iterations->velocity, si->iterations->position) : "si";
}

std::string ReadAccuracy(std::string_view value, RunSpec& spec) {
    const auto found = std::ranges::find(markNames, value);
    if (found == markNames.end()) return DescribeUnknown("mark", value, markNames);
    spec.solver = static_cast<Accuracy>(found - markNames.begin());
    return Done();
}

std::string PrintAccuracy(const RunSpec& spec) {
    const auto* mark = std::get_if<Accuracy>(&spec.solver);
    return mark == nullptr ? std::string() : std::string(markNames[static_cast<std::size_t>(*mark)]);
}

std::string ReadTolerance(std::string_view value, RunSpec& spec) {
    const std::vector<std::string_view> parts = SplitNumbers(value);
    Tolerance tolerance;
    const bool isRead = (parts.size() == 1 || parts.size() == 2 || parts.size() == 4) &&
                        ReadNumberInto(parts[0], tolerance.overlap).empty() &&
                        (parts.size() < 2 || ReadNumberInto(parts[1], tolerance.jointGap).empty()) &&
                        (parts.size() < 4 || (ReadNumberInto(parts[2], tolerance.leastSubsteps).empty() &&
                                              ReadNumberInto(parts[3], tolerance.mostSubsteps).empty()));
    if (!isRead) return NotAValue();
    spec.solver = tolerance;
    return Done();
}

std::string PrintTolerance(const RunSpec& spec) {
    const auto* t = std::get_if<Tolerance>(&spec.solver);
    if (t == nullptr) return {};
    const Tolerance usual;
    if (t->leastSubsteps != usual.leastSubsteps || t->mostSubsteps != usual.mostSubsteps) {
        return fmt::format("{}/{}/{}/{}", t->overlap, t->jointGap, t->leastSubsteps, t->mostSubsteps);
    }
    return t->jointGap != usual.jointGap ? fmt::format("{}/{}", t->overlap, t->jointGap)
                                         : fmt::format("{}", t->overlap);
}

std::string ReadTimeStep(std::string_view value, RunSpec& spec) {
    if (value == ofScene) {
        spec.timeStep.reset();
        return Done();
    }
    const bool isFraction = value.starts_with("1/");
    const Parsed<double> number = ParseNumber<double>(isFraction ? value.substr(2) : value);
    if (!number) return NotAValue();
    spec.timeStep = isFraction ? 1.0 / *number : *number;
    return Done();
}

std::string PrintTimeStep(const RunSpec& spec) {
    if (!spec.timeStep) return std::string(ofScene);
    const double rate = std::round(1.0 / *spec.timeStep);
    return 1.0 / rate == *spec.timeStep ? fmt::format("1/{:.0f}", rate) : fmt::format("{}", *spec.timeStep);
}

std::string ReadGravity(std::string_view value, RunSpec& spec) {
    if (value == ofScene) {
        spec.gravity.reset();
        return Done();
    }
    const std::vector<std::string_view> parts = SplitNumbers(value);
    const Parsed<float> x = ParseNumber<float>(parts.front()), y = ParseNumber<float>(parts.back());
    if (parts.size() != 2 || !x || !y) return NotAValue();
    spec.gravity = scenes::Vec2{*x, *y};
    return Done();
}

std::string PrintGravity(const RunSpec& spec) {
    return spec.gravity ? fmt::format("{}/{}", spec.gravity->x, spec.gravity->y) : std::string(ofScene);
}

std::string ReadFeatures(std::string_view value, RunSpec& spec) {
    if (value == "automatic" || value == "full" || value == "none") {
        spec.features = value;
        return Done();
    }
    scree::Features chosen;
    for (const std::string_view name : Split(value, '+')) {
        const auto feature = scree::FeatureFromName(name);
        if (!feature) {
            return DescribeUnknown(
                "feature", name, std::vector<std::string_view>(scree::featureNames.begin(), scree::featureNames.end()));
        }
        chosen.Add(*feature);
    }
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < scree::featureNames.size(); ++i) {
        if (chosen.Has(static_cast<scree::Feature>(i))) names.emplace_back(scree::featureNames[i]);
    }
    spec.features = fmt::format("{}", fmt::join(names, "+"));
    return Done();
}

std::string ReadBroadPhase(std::string_view value, RunSpec& spec) {
    if (!scree::BroadPhaseFromName(value)) return DescribeUnknown("broad phase", value, scree::broadPhaseNames);
    spec.broadPhase = value;
    return Done();
}

std::string ReadPreset(std::string_view value, RunSpec& spec) {
    const auto found = std::ranges::find(GetPresets(), value, &Preset::name);
    if (found == GetPresets().end()) {
        std::vector<std::string_view> names;
        for (const Preset& preset : GetPresets()) names.push_back(preset.name);
        return DescribeUnknown("preset", value, names);
    }
    spec = RunSpec{.engine = spec.engine};
    if (!FindEngine(spec.engine).abilities.Has(Ability::sequential)) spec.solver = SoftStep{};
    ApplySettings(spec, found->settings);
    return Done();
}

std::string PrintNothing(const RunSpec&) { return {}; }

constexpr unsigned softSteps = static_cast<unsigned>(Ability::softSteps);
constexpr unsigned sequential = static_cast<unsigned>(Ability::sequential);
constexpr unsigned dial = static_cast<unsigned>(Ability::dial);
constexpr unsigned softTuning = static_cast<unsigned>(Ability::softTuning);
constexpr unsigned joints = static_cast<unsigned>(Ability::joints);

constexpr SettingKey settingKeys[] = {
    {.name = "preset",
     .values = "own or like-box2d",
     .unit = "",
     .what = "all settings at once; those that follow change it",
     .flag = "",
     .needs = 0,
     .isLive = false,
     .read = ReadPreset,
     .print = PrintNothing},
    {.name = "solver",
     .values = "si, si@VELOCITY/POSITION, soft or soft@SUBSTEPS",
     .unit = "",
     .what = "sequential impulses (with the scene's iterations if none are given), or the soft step (4 sub-steps)",
     .flag = "--solver",
     .needs = 0,
     .isLive = true,
     .read = ReadSolver,
     .print = PrintSolver},
    {.name = "iterations",
     .values = "VELOCITY/POSITION, 1 to 200 and 0 to 200, or scene",
     .unit = "",
     .what = "another way to say solver=si@VELOCITY/POSITION",
     .flag = "--iterations",
     .needs = sequential,
     .isLive = true,
     .read = ReadIterations,
     .print = PrintNothing},
    {.name = "substeps",
     .values = "a whole number from 1 to 64",
     .unit = "",
     .what = "another way to say solver=soft@SUBSTEPS",
     .flag = "--substeps",
     .needs = softSteps,
     .isLive = true,
     .read = ReadSubsteps,
     .print = PrintNothing},
    {.name = "accuracy",
     .values = "draft, game, fine or precise",
     .unit = "",
     .what = "instead of a solver: a mark of the engine's accuracy dial",
     .flag = "--accuracy",
     .needs = dial,
     .isLive = true,
     .read = ReadAccuracy,
     .print = PrintAccuracy},
    {.name = "tolerance",
     .values =
         "OVERLAP, OVERLAP/GAP or OVERLAP/GAP/LEAST/MOST: overlap above 0.005 times the length scale, gap above 0, "
         "sub-steps from 1 to 64",
     .unit = "m",
     .what = "instead of a solver: errors that each island's number of sub-steps is to stay below; 0.01/0.001/4/32 are "
             "the engine's own",
     .flag = "--tolerance",
     .needs = dial,
     .isLive = true,
     .read = ReadTolerance,
     .print = PrintTolerance},
    {.name = "timeStep",
     .values = "a number from 0.0001 to 0.1, 1/N, or scene",
     .unit = "s",
     .what = "length of a step",
     .flag = "",
     .needs = 0,
     .isLive = true,
     .read = ReadTimeStep,
     .print = PrintTimeStep},
    {.name = "gravity",
     .values = "X/Y, finite numbers, or scene",
     .unit = "m/s²",
     .what = "gravity",
     .flag = "",
     .needs = 0,
     .isLive = true,
     .read = ReadGravity,
     .print = PrintGravity},
    {.name = "caps",
     .values = "on or off",
     .unit = "",
     .what = "a body moves by at most 2 m and turns by at most π/2 per step, as always in Box2D 2.4",
     .flag = "--caps",
     .needs = static_cast<unsigned>(Ability::freeSpeed),
     .isLive = false,
     .read = ReadSwitch<&RunSpec::caps>,
     .print = PrintSwitch<&RunSpec::caps>},
    {.name = "continuous",
     .values = "on or off",
     .unit = "",
     .what = "continuous collision: nothing passes through static fixtures between two steps",
     .flag = "--continuous",
     .needs = 0,
     .isLive = true,
     .read = ReadSwitch<&RunSpec::continuous>,
     .print = PrintSwitch<&RunSpec::continuous>},
    {.name = "sleeping",
     .values = "on or off",
     .unit = "",
     .what = "bodies at rest fall asleep",
     .flag = "",
     .needs = 0,
     .isLive = true,
     .read = ReadSwitch<&RunSpec::sleeping>,
     .print = PrintSwitch<&RunSpec::sleeping>},
    {.name = "warmStarting",
     .values = "on or off",
     .unit = "",
     .what = "a step begins with the impulses of the last one",
     .flag = "",
     .needs = 0,
     .isLive = true,
     .read = ReadSwitch<&RunSpec::warmStarting>,
     .print = PrintSwitch<&RunSpec::warmStarting>},
    {.name = "joints",
     .values = "direct or iterative",
     .unit = "",
     .what = "soft step: joints are solved directly where they can be, or all of them in turn",
     .flag = "",
     .needs = joints,
     .isLive = true,
     .read = ReadJoints,
     .print = [](const RunSpec& spec) { return std::string(spec.directJoints ? directJoints : iterativeJoints); }},
    {.name = "contactHertz",
     .values = "a number from 0.001 to 1e6, or own",
     .unit = "1/s",
     .what = "soft step: frequency of the springs of contacts; own is 30, and long sub-steps "
             "limit it",
     .flag = "",
     .needs = softTuning,
     .isLive = false,
     .read = ReadOwnOr<&RunSpec::contactHertz>,
     .print = PrintOwnOr<&RunSpec::contactHertz>},
    {.name = "contactDamping",
     .values = "a number from 0.001 to 1e6, or own",
     .unit = "",
     .what = "soft step: damping ratio of these springs; own is 10",
     .flag = "",
     .needs = softTuning,
     .isLive = false,
     .read = ReadOwnOr<&RunSpec::contactDamping>,
     .print = PrintOwnOr<&RunSpec::contactDamping>},
    {.name = "pushSpeed",
     .values = "a number from 0.001 to 1e6, or own",
     .unit = "m/s",
     .what = "soft step: largest speed at which contacts push overlapping bodies apart; own is 1 in scree, "
             "times the length scale, and 3 in box2d3",
     .flag = "",
     .needs = softTuning,
     .isLive = false,
     .read = ReadOwnOr<&RunSpec::pushSpeed>,
     .print = PrintOwnOr<&RunSpec::pushSpeed>},
    {.name = "lengthScale",
     .values = "a number from 1e-6 to 1e6",
     .unit = "m",
     .what = "size of a typical body: tolerances that are lengths are Box2D's times this",
     .flag = "",
     .needs = static_cast<unsigned>(Ability::lengthScales),
     .isLive = false,
     .read = [](std::string_view value, RunSpec& spec) { return ReadNumberInto(value, spec.lengthScale); },
     .print = [](const RunSpec& spec) { return fmt::format("{}", spec.lengthScale); }},
    {.name = "threads",
     .values = "a whole number from 1 to 64",
     .unit = "",
     .what = "threads that share a step; results do not depend on it",
     .flag = "--threads",
     .needs = static_cast<unsigned>(Ability::threads),
     .isLive = false,
     .read = [](std::string_view value, RunSpec& spec) { return ReadNumberInto(value, spec.threads); },
     .print = [](const RunSpec& spec) { return fmt::format("{}", spec.threads); }},
    {.name = "features",
     .values = "automatic, full, none, or names with +",
     .unit = "",
     .what = "what the world models; `scree requires` tells what a scene needs",
     .flag = "",
     .needs = static_cast<unsigned>(Ability::features),
     .isLive = false,
     .read = ReadFeatures,
     .print = [](const RunSpec& spec) { return spec.features; }},
    {.name = "broadPhase",
     .values = "auto, brute-force, sweep-and-prune, bvh-barycentre, bvh-sah, fat-tree, global-1, global-2, global-3, "
               "unified or keys",
     .unit = "",
     .what = "algorithm of the broad phase",
     .flag = "--broad-phase",
     .needs = static_cast<unsigned>(Ability::broadPhases),
     .isLive = false,
     .read = ReadBroadPhase,
     .print = [](const RunSpec& spec) { return spec.broadPhase; }},
};

constexpr Preset presets[] = {
    {.name = ownPreset, .what = "the engine's own defaults: what a program gets that sets nothing", .settings = ""},
    {.name = likeBox2dPreset,
     .what = "like for like: what all engines can do alike, as the published comparison has it",
     .settings = "caps=on continuous=off"},
};

std::vector<std::string_view> KeyNames() {
    std::vector<std::string_view> names;
    for (const SettingKey& key : settingKeys) names.push_back(key.name);
    return names;
}

/// KEY=VALUE for every key by which `spec` differs from `base`.
std::vector<std::string> ListDifferences(const RunSpec& spec, const RunSpec& base) {
    std::vector<std::string> list;
    for (const SettingKey& key : settingKeys) {
        const std::string value = key.print(spec);
        if (!value.empty() && value != key.print(base)) list.push_back(fmt::format("{}={}", key.name, value));
    }
    return list;
}

std::string FindSolverProblem(const RunSpec& spec) {
    const Abilities abilities = FindEngine(spec.engine).abilities;
    if (const auto* si = std::get_if<SequentialImpulses>(&spec.solver)) {
        if (!abilities.Has(Ability::sequential)) return fmt::format("{} has no sequential impulses", spec.engine);
        if (!si->iterations) return {};
        const auto [velocity, position] = *si->iterations;
        const bool isLegal =
            velocity >= 1 && velocity <= maxVelocityIterations && position >= 0 && position <= maxPositionIterations;
        return isLegal ? "" : "velocity iterations are legal from 1 to 200, position iterations from 0 to 200";
    }
    if (!abilities.Has(Ability::softSteps)) return fmt::format("{} has sequential impulses only", spec.engine);
    if (!std::holds_alternative<SoftStep>(spec.solver) && !abilities.Has(Ability::dial)) {
        return fmt::format("{} has no accuracy dial", spec.engine);
    }
    const auto isCount = [](int substeps) { return substeps >= 1 && substeps <= maxSubsteps; };
    if (const auto* step = std::get_if<SoftStep>(&spec.solver)) {
        return isCount(step->substeps) ? "" : "sub-steps are legal from 1 to 64";
    }
    if (const auto* t = std::get_if<Tolerance>(&spec.solver)) {
        const bool isLegal = std::isfinite(t->overlap) && t->overlap > 0 && std::isfinite(t->jointGap) &&
                             t->jointGap > 0 && isCount(t->leastSubsteps) && isCount(t->mostSubsteps) &&
                             t->leastSubsteps <= t->mostSubsteps;
        return isLegal ? "" : "tolerances are legal above 0, sub-steps from 1 to 64, the least not above the most";
    }
    return {};
}

/// Of each value by itself: settings are read one after the other.
std::string FindValueProblem(const RunSpec& spec) {
    if (const std::string problem = FindSolverProblem(spec); !problem.empty()) return problem;
    if (spec.timeStep && !(*spec.timeStep >= minTimeStep && *spec.timeStep <= maxTimeStep)) {
        return "the time step is legal from 0.0001 to 0.1 s";
    }
    if (spec.gravity && !(std::isfinite(spec.gravity->x) && std::isfinite(spec.gravity->y))) {
        return "gravity must be finite";
    }
    for (const std::optional<float>& tuning : {spec.contactHertz, spec.contactDamping, spec.pushSpeed}) {
        if (tuning && !(*tuning >= minSoftTuning && *tuning <= maxSoftTuning)) {
            return "frequency, damping ratio and push speed of soft contacts are legal from 0.001 to 1e6";
        }
    }
    if (!(spec.lengthScale >= minLengthScale && spec.lengthScale <= maxLengthScale)) {
        return "the length scale is legal from 1e-6 to 1e6 m";
    }
    if (spec.threads < 1 || spec.threads > maxThreads) return fmt::format("threads are legal from 1 to {}", maxThreads);
    RunSpec read = spec;
    if (const std::string problem = ReadBroadPhase(spec.broadPhase, read); !problem.empty()) return problem;
    return ReadFeatures(spec.features, read);
}

}  // namespace

bool IsSequential(const RunSpec& spec) {
    return std::holds_alternative<SequentialImpulses>(spec.solver) || spec.solver == Solver(Accuracy::draft);
}

std::span<const Preset> GetPresets() { return presets; }
std::span<const SettingKey> GetSettingKeys() { return settingKeys; }

RunSpec MakeSpec(std::string_view engine, std::string_view preset) {
    RunSpec spec{.engine = std::string(FindEngine(engine).name)};
    if (const std::string problem = ReadPreset(preset, spec); !problem.empty()) throw UsageError(problem);
    return spec;
}

const SettingKey& FindSettingKey(std::string_view name, std::string_view source) {
    const auto found = std::ranges::find(settingKeys, name, &SettingKey::name);
    if (found != std::end(settingKeys)) return *found;
    throw UsageError(fmt::format("{}: {}", source, DescribeUnknown("setting", name, KeyNames())));
}

bool HasSetting(std::string_view engine, const SettingKey& key) {
    if (engine == recordedEngine) return false;
    return (FindEngine(engine).abilities.bits & key.needs) == key.needs;
}

bool ApplySetting(RunSpec& spec, std::string_view setting, std::string_view source) {
    const std::size_t equals = setting.find('=');
    const SettingKey& key = FindSettingKey(setting.substr(0, equals), source);
    const std::string_view value = equals == std::string_view::npos ? "" : setting.substr(equals + 1);
    // Read for our engine, which has every setting: what is no value is one nowhere.
    RunSpec changed = spec;
    changed.engine = "scree";
    const std::string problem = key.read(value, changed);
    if (problem == NotAValue()) {
        throw UsageError(fmt::format("{}: {} takes {}", source, key.name, key.values));
    }
    if (!problem.empty()) throw UsageError(fmt::format("{}: {}", source, problem));
    if (const std::string illegal = FindValueProblem(changed); !illegal.empty()) {
        throw UsageError(fmt::format("{}: {}; {} takes {}", source, illegal, key.name, key.values));
    }
    if (!HasSetting(spec.engine, key)) return false;
    changed = spec;
    (void)key.read(value, changed);
    if (!FindSolverProblem(changed).empty()) return false;
    spec = changed;
    return true;
}

void ApplySettings(RunSpec& spec, std::string_view settings) {
    for (const std::string_view setting : Split(settings, ' ')) {
        if (!setting.empty()) (void)ApplySetting(spec, setting, setting);
    }
}

std::string PrintSettings(const RunSpec& spec) {
    std::vector<std::string> shortest = ListDifferences(spec, MakeSpec(spec.engine));
    for (const Preset& preset : presets) {
        if (preset.name == ownPreset) continue;
        std::vector<std::string> list = ListDifferences(spec, MakeSpec(spec.engine, preset.name));
        list.insert(list.begin(), fmt::format("preset={}", preset.name));
        if (list.size() <= shortest.size()) shortest = std::move(list);
    }
    return fmt::format("{}", fmt::join(shortest, " "));
}

std::string PrintSpec(const RunSpec& spec) {
    std::string text = spec.engine;
    const std::string settings = PrintSettings(spec);
    for (const std::string_view setting : Split(settings, ' ')) {
        if (!setting.empty()) text += fmt::format(":{}", setting);
    }
    return text;
}

std::string FindProblem(const RunSpec& spec) {
    if (const std::string problem = FindValueProblem(spec); !problem.empty()) return problem;
    const auto* tolerance = std::get_if<Tolerance>(&spec.solver);
    if (tolerance == nullptr || tolerance->overlap > scree::linearSlop * spec.lengthScale) return {};
    return fmt::format("a tolerance of overlap is legal above {} m times the length scale", scree::linearSlop);
}

RunSpec Resolve(const RunSpec& spec, const scenes::Scene& scene) {
    RunSpec resolved = spec;
    if (auto* si = std::get_if<SequentialImpulses>(&resolved.solver); si != nullptr && !si->iterations) {
        si->iterations = Iterations{scene.velocityIterations, scene.positionIterations};
    }
    if (!resolved.timeStep) resolved.timeStep = double{scene.timeStep};
    if (!resolved.gravity) resolved.gravity = scene.gravity;
    return resolved;
}

double GetTimeStep(const RunSpec& spec) { return spec.timeStep.value_or(1.0 / 60.0); }
int GetRate(const RunSpec& spec) { return static_cast<int>(std::lround(1.0 / GetTimeStep(spec))); }

std::string NameSolver(const RunSpec& spec) {
    if (const auto* si = std::get_if<SequentialImpulses>(&spec.solver)) {
        return si->iterations ? fmt::format("{}/{}", si->iterations->velocity, si->iterations->position) : "si";
    }
    if (const auto* step = std::get_if<SoftStep>(&spec.solver)) return fmt::format("soft {}", step->substeps);
    if (std::holds_alternative<Tolerance>(spec.solver)) return "tolerance " + PrintTolerance(spec);
    return PrintAccuracy(spec);
}

std::string DescribeSettingKeys() {
    std::string text;
    for (const SettingKey& key : settingKeys) text += fmt::format("  {}: {}; {}\n", key.name, key.values, key.what);
    return text;
}

std::string WriteSettingTable() {
    std::string text = "| key | takes | unit | default | engines | what |\n|---|---|---|---|---|---|\n";
    for (const SettingKey& key : settingKeys) {
        std::vector<std::string_view> engines;
        for (const EngineInfo& engine : GetKnownEngines()) {
            if (HasSetting(engine.name, key)) engines.push_back(engine.name);
        }
        const std::string usual = key.name == "preset" ? std::string(ownPreset) : key.print(MakeSpec("scree"));
        text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", key.name, key.values, key.unit, usual,
                            fmt::join(engines, ", "), key.what);
    }
    return text;
}

}  // namespace testbed
