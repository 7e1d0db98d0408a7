// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Includes point one way: base ← geometry ← broad_phase ← state ← constraints ← pipeline ← world in the engine; scenes
// knows nothing of this project, view no GL and no engine, render no engine, and only the adapters see Box2D.

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <filesystem>
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
    static const std::regex pattern(R"(^(glad/|GL/|GLES|EGL/|KHR/|GLFW/|testbed/context/(egl|osmesa|backends)))");
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
    // A stage is a header with a source of the same name; a header alone is data that stages share.
    const auto isStage = [](const std::filesystem::path& header) {
        return header.parent_path() == "pipeline" &&
               std::filesystem::exists(Root() / "engine/src" / std::filesystem::path(header).replace_extension(".cpp"));
    };
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/src/pipeline/")) continue;
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
    Lines wrong;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/") || file.path.starts_with(base)) continue;
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
        return name.find_first_of("/.") != std::string::npos && !name.starts_with("scree/");
    });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, ScenesAreDataOnTheStandardLibrary) {
    const Lines wrong = FindIncludes("scenes/", [](const std::string& name) {
        return name.find_first_of("/.") != std::string::npos && !IsScenes(name);
    });
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, OnlyTheAdaptersSeeBox2d) {
    const Lines wrong = FindIncludes("testbed/", IsBox2d);
    Lines outside;
    for (const std::string& line : wrong) {
        if (!line.starts_with("testbed/adapters/")) outside.push_back(line);
    }
    EXPECT_TRUE(outside.empty()) << Join(outside);
}

TEST(Layering, OnlyTheAdaptersSeeOurEngine) {
    // The list of the algorithms' names is data that the command line and its tests share with the engine.
    const Lines wrong = FindIncludes(
        "testbed/", [](const std::string& name) { return IsEngine(name) && name != "scree/broad_phase_kind.h"; });
    Lines outside;
    for (const std::string& line : wrong) {
        if (!line.starts_with("testbed/adapters/")) outside.push_back(line);
    }
    EXPECT_TRUE(outside.empty()) << Join(outside);
}

TEST(Layering, ViewKnowsNoGl) {
    const Lines wrong = FindIncludes("testbed/view/", IsGl);
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, RenderAndViewKnowNoEngine) {
    // A snapshot is plain data and the one header of the adapters that a view may see.
    for (const char* folder : {"testbed/render/", "testbed/view/", "testbed/context/"}) {
        const Lines wrong = FindIncludes(folder, [](const std::string& name) {
            return IsEngine(name) || IsBox2d(name) ||
                   (name.starts_with("testbed/adapters/") && name != "testbed/adapters/snapshot.h");
        });
        EXPECT_TRUE(wrong.empty()) << Join(wrong);
    }
}

TEST(Layering, GlStaysInRenderAndContext) {
    Lines wrong;
    for (const std::string& line : FindIncludes("testbed/", IsGl)) {
        if (!line.starts_with("testbed/render/") && !line.starts_with("testbed/context/")) wrong.push_back(line);
    }
    EXPECT_TRUE(wrong.empty()) << Join(wrong);
}

TEST(Layering, TheRulesSeeIncludesAtAll) {
    // Guards the tests above: a pattern that matches nothing would let everything pass.
    EXPECT_FALSE(FindIncludes("testbed/adapters/", IsBox2d).empty());
    EXPECT_FALSE(FindIncludes("testbed/render/", IsGl).empty());
    EXPECT_FALSE(FindIncludes("engine/src/world/", [](const std::string& name) { return LayerOf(name) >= 0; }).empty());
}

}  // namespace
}  // namespace architecture
