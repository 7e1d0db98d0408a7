// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Pages as Markdown, and the results in the repository, which are as a command wrote them.

#include "testbed/page/markdown.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "testbed/base/input.h"
#include "testbed/page/page.h"

namespace testbed {
namespace {

Page MakeSample() {
    Page page{.title = "Sample", .intro = "What it is.", .facts = {{"command", "scree sample"}, {"cores", "2"}}};
    PageTable table{.columns = {{.name = "scene"}, {.name = "total", .unit = "ms", .numeric = true, .group = "ours"}}};
    table.rows.push_back({"a|b", PageCell::Number(1234.5, 1)});
    page.sections.push_back({.title = "Times", .intro = "In one run.", .blocks = {table, PageNote{"Mind this."}}});
    page.sections.push_back({.title = "Curves", .intro = "Of one run.", .blocks = {PageFigures{}}});
    page.sections.push_back({.title = "Details", .blocks = {PageText{"long"}}, .folded = true});
    return page;
}

TEST(Markdown, HasTextTablesAndNotesButNothingFolded) {
    const std::string text = MakeMarkdown(MakeSample());
    EXPECT_TRUE(
        text.starts_with("# Sample\n\nWhat it is.\n\n- command: `scree sample`\n- cores: 2\n\n## Times\n\n"
                         "In one run.\n\n| scene | ours: total, ms |\n|---|---:|\n| a\\|b | 1,234.5 |\n\n"
                         "> Mind this.\n\n"))
        << text;
    EXPECT_EQ(text.find("Details"), std::string::npos);
    EXPECT_EQ(text.find("Curves"), std::string::npos) << "a section with nothing but figures";
}

TEST(Markdown, AChangeByHandIsSeen) {
    const std::string text = MakeMarkdown(MakeSample());
    EXPECT_TRUE(IsUnedited(text));
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string edited = text;
        edited[i] = edited[i] == '7' ? '8' : '7';
        ASSERT_FALSE(IsUnedited(edited)) << i;
    }
    EXPECT_FALSE(IsUnedited(text + "more\n"));
    EXPECT_FALSE(IsUnedited(""));
}

TEST(Markdown, ResultsInTheRepositoryAreAsACommandWroteThem) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(SCREE_REFERENCE_FOLDER "/../../testbed/docs/results")) {
        ++files;
        EXPECT_TRUE(IsUnedited(ReadText(entry.path(), ""))) << entry.path() << ": run the command in it again";
    }
    EXPECT_GE(files, 2);
}

}  // namespace
}  // namespace testbed
