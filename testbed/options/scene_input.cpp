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
#include "testbed/base/input.h"
#include "testbed/base/nearest.h"
#include "testbed/base/standard_error.h"
#include "testbed/engines/engine_list.h"
#include "testbed/engines/saved_world.h"
#include "testbed/engines/track_run.h"
#include "testbed/input/rube_file.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"

namespace testbed {

namespace {

namespace fs = std::filesystem;

UsageError UnknownEnding(const std::string& path) {
    return UsageError(
        fmt::format("{}: its ending is of no kind of file that can be read; there are {}; `scree info` says what it "
                    "holds, --format KIND reads it as that",
                    path, DescribeFileKinds()));
}

const scenes::SceneInfo& FindScene(const std::string& name) {
    if (const scenes::SceneInfo* info = scenes::Find(name)) return *info;
    if (fs::exists(name)) throw UnknownEnding(name);
    const std::vector<std::string_view> nearest = scenes::NearestNames(name, 3);
    const std::string suggestion =
        nearest.empty() ? "" : fmt::format("did you mean '{}'? ", fmt::join(nearest, "', '"));
    throw UsageError(fmt::format("unknown scene '{}'; {}`scree list` shows all; files are {}", name, suggestion,
                                 DescribeFileKinds()));
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

void Notice(const std::string& path, const std::string& damage) {
    if (!damage.empty()) PrintError("scree: {} {}\n", path, damage);
}

std::string StemOf(const std::string& path) {
    const std::string file = fs::path(path).filename().string();
    const std::optional<FileKind> kind = KindOfEnding(file);
    return kind ? file.substr(0, file.size() - GetInfo(*kind).ending.size()) : file;
}

SceneInput InputOf(scenes::Scene scene) {
    SceneInput input{scene.name, scene.size, scene.steps, scene.showStep};
    input.file = std::make_shared<const scenes::Scene>(std::move(scene));
    return input;
}

SceneInput InputOf(SavedWorld world, const std::string& path) {
    world.scene.name = StemOf(path);
    SceneInput input = InputOf(world.scene);
    input.world = std::make_shared<const SavedWorld>(std::move(world));
    return input;
}

SceneInput InputOfMotion(std::shared_ptr<TrackFile> motion, const std::string& path, const InputArguments& arguments) {
    const int first = FirstStepOf(*motion), last = motion->GetLastStep();
    const int from = arguments.from.value_or(first);
    (void)motion->Read(from);  // or it throws
    if (from >= last) {
        throw UsageError(fmt::format("{} has no step after {}: there is no motion to follow", path, from));
    }
    const scenes::Scene& parts = motion->GetParts();
    SceneInput input{StemOf(path), parts.size, last, last};
    input.motion = std::move(motion);
    input.firstStep = from;
    return input;
}

bool WantsMotion(const std::string& path, const InputArguments& arguments) {
    if (arguments.poses == "track" || (arguments.poses.empty() && !arguments.from)) return true;
    if (arguments.from) return false;
    if (arguments.hasFrom) {
        throw UsageError(fmt::format("{} is a motion: --from K says at which of its steps engines start", path));
    }
    throw UsageError(
        fmt::format("{0} is a motion: `scree convert {0} OUT.scene.json --from K` makes a scene of its step K", path));
}

SceneInput InputOfTrack(InputFile file, const InputArguments& arguments) {
    auto track = std::make_shared<TrackFile>(std::move(file.bytes), file.path);
    Notice(file.path, track->GetInfo().damage);
    if (WantsMotion(file.path, arguments)) return InputOfMotion(std::move(track), file.path, arguments);
    scenes::Scene scene = track->SceneAt(*arguments.from);
    scene.name = StemOf(file.path);
    return InputOf(std::move(scene));
}

SceneInput InputOfRecording(const InputFile& file, const InputArguments& arguments) {
    const bool wantsMotion = WantsMotion(file.path, arguments);
    ReplayRequest request{.wantsTrack = wantsMotion};
    if (!wantsMotion) request.worldAt = arguments.from;
    Replayed replayed = ReplayRecording(file.bytes, file.path, request);
    Notice(file.path, replayed.damage);
    if (!wantsMotion) return InputOf(std::move(*replayed.world), file.path);
    return InputOfMotion(std::make_shared<TrackFile>(std::move(replayed.track), file.path), file.path, arguments);
}

void RefuseMotion(const std::string& what, const InputArguments& arguments) {
    constexpr const char* cure = "give a *.track or a *.recording";
    if (arguments.from) throw UsageError(fmt::format("--from {}: {} is one moment; {}", *arguments.from, what, cure));
    if (arguments.poses == "track") throw UsageError(fmt::format("--poses track: {} has no motion; {}", what, cure));
}

SceneInput ReadInput(const std::string& path, const InputArguments& arguments) {
    InputFile file = ReadInputFile(path, arguments);
    if (file.kind == FileKind::track) return InputOfTrack(std::move(file), arguments);
    if (file.kind == FileKind::recording) return InputOfRecording(file, arguments);
    RefuseMotion(path, arguments);
    if (file.kind == FileKind::image) return InputOf(ReadWorldImage(file.bytes, path), path);
    if (file.kind == FileKind::rube) {
        RubeWorld world = ReadRube(file.bytes, path);
        for (const std::string& notice : world.notices) PrintError("scree: {}: {}\n", path, notice);
        return InputOf(std::move(world.scene));
    }
    return InputOf(ReadScene(file.bytes, path));
}

void CheckPoses(const InputArguments& arguments) {
    std::vector<std::string_view> names{"own", "track"};
    for (const EngineInfo& engine : GetEngines()) names.push_back(engine.name);
    if (arguments.poses.empty() || std::ranges::find(names, arguments.poses) != names.end()) return;
    throw UsageError(DescribeUnknown("kind of poses", arguments.poses, names));
}

bool IsFile(const std::string& given, const InputArguments& arguments) {
    return !arguments.format.empty() || LooksLikeFile(given);
}

}  // namespace

void AddFormatOption(CLI::App& app, InputArguments& arguments) {
    std::string names;
    for (const FileKindInfo& kind : FileKinds()) names += (names.empty() ? "" : ", ") + std::string(kind.name);
    app.add_option("--format", arguments.format, "Kind of the file, where its ending does not tell: " + names)
        ->type_name("KIND");
}

void AddInputOptions(CLI::App& app, InputArguments& arguments) {
    AddFormatOption(app, arguments);
    arguments.hasFrom = true;
    app.add_option(
           "--from", arguments.from,
           "Start engines in the world of this step of a track or a recording; 0: in the world that it began with")
        ->type_name("K");
}

void AddPosesOption(CLI::App& app, InputArguments& arguments) {
    arguments.poses.clear();
    app.add_option("--poses", arguments.poses,
                   "Motion that drives the trees: own (every engine simulates for itself), scree, box2d or another "
                   "engine (one motion drives all, so that pictures differ by the tree alone), or track (the recorded "
                   "one drives all); own if not given, track for a track or a recording without --from")
        ->type_name("KIND");
}

std::string DescribeSceneArgument(std::string_view first) {
    return fmt::format("{}: a name that `scree list` shows, or a file: {}", first, DescribeFileKinds());
}

scenes::Scene SceneInput::Build() const { return file != nullptr ? *file : scenes::Build(info->name, size); }

RunStart SceneInput::Start() const {
    if (motion == nullptr) {
        RunStart start(Build());
        start.world = world;
        return start;
    }
    RunStart start(motion->GetParts());
    start.motion = motion;
    start.step = firstStep;
    return start;
}

InputFile ReadInputFile(const std::string& path, const InputArguments& arguments) {
    if (!fs::exists(path)) throw FileError(fmt::format("{}: there is no such file; check its path", path));
    InputFile file{.path = path};
    if (!arguments.format.empty()) {
        file.kind = ParseFileKind(arguments.format);
    } else if (const std::optional<FileKind> kind = KindOfEnding(path)) {
        file.kind = *kind;
    } else {
        throw UnknownEnding(path);
    }
    const FileKindInfo& info = GetInfo(file.kind);
    file.bytes = ReadText(path, fmt::format("give a *{} file", info.ending));
    const std::optional<FileKind> found = KindOfBytes(file.bytes);
    if (found && *found != file.kind) {
        const FileKindInfo& other = GetInfo(*found);
        throw FileError(fmt::format("{}: by its content it is {}, not {}; --format {} reads it as that", path,
                                    other.what, info.what, other.name));
    }
    return file;
}

SceneInput MakeInput(const scenes::SceneInfo& info, int size) {
    return {std::string(info.name), size, info.steps, info.showStep, &info};
}

SceneInput ChooseScene(const std::string& given, std::optional<int> size, const InputArguments& arguments) {
    CheckPoses(arguments);
    if (!IsFile(given, arguments)) {
        const scenes::SceneInfo& info = FindScene(given);
        RefuseMotion(given, arguments);
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
