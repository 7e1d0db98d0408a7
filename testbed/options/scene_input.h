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

namespace testbed {

/// How SCENE is to be read, as typed.
struct InputArguments {
    std::string format;  ///< empty: the ending decides
};
/// --format.
void AddInputOptions(CLI::App& app, InputArguments& arguments);
/// What --help says about SCENE: "Scenes" or "A scene", and what else may be given.
[[nodiscard]] std::string DescribeSceneArgument(std::string_view first);

/// A scene to run, checked: what is known of it before it is built.
struct SceneInput {
    std::string name;  ///< of folders, rows and pictures
    int size = 0;
    int steps = 0;                                ///< of a full run
    int showStep = 0;                             ///< the step whose picture tells most
    const scenes::SceneInfo* info = nullptr;      ///< null: it is from a file
    std::shared_ptr<const scenes::Scene> file{};  ///< null: it is of the catalogue

    [[nodiscard]] scenes::Scene Build() const;
};

/// A scene of the catalogue, whose size is legal.
[[nodiscard]] SceneInput MakeInput(const scenes::SceneInfo& info, int size);

/// The scene of that name or in that file. Throws UsageError with the nearest name, the legal sizes or the kinds of
/// files that there are; FileError for a file that cannot be read.
[[nodiscard]] SceneInput ChooseScene(const std::string& given, std::optional<int> size,
                                     const InputArguments& arguments);

/// The same of several, each once. Throws UsageError also for different ones of the same name, since their files would
/// be the same.
[[nodiscard]] std::vector<SceneInput> ChooseScenes(const std::vector<std::string>& given, std::optional<int> size,
                                                   const InputArguments& arguments);

}  // namespace testbed
