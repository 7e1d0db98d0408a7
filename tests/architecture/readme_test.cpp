// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Documents stay true: every path that a Markdown file names exists. Named are the targets of links and pictures, words
// in code quotes that begin with a folder of the checkout, and first words of code blocks that do.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "source_tree.h"

namespace architecture {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> Documents() {
    std::vector<fs::path> documents;
    for (const char* folder : {"", "engine", "scenes", "testbed", "tests", "shaders"}) {
        if (!fs::exists(Root() / folder)) continue;
        for (const fs::directory_entry& entry : fs::directory_iterator(Root() / folder)) {
            if (entry.path().extension() == ".md") documents.push_back(fs::relative(entry.path(), Root()));
        }
    }
    return documents;
}

bool StartsInCheckout(const std::string& word) {
    static const std::set<std::string> folders = {"engine", "scenes", "testbed", "shaders", "tests", ".ci"};
    const std::size_t slash = word.find('/');
    return slash != std::string::npos && folders.contains(word.substr(0, slash));
}

/// Placeholders and patterns name no single file.
bool IsPattern(const std::string& word) { return word.find_first_of("<>*{}$…") != std::string::npos; }

std::set<std::string> NamedPaths(const SourceFile& document) {
    static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))"), quoted(R"(`([^`\s]+)[^`]*`)"), word(R"(^\s*(\S+))");
    std::set<std::string> paths;
    bool inBlock = false;
    for (const std::string& line : document.lines) {
        if (line.starts_with("```")) {
            inBlock = !inBlock;
            continue;
        }
        const auto collect = [&](const std::regex& pattern, bool always) {
            for (auto it = std::sregex_iterator(line.begin(), line.end(), pattern); it != std::sregex_iterator();
                 ++it) {
                const std::string path = (*it)[1];
                if (path.find("://") != std::string::npos || IsPattern(path)) continue;
                if (always || StartsInCheckout(path)) paths.insert(path);
            }
        };
        if (inBlock) {
            collect(word, false);
        } else {
            collect(link, true);
            collect(quoted, false);
        }
    }
    return paths;
}

TEST(Documents, NameOnlyPathsThatExist) {
    for (const fs::path& document : Documents()) {
        for (const std::string& path : NamedPaths(ReadSource(document))) {
            const bool exists = fs::exists(Root() / document.parent_path() / path) || fs::exists(Root() / path);
            EXPECT_TRUE(exists) << document.string() << " names " << path;
        }
    }
}

TEST(Documents, PathsAreFoundInLinksQuotesAndBlocks) {
    const SourceFile document{"x.md",
                              {"see [a](testbed/a.md#part) and ![b](b.png), `engine/c.h`, `std::x`, `out/tiles`", "```",
                               "testbed/run overlap", "scree list", "```"}};
    EXPECT_EQ(NamedPaths(document), (std::set<std::string>{"testbed/a.md", "b.png", "engine/c.h", "testbed/run"}));
}

}  // namespace
}  // namespace architecture
