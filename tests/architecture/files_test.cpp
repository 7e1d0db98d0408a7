// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rules for single files: licence lines, an opening paragraph, include guards, length, and headers that compile alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "source_tree.h"

namespace architecture {
namespace {

namespace fs = std::filesystem;

/// Longer files are hard to read whole; a single one this long is a defect.
constexpr std::size_t mostLines = 700;

TEST(Files, BeginWithTheLicenceLinesAndAParagraph) {
    ASSERT_FALSE(SourceFiles().empty());
    for (const SourceFile& file : SourceFiles()) {
        std::size_t line = 0;
        const auto skip = [&](std::string_view start) {
            if (line < file.lines.size() && file.lines[line].starts_with(start)) ++line;
        };
        skip("#!");
        skip("#version");  // GLSL demands it first
        ASSERT_GT(file.lines.size(), line + 3) << file.path;
        EXPECT_TRUE(file.lines[line].ends_with("SPDX-FileCopyrightText: the Scree authors")) << file.path;
        EXPECT_TRUE(file.lines[line + 1].ends_with("SPDX-License-Identifier: MIT")) << file.path;
        EXPECT_LE(file.lines[line + 2].size(), 2u) << file.path << ": an empty comment line after the licence";
        EXPECT_GT(file.lines[line + 3].size(), 4u) << file.path << ": what the file does";
    }
}

TEST(Files, AreNotTooLong) {
    for (const SourceFile& file : SourceFiles()) EXPECT_LE(file.lines.size(), mostLines) << file.path;
}

TEST(Files, HeadersAreGuarded) {
    for (const SourceFile& file : SourceFiles()) {
        if (!file.IsHeader()) continue;
        EXPECT_NE(std::find(file.lines.begin(), file.lines.end(), "#pragma once"), file.lines.end()) << file.path;
    }
}

TEST(Files, IncludeEachHeaderOnceAndNeverThemselves) {
    for (const SourceFile& file : SourceFiles()) {
        std::set<std::string> seen;
        for (const std::string& name : file.Includes()) {
            EXPECT_TRUE(seen.insert(name).second) << file.path << " includes " << name << " twice";
            EXPECT_NE(name, file.path) << "includes itself";
        }
    }
}

/// Headers that no source file includes first: one that does shows by compiling that its first header needs no other.
/// Tests do not count, they have precompiled headers.
std::vector<std::string> HeadersToCompile() {
    std::set<std::string> shown;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.ends_with(".cpp") || file.path.starts_with("tests/")) continue;
        const std::vector<std::string> includes = file.Includes();
        if (includes.empty()) continue;
        for (const char* folder : {"", "engine/include/", "engine/src/", "engine/compat/"}) {
            shown.insert(folder + includes.front());
        }
    }
    // Box2D 3's headers have the names of Box2D 2.4's, and need not be here: tests/capture compiles it where they are.
    shown.insert("testbed/capture/scree_capture_box2d3.h");
    std::vector<std::string> headers;
    for (const SourceFile& file : SourceFiles()) {
        if (file.IsHeader() && !shown.contains(file.path)) headers.push_back(file.path);
    }
    return headers;
}

class Header : public testing::TestWithParam<std::string> {};

TEST_P(Header, CompilesAlone) {
    const fs::path folder = fs::path(testing::TempDir()) / "scree-header-alone";
    fs::create_directories(folder);
    std::string name = GetParam();
    std::replace(name.begin(), name.end(), '/', '-');
    const fs::path source = folder / (name + ".cpp"), log = folder / (name + ".log");
    std::ofstream(source) << "#include \"" << (Root() / GetParam()).string() << "\"\n";

    const std::string root = Root().string();
    const std::string command = std::string(SCREE_COMPILER) + " -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I'" +
                                root + "' -I'" + root + "/engine/include' -I'" + root + "/engine/src' -isystem '" +
                                SCREE_GENERATED_DIR + "' '" + source.string() + "' >'" + log.string() + "' 2>&1";
    const int status = std::system(command.c_str());
    std::ostringstream words;
    words << std::ifstream(log).rdbuf();
    fs::remove(source);
    fs::remove(log);
    EXPECT_EQ(status, 0) << words.str();
}

INSTANTIATE_TEST_SUITE_P(All, Header, testing::ValuesIn(HeadersToCompile()), [](const auto& tested) {
    std::string name = tested.param;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

}  // namespace
}  // namespace architecture
