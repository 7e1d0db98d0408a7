// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scene_folder.h.

#include "testbed/jobs/snapshot/scene_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/nearest.h"
#include "testbed/engines/run_spec.h"
#include "testbed/input/file_kind.h"
#include "testbed/input/track_file.h"
#include "testbed/options/options.h"
#include "testbed/picture/theme.h"
#include "testbed/view/layers.h"
#include "testbed/view/nodes.h"

namespace testbed {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view settingsName = "snapshots.json", format = "scree-snapshots";
constexpr int version = 1;
/// Wider or higher is no picture to compare.
constexpr int mostPixels = 8192;

/// What stands in snapshots.json, with its place for messages.
class Reader {
public:
    Reader(const Json& json, std::string place, std::string_view separator)
        : m_json(json), m_place(std::move(place)), m_separator(separator) {}

    [[noreturn]] void Refuse(std::string_view key, std::string_view problem) const {
        throw FileError(fmt::format("{}{}{}: {}", m_place, key.empty() ? "" : m_separator, key, problem));
    }
    void CheckKeys(std::span<const std::string_view> keys) const {
        if (!m_json.is_object()) Refuse("", "is not an object");
        for (const auto& [key, value] : m_json.items()) {
            if (std::ranges::find(keys, key) == keys.end()) Refuse("", DescribeUnknown("key", key, keys));
        }
    }
    [[nodiscard]] bool Has(const char* key) const { return m_json.contains(key); }
    [[nodiscard]] std::string Text(const char* key, std::string_view otherwise) const {
        if (!Has(key)) return std::string(otherwise);
        if (!m_json[key].is_string()) Refuse(key, "is not a text in quotes");
        return m_json[key].get<std::string>();
    }
    [[nodiscard]] std::vector<int> Steps() const {
        std::vector<int> steps;
        if (!Has("steps")) return steps;
        constexpr const char* cure = "give whole numbers from 1 on, in brackets: [60, 120]";
        if (!m_json["steps"].is_array() || m_json["steps"].empty()) Refuse("steps", cure);
        for (const Json& step : m_json["steps"]) {
            if (!step.is_number_unsigned() || step < 1 || step > maxStep) Refuse("steps", cure);
            steps.push_back(step.get<int>());
        }
        return steps;
    }
    /// What `parse` throws for a value gets its place.
    template <typename Parse>
    void Check(const char* key, Parse parse) const {
        try {
            parse();
        } catch (const std::invalid_argument& error) {
            Refuse(key, error.what());
        } catch (const UsageError& error) {
            Refuse(key, error.what());
        }
    }

private:
    const Json& m_json;
    std::string m_place;
    std::string_view m_separator;  ///< between the place and a key
};

bool IsNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
}

/// Not every *.json is a world.
bool IsScene(const fs::path& file) {
    const std::optional<FileKind> kind = KindOfEnding(file.string());
    return kind && (*kind != FileKind::rube || KindOfBytes(ReadText(file, "give a file")) == kind);
}

/// Paths of the scenes and motions below a folder, relative to it, sorted.
std::vector<std::string> ListScenes(const fs::path& folder) {
    if (!fs::is_directory(folder)) {
        throw FileError(fmt::format("{}: there is no such folder; --scenes DIR names one with {}", folder.string(),
                                    DescribeFileKinds()));
    }
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && IsScene(entry.path())) {
            files.push_back(fs::relative(entry.path(), folder).generic_string());
        }
    }
    std::ranges::sort(files);
    return files;
}

class Folder {
public:
    explicit Folder(const fs::path& folder) : m_folder(folder), m_files(ListScenes(folder)) {
        if (m_files.empty()) {
            throw UsageError(fmt::format("{} holds no scene; a scene is {}", folder.string(), DescribeFileKinds()));
        }
    }
    void SetImage(const std::string& image) { std::tie(m_width, m_height) = CheckedSize(image); }
    void Add(const Reader& row);
    [[nodiscard]] std::vector<SnapshotCase> Take() {
        // A scene runs once for each of its settings.
        std::ranges::stable_sort(m_cases, {},
                                 [](const SnapshotCase& one) { return std::tie(one.scene, one.settings, one.step); });
        return std::move(m_cases);
    }

private:
    static std::pair<int, int> CheckedSize(const std::string& image) {
        const auto [width, height] = ParseSize("image", image);
        if (std::min(width, height) < 16 || std::max(width, height) > mostPixels) {
            throw UsageError(fmt::format("image {}: sides are from 16 to {} pixels", image, mostPixels));
        }
        return {width, height};
    }
    const std::shared_ptr<const SceneInput>& Open(const std::string& file) {
        std::shared_ptr<const SceneInput>& input = m_inputs[file];
        if (input == nullptr) {
            InputArguments reading;
            reading.poses.clear();  // a motion is followed as it was recorded
            input = std::make_shared<const SceneInput>(ChooseScene((m_folder / file).string(), std::nullopt, reading));
        }
        return input;
    }
    void AddScene(const std::string& file, const Reader& row, SnapshotCase pattern);
    static void CheckStep(const SceneInput& input, int step, const Reader& row);

