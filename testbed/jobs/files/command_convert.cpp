// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree convert`: one kind of file out of another.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/new_file.h"
#include "testbed/base/progress.h"
#include "testbed/base/standard_error.h"
#include "testbed/engines/record_track.h"
#include "testbed/engines/saved_world.h"
#include "testbed/input/body_names.h"
#include "testbed/input/scene_file.h"
#include "testbed/jobs/files/commands.h"
#include "testbed/options/options.h"

namespace testbed {

namespace {

struct ConvertArguments {
    std::string in, out;
    std::optional<int> size, steps;
    std::string engine = "scree";
    TrackContents contents;
    InputArguments input;
    SettingArguments settings;
};

FileKind KindOfOutput(const std::string& path) {
    if (path == "-") return FileKind::scene;  // text, which a pipe is for
    if (const std::optional<FileKind> kind = KindOfEnding(path)) return *kind;
    throw UsageError(fmt::format("{}: its ending says no kind of file; there are {}", path, DescribeFileKinds()));
}

/// Runs what is no motion in an engine, and records it.
void RecordRun(const ConvertArguments& arguments) {
    const SceneInput input = ChooseScene(arguments.in, arguments.size, arguments.input);
    const std::string_view base = input.world != nullptr ? std::string_view(input.world->settings) : comparisonBase;
    const RunSpec spec = ParseSpec(arguments.engine, arguments.settings.typed, base);
    const std::unique_ptr<InteractiveRun> run = MakeRun(input.Start(), spec);
    const int steps = arguments.steps.value_or(input.steps);
    Progress progress(arguments.in, std::max(1, steps));
    RecordTrack(arguments.out, arguments.contents, *run, [&] {
        for (int i = 0; i < steps; ++i) {
            run->Step();
            progress.Advance(1);
        }
    });
}

void MakeTrack(const ConvertArguments& arguments) {
    const bool isFile = !arguments.input.format.empty() || LooksLikeFile(arguments.in);
    if (!isFile || arguments.input.from) return RecordRun(arguments);
    const InputFile file = ReadInputFile(arguments.in, arguments.input);
    if (file.kind == FileKind::track) {
        throw UsageError(fmt::format("{} is a track already; --from K runs an engine from its step K", arguments.in));
    }
    if (file.kind != FileKind::recording) return RecordRun(arguments);
    const Replayed replayed =
        ReplayRecording(file.bytes, arguments.in, {.wantsTrack = true, .contents = arguments.contents});
    if (!replayed.damage.empty()) PrintError("scree: {} {}\n", arguments.in, replayed.damage);
    WriteTextFile(arguments.out, replayed.track);
}

void MakeImage(const ConvertArguments& arguments, const SceneInput& input) {
    if (input.world == nullptr) {
        throw UsageError(
            fmt::format("{}: images come from our engine's images and recordings, and {} is neither; give "
                        "*.scene.json as the output, which any engine runs",
                        arguments.out, arguments.in));
    }
    const WorldImage& image = *input.world->image;
    WriteTextFile(arguments.out, {reinterpret_cast<const char*>(image.data()), image.size()});
}

int RunConvert(const ConvertArguments& arguments) {
    if (arguments.in.empty() || arguments.out.empty()) {
        throw UsageError("give what to read and what to write: scree convert IN OUT");
    }
    const FileKind kind = KindOfOutput(arguments.out);
    if (kind == FileKind::rube) {
        throw UsageError(fmt::format("{}: files of R.U.B.E. are only read; give *.scene.json", arguments.out));
    }
    std::error_code ignored;
    if (std::filesystem::equivalent(arguments.in, arguments.out, ignored)) {
        throw UsageError(fmt::format("{} is read and written; give another name to write", arguments.out));
    }
    const bool wantsMore = arguments.contents.tree || arguments.contents.stages;
    if (kind != FileKind::track && (arguments.steps || arguments.engine != "scree" || wantsMore)) {
        throw UsageError("--steps, --engine, --tree and --stages are for tracks: other files hold one moment");
    }
    if (kind == FileKind::track) {
        MakeTrack(arguments);
    } else if (kind == FileKind::recording) {
        throw UsageError(fmt::format(
            "{}: only a program that runs makes a recording: scree::StartRecording or SCREE_RECORD", arguments.out));
    } else {
        const SceneInput input = ChooseScene(arguments.in, arguments.size, arguments.input);
        if (kind == FileKind::image) {
            MakeImage(arguments, input);
        } else {
            WriteTextFile(arguments.out, WriteScene(WithWriter(input.Build())));
            if (input.world != nullptr) {
                for (const std::string& loss : input.world->losses) PrintError("scree: {}: {}\n", arguments.in, loss);
            }
        }
    }
    fmt::print("{}\n", arguments.out == "-" ? "a scene on standard output" : arguments.out);
    return exitDone;
}

}  // namespace

void AddConvertCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand(
        "convert", "One kind of file out of another: scenes of anything, tracks of recordings and of scenes that run");
    auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("IN", arguments->in, DescribeSceneArgument("A scene"));
    command->add_option("OUT", arguments->out,
                        "The file to write; its ending says its kind, and - is a scene on standard output");
    command->add_option("--size", arguments->size, "Size of a scene that `scree list` shows; its default if not given");
    AddInputOptions(*command, arguments->input);
    command->add_option("--engine", arguments->engine, "Engine whose run becomes a track: scree or box2d")
        ->capture_default_str();
    command->add_option("--steps", arguments->steps, "Steps of a run that becomes a track; the scene's if not given")
        ->check(CLI::Range(1, maxStep));
    command->add_flag("--tree", arguments->contents.tree,
                      "Keep the nodes of the engine's tree in a track: overlap shows them as the pane `recorded`");
    command->add_flag("--stages", arguments->contents.stages, "Keep the engine's times of each step in a track");
    AddSetOption(*command, arguments->settings, comparisonNote);
    command->callback([&request, arguments] { request.action = [arguments] { return RunConvert(*arguments); }; });
}

}  // namespace testbed
