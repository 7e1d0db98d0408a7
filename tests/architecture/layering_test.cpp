// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Includes point one way. In the engine it is base ← geometry ← broad_phase ← state ← constraints ← pipeline ← world.
// In the testbed it is base, capture ← input, picture ← engines ← moments, gl, page ← view ← options ← jobs ← cli,
// where no job includes another. Scenes know nothing of this project, pictures and views no engine. Only engines/, what
// records one and what abuses one see an engine.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <regex>

#include "source_tree.h"

namespace architecture {
namespace {

using Lines = std::vector<std::string>;

/// What a failing test prints: one line per wrong include.
std::string Join(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += "  " + line + "\n";
    return text;
}

bool IsGl(const std::string& name) {
    static const std::regex pattern(R"(^(glad/|GL/|GLES|EGL/|KHR/|GLFW/|testbed/gl/(egl|osmesa|backends)))");
    return std::regex_search(name, pattern);
}
bool IsBox2d(const std::string& name) { return name.starts_with("box2d/"); }
bool IsEngine(const std::string& name) { return name.starts_with("scree/") || name.starts_with("engine/"); }
bool IsTestbed(const std::string& name) { return name.starts_with("testbed/"); }
bool IsScenes(const std::string& name) { return name.starts_with("scenes/"); }

constexpr std::array<std::string_view, 7> layers = {"base",        "geometry", "broad_phase", "state",
                                                    "constraints", "pipeline", "world"};

/// Index of the layer that a path such as "state/bodies.h" begins with, or −1.
int LayerOf(std::string_view path) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (path.starts_with(std::string(layers[i]) + "/")) return static_cast<int>(i);
    }
    return -1;
}

TEST(Layering, AnEngineLayerIncludesOnlyItselfAndLowerOnes) {
    constexpr std::string_view sources = "engine/src/";
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with(sources)) continue;
        const int own = LayerOf(std::string_view(file.path).substr(sources.size()));
        EXPECT_GE(own, 0) << file.path << " is in no layer";
        for (const std::string& name : file.Includes()) {
            if (LayerOf(name) > own) wrong.push_back(file.path + " includes " + name);
        }
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, AStageOfTheStepIncludesNoOtherStage) {
    // A stage is a header with a source of the same name; a header alone is data that stages share. One stage is the
    // choice between others and hence includes them: the solver's.
    const auto isTheChoice = [](const std::string& path) {
        return path == "engine/src/pipeline/solve.h" || path == "engine/src/pipeline/solve.cpp";
    };
    const auto isStage = [](const std::filesystem::path& header) {
        return header.parent_path() == "pipeline" &&
               std::filesystem::exists(Root() / "engine/src" / std::filesystem::path(header).replace_extension(".cpp"));
    };
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/src/pipeline/") || isTheChoice(file.path)) continue;
        for (const std::string& name : file.Includes()) {
            const std::filesystem::path header = name;
            if (isStage(header) && header.stem() != std::filesystem::path(file.path).stem()) {
                wrong.push_back(file.path + " includes " + name);
            }
        }
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, OnlyTheBaseOfTheEngineNamesCompilersAndInstructions) {
    static const std::regex names(
        R"(__builtin_|__attribute__|__atomic_|gnu::|_mm\d*_|__GNUC__|_MSC_VER|__SSE|__AVX|__ARM)");
    constexpr std::string_view base = "engine/src/base/";
    // C has no header of ours below it; what a library exports is said in public headers, which may not include ours.
    constexpr std::string_view cInterface = "engine/include/scree/scree_c.h", exports = "engine/include/scree/api.h";
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/") || file.path.starts_with(base)) continue;
        if (file.path == cInterface || file.path == exports) continue;
        for (const std::string& line : file.lines) {
            if (std::regex_search(line, names)) wrong.push_back(file.path + ": " + line);
        }
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, TheEngineDependsOnNothingElseHere) {
    for (const char* folder : {"engine/src/", "engine/include/"}) {
        const Lines wrong = FindIncludes(folder, [](const std::string& name) {
            return IsTestbed(name) || IsScenes(name) || IsBox2d(name) || IsGl(name);
        });
        EXPECT_TRUE(wrong.empty()) << Join(wrong);
    }
}

