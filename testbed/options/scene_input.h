// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The scene that a command was given: a name of the catalogue, or a file. All commands that take SCENE take both by
// this, so that what they do with it is the same.

#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/engines/engine_run.h"
#include "testbed/input/file_kind.h"

namespace testbed {

/// How SCENE is to be read, as typed.
struct InputArguments {
    std::string format;         ///< empty: the ending decides
    std::optional<int> from;    ///< step at which engines start in what was recorded
    bool hasFrom = false;       ///< the command has --from
    std::string poses = "own";  ///< own, track or an engine's name; empty: track where a motion is not started from
};
/// --format.
void AddFormatOption(CLI::App& app, InputArguments& arguments);
/// --format and --from.
void AddInputOptions(CLI::App& app, InputArguments& arguments);
/// --poses, for commands that can show a motion as it was recorded.
void AddPosesOption(CLI::App& app, InputArguments& arguments);
/// What --help says about SCENE: "Scenes" or "A scene", and what else may be given.
[[nodiscard]] std::string DescribeSceneArgument(std::string_view first);

/// A scene to run, checked: what is known of it before it is built.
struct SceneInput {
    std::string name;  ///< of folders, rows and pictures
    int size = 0;
    int steps = 0;                                ///< of a full run; of a motion: its last
    int showStep = 0;                             ///< the step whose picture tells most
    const scenes::SceneInfo* info = nullptr;      ///< null: it is from a file
    std::shared_ptr<const scenes::Scene> file{};  ///< null: it is of the catalogue
    std::shared_ptr<const SavedWorld> world{};    ///< of our engine, of the same moment; null: none
    std::shared_ptr<TrackFile> motion{};          ///< trees are to follow it; null: engines simulate
    int firstStep = 0;                            ///< of the motion

    /// The scene alone, as any engine runs it.
    [[nodiscard]] scenes::Scene Build() const;
    /// With the exact world or the motion.
    [[nodiscard]] RunStart Start() const;
    /// Whether a run from Start can come to that step.
    [[nodiscard]] bool HasStep(int step) const { return motion == nullptr || (step > firstStep && step <= steps); }
};

/// A scene of the catalogue, whose size is legal.
[[nodiscard]] SceneInput MakeInput(const scenes::SceneInfo& info, int size);

/// The scene of that name or in that file. A file that is damaged behind what can be read gives that and a notice on
/// stderr. Throws UsageError with the nearest name, the legal sizes or the kinds of files that there are; FileError for
/// a file that cannot be read.
[[nodiscard]] SceneInput ChooseScene(const std::string& given, std::optional<int> size,
                                     const InputArguments& arguments);

/// The same of several, each once. Throws UsageError also for different ones of the same name, since their files would
/// be the same.
[[nodiscard]] std::vector<SceneInput> ChooseScenes(const std::vector<std::string>& given, std::optional<int> size,
                                                   const InputArguments& arguments);

/// A file that is there, whole.
struct InputFile {
    FileKind kind = FileKind::scene;
    std::string path{}, bytes{};
};
/// Reads a file; its kind is that of --format, else of its ending. Throws FileError if it cannot be read or begins like
/// another kind, UsageError with the kinds that there are.
[[nodiscard]] InputFile ReadInputFile(const std::string& path, const InputArguments& arguments);

}  // namespace testbed