    fs::path m_folder;
    std::vector<std::string> m_files;
    std::map<std::string, std::shared_ptr<const SceneInput>> m_inputs;
    int m_width = snapshotWidth, m_height = snapshotHeight;
    std::vector<SnapshotCase> m_cases;
    std::set<std::string> m_ids;
};

void Folder::CheckStep(const SceneInput& input, int step, const Reader& row) {
    if (input.motion == nullptr) return;
    const std::vector<int>& steps = input.motion->GetSteps();
    if (input.HasStep(step) && std::ranges::binary_search(steps, step)) return;
    row.Refuse("steps", fmt::format("{} has no step {}; it was recorded from step {} to {}", input.name, step,
                                    steps.empty() ? 0 : steps.front(), input.steps));
}

void Folder::AddScene(const std::string& file, const Reader& row, SnapshotCase pattern) {
    pattern.input = Open(file);
    const FileKindInfo& kind = GetInfo(*KindOfEnding(file));
    pattern.scene = file.substr(0, file.size() - kind.ending.size());
    pattern.size = pattern.input->size;
    std::vector<int> steps = row.Steps();
    if (steps.empty()) steps.push_back(std::max(1, pattern.input->showStep));
    const std::string name = pattern.name;
    for (const int step : steps) {
        CheckStep(*pattern.input, step, row);
        pattern.step = step;
        pattern.name = fmt::format("step-{:04}-{}", step, name);
        if (!m_ids.insert(pattern.GetId()).second) {
            row.Refuse("", fmt::format("is another picture called {}; give each a \"name\"", pattern.GetId()));
        }
        m_cases.push_back(pattern);
    }
}

void Folder::Add(const Reader& row) {
    constexpr std::array<std::string_view, 7> keys{"scene", "steps", "kind", "layers", "theme", "settings", "name"};
    constexpr std::array<std::string_view, 2> kinds{"render", "overlap"};
    row.CheckKeys(keys);
    SnapshotCase pattern;
    pattern.width = m_width;
    pattern.height = m_height;
    pattern.kind = row.Text("kind", kinds[0]);
    if (std::ranges::find(kinds, pattern.kind) == kinds.end()) {
        row.Refuse("kind", DescribeUnknown("kind of picture", pattern.kind, kinds));
    }
    const bool isOverlap = pattern.kind == kinds[1];
    pattern.layers = row.Text("layers", isOverlap ? "internal" : "bodies,joints,contacts");
    pattern.theme = row.Text("theme", "dark");
    pattern.settings = row.Text("settings", "");
    pattern.name = row.Text("name", pattern.kind);
    row.Check("layers", [&] {
        if (isOverlap) {
            (void)ParseNodeSelection(pattern.layers);
        } else {
            (void)ParseLayers(pattern.layers);
        }
    });
    row.Check("theme", [&] { (void)ParseTheme(pattern.theme); });
    row.Check("settings", [&] {
        RunSpec spec = MakeSpec("scree");
        ApplySettings(spec, pattern.settings);
    });
    if (pattern.name.empty() || !std::ranges::all_of(pattern.name, IsNameCharacter)) {
        row.Refuse("name", fmt::format("'{}' is not one of letters, digits and ._-", pattern.name));
    }
    const std::string scene = row.Text("scene", "");
    if (scene == "*") {
        for (const std::string& file : m_files) AddScene(file, row, pattern);
        return;
    }
    const std::vector<std::string_view> files(m_files.begin(), m_files.end());
    if (std::ranges::find(files, scene) == files.end()) {
        row.Refuse("scene", scene.empty() ? std::string("is missing; give a file of this folder, or \"*\"")
                                          : DescribeUnknown("scene", scene, files));
    }
    AddScene(scene, row, pattern);
}

}  // namespace

std::vector<SnapshotCase> ReadSceneFolder(const fs::path& folder) {
    Folder cases(folder);
    const fs::path path = folder / settingsName;
    const Json settings = fs::exists(path)
                              ? ReadJsonObject(path)
                              : Json{{"format", format},
                                     {"version", version},
                                     {"snapshots", {{{"scene", "*"}}, {{"scene", "*"}, {"kind", "overlap"}}}}};
    const Reader root(settings, path.string(), ": ");
    constexpr std::array<std::string_view, 4> keys{"format", "version", "image", "snapshots"};
    root.CheckKeys(keys);
    if (root.Text("format", "") != format) root.Refuse("format", fmt::format("is not \"{}\"", format));
    if (settings.value("version", Json()) != version) {
        root.Refuse("version", fmt::format("is not {}, the only one that this program reads", version));
    }
    if (root.Has("image")) root.Check("image", [&] { cases.SetImage(root.Text("image", "")); });
    if (!root.Has("snapshots") || !settings["snapshots"].is_array() || settings["snapshots"].empty()) {
        root.Refuse("snapshots", R"(is not a list; give [{"scene": "*"}] for a picture of each scene)");
    }
    for (std::size_t i = 0; i < settings["snapshots"].size(); ++i) {
        cases.Add(Reader(settings["snapshots"][i], fmt::format("{}: snapshots[{}]", path.string(), i), "."));
    }
    return cases.Take();
}

}  // namespace testbed