TEST(Layering, CompatStandsOnThePublicHeadersAndItsOwn) {
    // Its box2d/… headers are its own: nothing else in engine/ has that folder.
    const Lines wrong = FindIncludes("engine/compat/", [](const std::string& name) {
        return IsTestbed(name) || IsScenes(name) || IsGl(name) || name.starts_with("world/") ||
               name.starts_with("pipeline/") || name.starts_with("state/") || name.starts_with("constraints/");
    });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, PublicHeadersIncludeOnlyPublicHeadersAndTheStandardLibrary) {
    const Lines wrong = FindIncludes("engine/include/", [](const std::string& name) {
        const bool isOfC = name == "stddef.h" || name == "stdint.h" || name == "stdbool.h";
        return name.find_first_of("/.") != std::string::npos && !name.starts_with("scree/") && !isOfC;
    });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, ScenesAreDataOnTheStandardLibrary) {
    const Lines wrong = FindIncludes("scenes/", [](const std::string& name) {
        return name.find_first_of("/.") != std::string::npos && !IsScenes(name);
    });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

/// Files of a job that call an engine by its own interface, since that interface is what they measure.
bool IsEngineProbe(std::string_view path) {
    constexpr std::array<std::string_view, 4> probes = {
        "testbed/jobs/extremes/abuse_box2d.cpp", "testbed/jobs/extremes/abuse_scree.cpp",
        "testbed/jobs/extremes/abuse_world.h", "testbed/jobs/requires/break_even.cpp"};
    return std::find(probes.begin(), probes.end(), path) != probes.end();
}

/// Headers for programs of users, each of which records worlds of one engine.
bool IsCapture(std::string_view path) { return path.starts_with("testbed/capture/"); }

/// Lines "FILE includes NAME" below testbed/ of files that may not see an engine.
Lines OutsideEngines(const std::function<bool(const std::string&)>& isWrong) {
    Lines outside;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("testbed/") || file.path.starts_with("testbed/engines/")) continue;
        if (IsEngineProbe(file.path) || IsCapture(file.path)) continue;
        for (const std::string& name : file.Includes()) {
            if (isWrong(name)) outside.push_back(file.path + " includes " + name);
        }
    }
    return outside;
}

TEST(Layering, OnlyEnginesSeesBox2d) {
    const Lines wrong = OutsideEngines(IsBox2d);
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, OnlyEnginesSeesOurEngine) {
    // The list of the algorithms' names is data that the command line and its tests share with the engine.
    const Lines wrong =
        OutsideEngines([](const std::string& name) { return IsEngine(name) && name != "scree/broad_phase_kind.h"; });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

/// A folder of the testbed and the folders below it, which it may include.
struct Folder {
    std::string_view name, below;
};
constexpr std::array<Folder, 12> folders = {{{"base", ""},
                                             {"capture", ""},
                                             {"input", "base capture"},
                                             {"picture", "base"},
                                             {"engines", "base capture input"},
                                             {"moments", "base engines"},
                                             {"gl", "base picture"},
                                             {"page", "base picture"},
                                             {"view", "base picture engines gl"},
                                             {"options", "base input picture engines gl view moments"},
                                             {"jobs", "base input picture engines moments gl page view options"},
                                             {"cli", "base input picture engines gl page view options jobs"}}};

/// "jobs" of "testbed/jobs/bench/row.h"; empty for a file directly below testbed/.
std::string_view FolderOf(std::string_view path) {
    path.remove_prefix(std::string_view("testbed/").size());
    return path.substr(0, path.find('/') == std::string_view::npos ? 0 : path.find('/'));
}

/// "bench" of "testbed/jobs/bench/row.h".
std::string_view JobOf(std::string_view path) {
    constexpr std::string_view jobs = "testbed/jobs/";
    if (!path.starts_with(jobs)) return {};
    path.remove_prefix(jobs.size());
    return path.substr(0, path.find('/'));
}

bool HasWord(std::string_view words, std::string_view word) {
    return (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

TEST(Layering, AFolderOfTheTestbedIncludesOnlyThoseBelowIt) {
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("testbed/") || FolderOf(file.path).empty()) continue;
        const auto own =
            std::ranges::find_if(folders, [&](const Folder& folder) { return folder.name == FolderOf(file.path); });
        if (own == folders.end()) {
            wrong.push_back(file.path + " is in a folder without a place among the layers");
            continue;
        }
        for (const std::string& name : file.Includes()) {
            if (!IsTestbed(name)) continue;
            const std::string_view other = FolderOf(name);
            if (other != own->name && !HasWord(own->below, other)) wrong.push_back(file.path + " includes " + name);
        }
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, NoJobIncludesAnother) {
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (JobOf(file.path).empty()) continue;
        for (const std::string& name : file.Includes()) {
            if (!JobOf(name).empty() && JobOf(name) != JobOf(file.path)) {
                wrong.push_back(file.path + " includes " + name);
            }
        }
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, ViewsSeeOnlySnapshotsOfEngines) {
    // A snapshot is plain data.
    const Lines wrong = FindIncludes("testbed/view/", [](const std::string& name) {
        return name.starts_with("testbed/engines/") && name != "testbed/engines/snapshot.h";
    });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, GlStaysInItsFolderAndTheWindow) {
    Lines wrong;
    for (const std::string& line : FindIncludes("testbed/", IsGl)) {
        if (!line.starts_with("testbed/gl/") && !line.starts_with("testbed/jobs/window/glfw.cpp"))
            wrong.push_back(line);
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, TheRulesSeeIncludesAtAll) {
    // Guards the tests above: a pattern that matches nothing would let everything pass.
    EXPECT_FALSE(FindIncludes("testbed/engines/", IsBox2d).empty());
    EXPECT_FALSE(FindIncludes("testbed/gl/", IsGl).empty());
    EXPECT_FALSE(FindIncludes("testbed/jobs/", IsTestbed).empty());
    EXPECT_FALSE(FindIncludes("engine/src/world/", [](const std::string& name) { return LayerOf(name) >= 0; }).empty());
    EXPECT_EQ(FolderOf("testbed/jobs/bench/row.h"), "jobs");
    EXPECT_EQ(JobOf("testbed/jobs/bench/row.h"), "bench");
    EXPECT_FALSE(HasWord("base picture", "pic"));
}

}  // namespace
}  // namespace architecture
