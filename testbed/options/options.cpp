// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Text from the command line in, checked values out.

#include "testbed/options/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

#include "testbed/base/nearest.h"
#include "testbed/base/standard_error.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/saved_world.h"
#include "testbed/input/track_file.h"

namespace testbed {

namespace {

constexpr std::array<std::string_view, 4> styleNames = {"alpha", "heat", "bands", "log"};
constexpr std::array<std::string_view, 2> themeNames = {"dark", "light"};
constexpr std::array<std::string_view, 4> backendNames = {"auto", "osmesa", "egl", "cpu"};

void CheckKnown(std::string_view what, std::string_view word, std::span<const std::string_view> names) {
    if (std::find(names.begin(), names.end(), word) == names.end()) {
        throw UsageError(DescribeUnknown(what, word, names));
    }
}

/// An engine that is not shown but moves what is.
RunSpec MakeSource(std::string_view engine, std::span<const TypedSetting> typed, std::string_view base) {
    RunSpec spec = MakeSpec(engine);
    ApplySettings(spec, base);
    for (const TypedSetting& one : typed) (void)ApplySetting(spec, one.setting, one.source);
    return spec;
}

}  // namespace

std::vector<int> ParseIntList(std::string_view option, std::string_view text, std::string_view takes) {
    std::vector<int> numbers;
    for (const std::string_view part : Split(text, ',')) {
        const Parsed<int> number = ParseNumber<int>(part);
        if (!number) throw UsageError(fmt::format("{} {}: {}; give {}", option, text, number.problem, takes));
        numbers.push_back(*number);
    }
    return numbers;
}

std::pair<int, int> ParseSize(std::string_view option, std::string_view text) {
    const std::vector<std::string_view> parts = Split(text, 'x');
    const Parsed<int> width = ParseNumber<int>(parts.front()), height = ParseNumber<int>(parts.back());
    if (parts.size() != 2 || !width || !height) {
        throw UsageError(fmt::format("{} {}: {}give width and height in pixels, for example 1920x1080", option, text,
                                     BeforeCure(!width ? width.problem : height.problem)));
    }
    return {*width, *height};
}

StepRange ParseSteps(std::string_view text, bool countAllowed) {
    std::vector<int> numbers;
    std::string problem;
    for (const std::string_view part : Split(text, ':')) {
        const Parsed<int> number = ParseNumber<int>(part);
        if (problem.empty()) problem = number.problem;
        numbers.push_back(*number);
    }
    const bool isCount = numbers.size() == 1;
    if (!problem.empty() || numbers.size() > 3 || (isCount && !countAllowed)) {
        throw UsageError(fmt::format("--steps {}: {}give {}first:last or first:last:stride, for example 10:100:10{}",
                                     text, BeforeCure(problem), countAllowed ? "a number of steps, or " : "",
                                     countAllowed ? "" : "; one step is --step N"));
    }
    StepRange range;
    range.first = isCount ? 1 : numbers[0];
    range.last = isCount ? numbers[0] : numbers[1];
    range.stride = numbers.size() == 3 ? numbers[2] : 1;
    if (range.first < 1 || range.last < range.first || range.last > maxStep) {
        throw UsageError(
            fmt::format("--steps {}: steps are legal from 1 to {}, the first not after the last", text, maxStep));
    }
    if (range.stride < 1) throw UsageError(fmt::format("--steps {}: the stride must be at least 1", text));
    return range;
}

namespace {

CLI::Validator CheckNumber(const char* name, const char* takes, bool (*isLegal)(double)) {
    return {[takes, isLegal](const std::string& text) {
                const Parsed<double> number = ParseNumber<double>(text);
                if (number && isLegal(*number)) return std::string();
                return fmt::format("{}give {}", BeforeCure(number.problem), takes);
            },
            name};
}

}  // namespace

CLI::Validator AboveZero() {
    return CheckNumber("POSITIVE", "a number above 0", [](double value) { return value > 0.0; });
}

CLI::Validator ZeroOrAbove() {
    return CheckNumber("NONNEGATIVE", "0 or a number above it", [](double value) { return value >= 0.0; });
}

void AddSetOption(CLI::App& app, SettingArguments& arguments, const std::string& note) {
    app.add_option_function<std::string>(
           "--set",
           [&arguments](const std::string& set) {
               arguments.typed.push_back({set, "--set " + set});
           },
           "A setting of how scenes are run, in every engine that has it; repeatable, the last one counts. A comma may "
           "stand for a slash between numbers. " +
               note + (note.empty() ? "" : ". ") + "Keys:\n" + DescribeSettingKeys())
        ->type_name("KEY=VALUE")
        ->trigger_on_parse();
    AddSettingFlags(app, arguments, {"iterations", "substeps", "accuracy", "tolerance"});
}

void AddEnginesOption(CLI::App& app, SettingArguments& arguments, const std::string& note) {
    CLI::Option* option =
        app.add_option("--engines", arguments.engines,
                       "Engines to run, with commas: [NAME=]ENGINE[:KEY=VALUE]..., keys as for --set, for example "
                       "scree,scree:solver=soft@8:threads=2,box2d" +
                           (note.empty() ? "" : ". " + note));
    option->type_name("LIST")->each([&arguments](const std::string&) { arguments.hasEngines = true; });
    if (!arguments.engines.empty()) option->capture_default_str();
}

void AddSettingFlags(CLI::App& app, SettingArguments& arguments, std::initializer_list<std::string_view> keys) {
    for (const std::string_view name : keys) {
        const SettingKey& key = FindSettingKey(name);
        const std::string flag(key.flag);
        const std::string what = fmt::format("The same as --set {}=..: {}; {}", key.name, key.values, key.what);
        if (key.print(RunSpec{}) == "on" || key.print(RunSpec{}) == "off") {
            app.add_flag_callback(
                   flag,
                   [&arguments, &key, flag] {
                       arguments.typed.push_back({fmt::format("{}=on", key.name), flag});
                   },
                   fmt::format("The same as --set {}=on: {}", key.name, key.what))
                ->trigger_on_parse();
            continue;
        }
        app.add_option_function<std::string>(
               flag,
               [&arguments, &key, flag](const std::string& value) {
                   arguments.typed.push_back({fmt::format("{}={}", key.name, value), flag + " " + value});
               },
               what)
            ->trigger_on_parse();
    }
}

void AddMarkdownOption(CLI::App& app, std::string& file) {
    app.add_option("--markdown", file, "Also write the report's text and tables as Markdown")->type_name("FILE");
}

void AddRunOptions(CLI::App& app, SceneArguments& arguments) {
    app.add_option("--size", arguments.size, "Size of a scene that `scree list` shows; its default if not given");
    AddInputOptions(app, arguments.input);
    AddEnginesOption(app, arguments.settings, "");
    app.add_option("--baseline", arguments.settings.baseline,
                   "Name of the pane that the others are compared with; box2d's, else the first one, if not given")
        ->type_name("NAME");
    AddSetOption(app, arguments.settings, comparisonNote);
    AddSettingFlags(app, arguments.settings, {"broadPhase", "threads"});
    AddPosesOption(app, arguments.input);
    app.add_option("-o,--output", arguments.output, "Folder for the files")->capture_default_str()->type_name("DIR");
}

std::string FindPoses(const SceneArguments& arguments, const SceneInput& input) {
    if (input.motion != nullptr) return "track";
    return arguments.input.poses.empty() ? "own" : arguments.input.poses;
}

std::string EnginesOf(const TrackFile& motion) {
    const TrackInfo& info = motion.GetInfo();
    if (!info.hasNodes) return SettingArguments().engines;
    return info.engine == "scree" ? "recorded,box2d" : "scree,recorded";
}

Panes MakePanes(const SceneArguments& arguments, const SceneInput& input) {
    const std::vector<TypedSetting>& typed = arguments.settings.typed;
    const std::string_view base = input.world != nullptr ? std::string_view(input.world->settings) : comparisonBase;
    const bool isUsual = input.motion != nullptr && !arguments.settings.hasEngines;
    Panes panes{.panes = ParsePanes(isUsual ? EnginesOf(*input.motion) : arguments.settings.engines, typed, base)};
    panes.baseline = FindBaseline(panes.panes, arguments.settings.baseline);
    const std::string poses = FindPoses(arguments, input);
    if (poses == "own" || poses == "track") return panes;
    const auto shown = std::ranges::find_if(panes.panes, [&](const Pane& pane) { return pane.spec.engine == poses; });
    panes.source = shown != panes.panes.end() ? shown->spec : MakeSource(poses, typed, base);
    return panes;
}

void AddCountOptions(CLI::App& app, PictureArguments& arguments) {
    app.add_option("--nodes", arguments.nodes, "Tree nodes to count: internal, leaves, all, level=K or levels=A..B")
        ->capture_default_str();
    app.add_option("--query-size", arguments.querySize,
                   "Grow every node by half of this on each side, m: a pixel then counts the nodes that a query of "
                   "this size, centred there, visits")
        ->capture_default_str();
    app.add_option("--image", arguments.image, "Width x height of a picture, pixels")->capture_default_str();
    app.add_option("--camera", arguments.camera,
                   "fit, or X,Y,M: the world point in the middle and the metres across the picture")
        ->capture_default_str();
}

void AddLookOptions(CLI::App& app, PictureArguments& arguments) {
    app.add_option("--style", arguments.style, "Colours of the counts: alpha, heat, bands or log")
        ->capture_default_str();
    app.add_option("--theme", arguments.theme, "Colours for a dark or a light background: dark or light")
        ->capture_default_str();
    app.add_option(
           "--opacity", arguments.opacity,
           "Opacity of one layer in the style alpha, above 0, at most 1; auto: 0.04, or less where counts above 95 "
           "would become one colour")
        ->type_name("NUMBER")
        ->capture_default_str();
    app.add_option("--scale-max", arguments.scaleMax, "Count at the end of the colour scale: auto or a number")
        ->capture_default_str();
    app.add_option(
           "--backend", arguments.backend,
           "What makes the pixels, the same ones in every case: cpu (built in and fastest where OpenGL is software), "
           "auto (OSMesa, else EGL), osmesa or egl")
        ->capture_default_str();
    app.add_flag("--skip-missing-backend", arguments.skipMissingBackend,
                 "Exit with 77 instead of 3 when the backend is missing");
}

PictureOptions MakePictureOptions(const PictureArguments& arguments) {
    PictureOptions options;
    CheckKnown("style", arguments.style, styleNames);
    std::tie(options.width, options.height) = ParseSize("--image", arguments.image);
    CheckKnown("theme", arguments.theme, themeNames);
    options.nodes = ParseNodeSelection(arguments.nodes);
    options.style = ParseStyle(arguments.style);
    options.theme = ParseTheme(arguments.theme);
    if (arguments.opacity != "auto") {
        const Parsed<double> opacity = ParseNumber<double>(arguments.opacity);
        if (!opacity) {
            throw UsageError(fmt::format("--opacity {}: {}give auto or a number above 0, at most 1", arguments.opacity,
                                         BeforeCure(opacity.problem)));
        }
        options.opacity = *opacity;
    }
    options.querySize = arguments.querySize;
    options.camera = ParseCamera(arguments.camera);
    if (arguments.scaleMax != "auto") {
        const Parsed<int> count = ParseNumber<int>(arguments.scaleMax);
        if (!count || *count < 1) {
            throw UsageError(fmt::format("--scale-max {}: {}give auto or a whole number of at least 1",
                                         arguments.scaleMax, BeforeCure(count.problem)));
        }
        options.scaleMax = static_cast<uint32_t>(*count);
    }
    CheckOptions(options);
    return options;
}

Backend CheckedBackend(const PictureArguments& arguments) {
    CheckKnown("backend", arguments.backend, backendNames);
    return ParseBackend(arguments.backend);
}

int SkipMissingBackend(const PictureArguments& arguments, const std::function<int()>& action) {
    try {
        return action();
    } catch (const BackendError& error) {
        if (!arguments.skipMissingBackend) throw;
        PrintError("scree: skipped: {}\n", error.what());
        return exitSkipped;
    }
}

void AddStepOptions(CLI::App& app, StepArguments& arguments) {
    CLI::Option* step =
        app.add_option("--step", arguments.step, "The step to show; the scene's own choice if not given");
    CLI::Option* steps = app.add_option("--steps", arguments.steps, "Steps to show: first:last or first:last:stride")
                             ->type_name("A:B:S");
    CLI::Option* worst = app.add_option("--worst", arguments.worst,
                                        "Show only the K worst of the steps (of --steps, else of a full run)")
                             ->type_name("K");
    CLI::Option* worstBy = app.add_option("--worst-by", arguments.worstBy,
                                          "What makes a step a worst one, in any engine: time (of the broad phase) or "
                                          "overlap (of siblings in the tree)")
                               ->capture_default_str();
    step->excludes(steps)->excludes(worst);
    worstBy->needs(worst);
}

std::string DescribeCommand(const std::vector<std::string>& arguments) {
    std::string text = "scree";
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        const bool isOutput = argument == "-o" || argument == "--output";
        if (isOutput) ++i;  // its value is the next one
        if (isOutput || argument.starts_with("--output=") || (argument.starts_with("-o") && argument.size() > 2)) {
            continue;
        }
        text += " " + QuoteForShell(argument);
    }
    return text;
}

}  // namespace testbed
