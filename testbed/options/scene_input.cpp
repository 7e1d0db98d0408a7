// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scene_input.h.

#include "testbed/options/scene_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/input/file_kind.h"
#include "testbed/input/scene_file.h"

namespace testbed {

namespace {

namespace fs = std::filesystem;

const scenes::SceneInfo& FindScene(const std::string& name) {
    if (const scenes::SceneInfo* info = scenes::Find(name)) return *info;
    if (fs::exists(name)) {
        throw UsageError(
            fmt::format("{}: its ending is of no kind of file that can be read; there are {}; --format says what it is",
                        name, DescribeFileKinds()));
    }
    const std::vector<std::string_view> nearest = scenes::NearestNames(name, 3);
    throw UsageError(fmt::format("unknown scene '{}'; did you mean '{}'? `scree list` shows all; files are {}", name,
                                 fmt::join(nearest, "', '"), DescribeFileKinds()));
}

int CheckedSize(const scenes::SceneInfo& info, std::optional<int> size) {
    if (!size) return info.defaultSize;
    if (*size >= info.minSize && *size <= info.maxSize) return *size;
    if (info.minSize == info.maxSize) {
        throw UsageError(fmt::format("--size {}: the only size of scene '{}' is {}", *size, info.name, info.minSize));
    }
    throw UsageError(fmt::format("--size {}: sizes of scene '{}' are legal from {} to {}", *size, info.name,
                                 info.minSize, info.maxSize));
}

FileKind FindKind(const std::string& path, const InputArguments& arguments) {
    if (!arguments.format.empty()) return ParseFileKind(arguments.format);
    if (const std::optional<FileKind> kind = KindOfEnding(path)) return *kind;
    throw UsageError(
        fmt::format("{}: its ending is of no kind of file that can be read; there are {}; --format says what it is",
                    path, DescribeFileKinds()));
}

SceneInput ReadInput(const std::string& path, const InputArguments& arguments) {
    if (!fs::exists(path)) throw FileError(fmt::format("{}: no such file", path));
    scenes::Scene scene;
    switch (FindKind(path, arguments)) {
        case FileKind::scene:
            scene = ReadSceneFile(path);
    }
    SceneInput input{scene.name, scene.size, scene.steps, scene.showStep};
    input.file = std::make_shared<const scenes::Scene>(std::move(scene));
    return input;
}

bool IsFile(const std::string& given, const InputArguments& arguments) {
    return !arguments.format.empty() || LooksLikeFile(given);
}

}  // namespace

void AddInputOptions(CLI::App& app, InputArguments& arguments) {
    std::string names;
    for (const FileKindInfo& kind : FileKinds()) names += (names.empty() ? "" : ", ") + std::string(kind.name);
    app.add_option("--format", arguments.format, "SCENE is a file of this kind, whatever its ending is: " + names)
        ->type_name("KIND");
}

std::string DescribeSceneArgument(std::string_view first) {
    return fmt::format("{}: a name that `scree list` shows, or a file: {}", first, DescribeFileKinds());
}

scenes::Scene SceneInput::Build() const { return file != nullptr ? *file : scenes::Build(info->name, size); }

SceneInput MakeInput(const scenes::SceneInfo& info, int size) {
    return {std::string(info.name), size, info.steps, info.showStep, &info};
}

SceneInput ChooseScene(const std::string& given, std::optional<int> size, const InputArguments& arguments) {
    if (!IsFile(given, arguments)) {
        const scenes::SceneInfo& info = FindScene(given);
        return MakeInput(info, CheckedSize(info, size));
    }
    if (size) {
        throw UsageError(
            fmt::format("--size {}: a file has its own size; sizes are for scenes that `scree list` shows", *size));
    }
    return ReadInput(given, arguments);
}

std::vector<SceneInput> ChooseScenes(const std::vector<std::string>& given, std::optional<int> size,
                                     const InputArguments& arguments) {
    std::vector<SceneInput> chosen;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto end = given.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(given.begin(), end, given[i]) != end) continue;
        SceneInput input = ChooseScene(given[i], size, arguments);
        if (std::ranges::find(chosen, input.name, &SceneInput::name) != chosen.end()) {
            throw UsageError(
                fmt::format("{}: another scene given here is called '{}' too, and their files would be "
                            "the same; give it another \"name\"",
                            given[i], input.name));
        }
        chosen.push_back(std::move(input));
    }
    return chosen;
}

}  // namespace testbed
