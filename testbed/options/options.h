// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Command-line options that several subcommands share: text from the command line in, checked values out. Whatever
// cannot be meant throws UsageError (or std::invalid_argument, std::out_of_range), which end in exit code 2.

#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/engines/panes.h"
#include "testbed/engines/side_by_side.h"
#include "testbed/options/scene_input.h"
#include "testbed/view/picture.h"

namespace testbed {

/// Steps first, first + stride, … last.
struct StepRange {
    int first = 1, last = 1, stride = 1;

    [[nodiscard]] bool Contains(int step) const {
        return step >= first && step <= last && (step - first) % stride == 0;
    }
    [[nodiscard]] int Count() const { return (last - first) / stride + 1; }
};

/// Steps beyond this are refused: at 1/60 s they are four and a half hours of simulated time.
inline constexpr int maxStep = 1'000'000;

/// "A:B" or "A:B:S" with 1 ≤ A ≤ B ≤ maxStep and S ≥ 1; when `countAllowed`, also "N" for 1:N. Throws UsageError.
[[nodiscard]] StepRange ParseSteps(std::string_view text, bool countAllowed);

/// Whole numbers with commas. Throws UsageError that names the option and says what it takes.
[[nodiscard]] std::vector<int> ParseIntList(std::string_view option, std::string_view text, std::string_view takes);

/// "1920x1080" of an option; UsageError naming the option for anything else.
[[nodiscard]] std::pair<int, int> ParseSize(std::string_view option, std::string_view text);

/// How scenes are run, as typed.
struct SettingArguments {
    std::string engines = "scree,box2d";
    bool hasEngines = false;  ///< typed
    std::string baseline{};
    std::vector<TypedSetting> typed{};  ///< of --set and of the options of single keys, in the order typed
};
/// Checks of options: a finite number above 0, or one of 0 or above.
[[nodiscard]] CLI::Validator AboveZero();
[[nodiscard]] CLI::Validator ZeroOrAbove();

/// --set, repeatable, and the options that are the same in every command that has it: --iterations, --substeps,
/// --accuracy and --tolerance. `note` says what is special to the command. DescribeSettingKeys stands in the help.
void AddSetOption(CLI::App& app, SettingArguments& arguments, const std::string& note = "");
/// --engines.
void AddEnginesOption(CLI::App& app, SettingArguments& arguments, const std::string& note);
/// The option of each of these keys: another spelling of --set.
void AddSettingFlags(CLI::App& app, SettingArguments& arguments, std::initializer_list<std::string_view> keys);
/// What --help says about comparisonBase.
inline constexpr const char* comparisonNote =
    "Runs begin with preset=like-box2d, so that all engines do the same: Box2D's caps of speed, no continuous "
    "collision; --set preset=own is what a program gets";

/// What scenes are run in, as typed.
struct SceneArguments {
    std::optional<int> size;
    InputArguments input;
    SettingArguments settings;
    std::string output = "out";
};
void AddRunOptions(CLI::App& app, SceneArguments& arguments);
/// --markdown: where the tables go as a page of text.
void AddMarkdownOption(CLI::App& app, std::string& file);
/// What follows a motion if nothing else is said: our engine and Box2D, the recorded tree in place of its engine's own
/// where there is one.
[[nodiscard]] std::string EnginesOf(const TrackFile& motion);
/// What runs beside each other from an input.
[[nodiscard]] Panes MakePanes(const SceneArguments& arguments, const SceneInput& input);
/// own, track or an engine's name: whose motion the trees follow.
[[nodiscard]] std::string FindPoses(const SceneArguments& arguments, const SceneInput& input);

/// How pictures look, as typed.
struct PictureArguments {
    std::string nodes = "internal";
    std::string style = "alpha";
    std::string theme = "dark";
    std::string opacity = "auto";
    std::string scaleMax = "auto";
    double querySize = 0;
    std::string image = "1920x1080";
    std::string camera = "fit";
    std::string backend = "cpu";
    bool skipMissingBackend = false;
};
/// The options that decide what is counted and from where; `metrics` needs no others.
void AddCountOptions(CLI::App& app, PictureArguments& arguments);
/// The options that decide how it looks and who draws it.
void AddLookOptions(CLI::App& app, PictureArguments& arguments);
[[nodiscard]] PictureOptions MakePictureOptions(const PictureArguments& arguments);
[[nodiscard]] Backend CheckedBackend(const PictureArguments& arguments);

/// Runs `action`; with --skip-missing-backend a BackendError becomes a line on stderr and exit code 77.
[[nodiscard]] int SkipMissingBackend(const PictureArguments& arguments, const std::function<int()>& action);

/// Which steps to show, as typed.
struct StepArguments {
    std::optional<int> step;
    std::string steps;
    std::optional<int> worst;
    std::string worstBy = "time";
};
void AddStepOptions(CLI::App& app, StepArguments& arguments);

/// The command line without program folder and -o DIR, for files that must not tell where they were made.
[[nodiscard]] std::string DescribeCommand(const std::vector<std::string>& arguments);

}  // namespace testbed
