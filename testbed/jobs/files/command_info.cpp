// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree info`: what is in a file that can be given in place of a scene, and how large the world in it is.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/json_print.h"
#include "testbed/base/text.h"
#include "testbed/engines/engine_run.h"
#include "testbed/engines/saved_world.h"
#include "testbed/engines/track_run.h"
#include "testbed/input/body_names.h"
#include "testbed/input/rube_file.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "testbed/jobs/files/commands.h"
#include "testbed/options/scene_input.h"
#include "testbed/view/camera.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
    std::vector<std::string> files;
    InputArguments input;
    bool json = false;
};

/// What a file is said to hold, in the order in which it is printed.
using Facts = Json;

void AddWorld(Facts& facts, const scenes::Scene& scene) {
    const scenes::SceneCounts counts = scenes::Count(scene);
    facts["bodies"] = counts.Bodies();
    facts["static_bodies"] = counts.staticBodies;
    facts["kinematic_bodies"] = counts.kinematicBodies;
    facts["dynamic_bodies"] = counts.dynamicBodies;
    facts["fixtures"] = counts.Fixtures();
    facts["joints"] = counts.joints;
    facts["gravity"] = {scene.gravity.x, scene.gravity.y};
}

/// Left, bottom, right and top of all fixtures, and of those whose bodies can move, over a run to its end.
void AddExtent(Facts& facts, EngineRun& run, int steps) {
    FitArea area;
    std::optional<Box> all;
    const auto add = [&all](const Box& box) { all = all ? Join(*all, box) : box; };
    Snapshot snapshot;
    const Snapshot* const shown[] = {&snapshot};
    for (int i = 0; i <= steps; ++i) {
        if (i > 0) run.Step();
        run.Capture(snapshot, {.contacts = false, .joints = false, .nodes = false, .pairs = false});
        AddStep(area, shown);
        std::ranges::for_each(area.still, add);
    }
    if (area.moving) add(*area.moving);
    const auto tell = [&facts](const char* key, const std::optional<Box>& box) {
        if (box) facts[key] = {box->lower.x, box->lower.y, box->upper.x, box->upper.y};
    };
    tell("extent", all);
    tell("moving_extent", area.moving);
}

/// Of a world at one moment.
void AddExtent(Facts& facts, const scenes::Scene& scene) {
    AddExtent(facts, *MakeRun(RunStart(scene), MakeSpec("scree")), 0);
}

/// Those that there are, each once, in the order of the bodies.
Json ListNames(const std::vector<std::string>& all) {
    Json names = Json::array();
    std::set<std::string_view> known;
    for (const std::string& name : all) {
        if (!name.empty() && known.insert(name).second) names.push_back(name);
    }
    return names;
}

Facts FactsOfScene(const scenes::Scene& scene) {
    Facts facts;
    if (const std::string writer = WriterOf(scene); !writer.empty()) facts["writer"] = writer;
    facts["name"] = scene.name;
    AddWorld(facts, scene);
    AddExtent(facts, scene);
    facts["steps"] = scene.steps;
    facts["time_step"] = scene.timeStep;
    facts["spawned_later"] = scene.spawns.size();
    facts["names"] = ListNames(NamesIn(scene));
    return facts;
}

Facts FactsOfTrack(TrackFile file) {
    const auto shared = std::make_shared<TrackFile>(std::move(file));
    const TrackFile& track = *shared;
    const TrackInfo& info = track.GetInfo();
    Facts facts;
    facts["version"] = info.version;
    facts["writer"] = info.writer;
    facts["engine"] = info.engine;
    AddWorld(facts, track.GetParts());
    const std::vector<int>& steps = track.GetSteps();
    const int first = FirstStepOf(track);
    const auto later = std::ranges::count_if(steps, [first](int step) { return step > first; });
    AddExtent(facts, *MakeTrackRun(shared, first), static_cast<int>(later));
    facts["steps"] = steps.size();
    if (!steps.empty()) {
        facts["first_step"] = steps.front();
        facts["last_step"] = steps.back();
    }
    facts["time_step"] = info.timeStep;
    facts["created_later"] = std::ranges::count_if(track.GetBodies(), [](const auto& b) { return b.createdAfter > 0; });
    facts["destroyed"] = std::ranges::count_if(track.GetBodies(), [](const auto& b) { return b.destroyedAfter >= 0; });
    facts["contacts"] = info.hasContacts;
    facts["stages"] = info.hasStages;
    facts["tree"] = info.hasNodes;
    facts["marks"] = info.marks;
    std::vector<std::string> names;
    for (const TrackBody& body : track.GetBodies()) names.push_back(body.name);
    facts["names"] = ListNames(names);
    facts["damage"] = info.damage;
    return facts;
}

Facts FactsOfImage(const SavedWorld& world) {
    Facts facts;
    facts["version"] = GetImageVersion();
    facts["writer"] = "scree";
    facts["engine"] = "scree";
    AddWorld(facts, world.scene);
    AddExtent(facts, world.scene);
    facts["steps"] = world.scene.steps;
    facts["settings"] = world.settings;
    if (!world.losses.empty()) facts["notices"] = world.losses;
    return facts;
}

Facts FactsOfRecording(std::string_view bytes, const std::string& file) {
    Replayed replayed = ReplayRecording(bytes, file, {.wantsTrack = true});
    Facts facts = FactsOfTrack(TrackFile(std::move(replayed.track), file));
    facts["version"] = GetRecordingVersion();
    facts["writer"] = "scree";
    for (const char* key : {"contacts", "stages", "tree", "marks", "names"}) facts.erase(key);
    facts["calls"] = replayed.calls;
    facts["damage"] = replayed.damage;
    return facts;
}

Facts FactsOfRube(const RubeWorld& world) {
    Facts facts{{"writer", "R.U.B.E."}};
    facts.update(FactsOfScene(world.scene));
    facts["notices"] = world.notices;
    return facts;
}

/// What a file says it is, though its ending says nothing.
InputFile ReadAnyFile(const std::string& path, const InputArguments& given) {
    InputArguments input = given;
    if (input.format.empty() && !KindOfEnding(path)) {
        const std::optional<FileKind> kind = KindOfBytes(ReadText(path, "give a file"));
        if (!kind) {
            throw FileError(fmt::format("{}: it neither ends nor begins like any of {}", path, DescribeFileKinds()));
        }
        input.format = GetInfo(*kind).name;
    }
    return ReadInputFile(path, input);
}

Facts ReadFacts(const std::string& path, const InputArguments& input) {
    InputFile file = ReadAnyFile(path, input);
    const FileKindInfo& info = GetInfo(file.kind);
    Facts facts{{"file", path}, {"kind", info.name}, {"what", info.what}, {"bytes", file.bytes.size()}};
    switch (file.kind) {
        case FileKind::scene:
            facts["version"] = sceneVersion;
            facts.update(FactsOfScene(ReadScene(file.bytes, path)));
            break;
        case FileKind::track:
            facts.update(FactsOfTrack(TrackFile(std::move(file.bytes), path)));
            break;
        case FileKind::image:
            facts.update(FactsOfImage(ReadWorldImage(file.bytes, path)));
            break;
        case FileKind::recording:
            facts.update(FactsOfRecording(file.bytes, path));
            break;
        case FileKind::rube:
            facts.update(FactsOfRube(ReadRube(file.bytes, path)));
            break;
    }
    return facts;
}

/// Left, bottom, right, top as size and corners.
std::string PrintExtent(const Json& extent) {
    const auto at = [&extent](std::size_t i) { return extent[i].get<float>(); };
    return fmt::format("{:.6g} x {:.6g} m, from {:.6g}, {:.6g} to {:.6g}, {:.6g}", at(2) - at(0), at(3) - at(1), at(0),
                       at(1), at(2), at(3));
}

/// A value for readers; empty: not worth a line.
std::string Print(const Json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_string()) return ToPrintable(value.get<std::string>());
    if (value.is_number_float()) return fmt::format("{}", value.get<float>());
    if (!value.is_array()) return PrintJson(value);
    constexpr std::size_t most = 50;  // --json has all
    std::string text;
    for (std::size_t i = 0; i < std::min(value.size(), most); ++i) text += (i == 0 ? "" : ", ") + Print(value[i]);
    if (value.size() > most) text += fmt::format(" and {} more", value.size() - most);
    return text;
}

void PrintFacts(const Facts& facts) {
    for (const auto& [key, value] : facts.items()) {
        if (key == "notices") {
            for (const Json& notice : value) fmt::print("{:<17}{}\n", "notice", Print(notice));
            continue;
        }
        const std::string text = key.ends_with("extent") ? PrintExtent(value) : Print(value);
        std::string name = key;
        std::ranges::replace(name, '_', ' ');
        if (!text.empty()) fmt::print("{:<17}{}\n", name, text);
    }
}

int RunInfo(const InfoArguments& arguments) {
    if (arguments.files.empty()) throw UsageError(fmt::format("which file? Give {}", DescribeFileKinds()));
    Json list = Json::array();
    for (const std::string& file : arguments.files) list.push_back(ReadFacts(file, arguments.input));
    if (arguments.json) {
        fmt::print("{}\n", PrintJson(Json{{"schema", 1}, {"files", list}}, 2));
        return exitDone;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (i > 0) fmt::print("\n");
        PrintFacts(list[i]);
    }
    return exitDone;
}

}  // namespace

void AddInfoCommand(CLI::App& app, Request& request) {
    CLI::App* command = app.add_subcommand(
        "info", "What is in a file: kind, version, who wrote it, bodies, steps, gravity and size of the world");
    auto arguments = std::make_shared<InfoArguments>();
    command->add_option("FILE", arguments->files, "Files: " + DescribeFileKinds());
    AddFormatOption(*command, arguments->input);
    command->add_flag("--json", arguments->json, "As JSON");
    command->callback([&request, arguments] { request.action = [arguments] { return RunInfo(*arguments); }; });
}

}  // namespace testbed
