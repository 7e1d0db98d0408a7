// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joining the lines of shards gives the unsharded file, whatever the order; wrong files are named.

#include "testbed/base/case_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "testbed/base/errors.h"
#include "testbed/base/new_file.h"
#include "testbed/base/shard.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

constexpr std::size_t caseCount = 23;

/// The file of one shard; case 5 has two lines.
std::string MakeLines(const Shard& shard, const std::string& command = "bench", std::size_t count = caseCount) {
    CaseLines lines(command, count);
    for (std::size_t number = 0; number < count; ++number) {
        if (!shard.Contains(number)) continue;
        lines.Add(number, {{"value", number * number}});
        if (number == 5) lines.Add(number, {{"value", "second line"}});
    }
    return lines.GetText();
}

std::string MessageOf(const std::vector<CaseFile>& files) {
    try {
        (void)MergeCaseLines(files);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

TEST(CaseLines, MergedShardsAreTheUnshardedFileInAnyOrder) {
    const std::string whole = MakeLines({});
    for (const int count : {1, 2, 3, 7, 40}) {
        std::vector<CaseFile> files;
        for (int index = 1; index <= count; ++index) {
            files.push_back({std::to_string(index), MakeLines({.index = index, .count = count})});
        }
        for (int turn = 0; turn < 2; ++turn) {
            const MergedLines merged = MergeCaseLines(files);
            EXPECT_EQ(merged.text, whole) << count;
            EXPECT_TRUE(merged.missing.empty());
            std::reverse(files.begin(), files.end());
        }
    }
}

TEST(CaseLines, AMissingShardIsNoticed) {
    const std::vector<CaseFile> files = {{"a", MakeLines({.index = 1, .count = 3})},
                                         {"c", MakeLines({.index = 3, .count = 3})}};
    EXPECT_EQ(MergeCaseLines(files).missing, (std::vector<std::size_t>{1, 4, 7, 10, 13, 16, 19, 22}));
}

TEST(CaseLines, WrongFilesAreNamedWithTheirLine) {
    const CaseFile first{"a.jsonl", MakeLines({.index = 1, .count = 2})};
    EXPECT_NE(MessageOf({first, {"b.jsonl", first.text}}).find("b.jsonl:1: case 0 is also in a.jsonl"),
              std::string::npos);
    EXPECT_NE(
        MessageOf({first, {"b.jsonl", MakeLines({.index = 2, .count = 2}, "snapshot check")}}).find("another run"),
        std::string::npos);
    EXPECT_NE(MessageOf({first, {"b.jsonl", MakeLines({.index = 2, .count = 2}, "bench", 24)}}).find("another run"),
              std::string::npos);
    EXPECT_TRUE(MessageOf({first, {"b.jsonl", "{\"command\": \"bench\"\n"}}).starts_with("b.jsonl:1: not a line"));
    // A run of one case, whose lines are twice in one file.
    const std::string one = R"({"command":"bench","case":0,"cases":1,"engine":"scree","ms":1.5})";
    const std::string other = R"({"command":"bench","case":0,"cases":1,"engine":"box2d","ms":1.5})";
    const std::string again = R"({"command":"bench","case":0,"cases":1,"engine":"scree","ms":1.25})";
    EXPECT_EQ(MessageOf({{"b.jsonl", one + "\n" + other + "\n"}}), "no error");
    EXPECT_NE(MessageOf({{"b.jsonl", one + "\n" + other + "\n" + again + "\n"}})
                  .find("b.jsonl:3: case 0 is in this file twice"),
              std::string::npos);
    EXPECT_TRUE(MessageOf({{"b.jsonl", R"({"command":"bench","case":9,"cases":9})"}}).starts_with("b.jsonl:1: case 9"));
}

TEST(CaseLines, AWholeRunIsReadAndNothingLess) {
    const ScratchFolder folder;
    const auto path = folder.GetPath() / "lines.jsonl";
    const auto messageOf = [&](const std::string& text) -> std::string {
        WriteTextFile(path, text);
        try {
            EXPECT_EQ(ReadCaseText(path, "bench").text, text);
        } catch (const FileError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(messageOf(MakeLines({})), "");
    EXPECT_NE(messageOf(MakeLines({.index = 1, .count = 2})).find("11 of 23 cases are missing"), std::string::npos);
    EXPECT_NE(messageOf(MakeLines({}, "extremes")).find("of `scree extremes`, not of `scree bench`"),
              std::string::npos);
    EXPECT_NE(messageOf("").find("no line in it"), std::string::npos);
    EXPECT_NE(messageOf(MakeLines({}) + MakeLines({})).find("lines.jsonl:25: case 0 is in this file twice"),
              std::string::npos);
    EXPECT_THROW((void)ReadCaseText(folder.GetPath() / "none.jsonl", "bench"), FileError);
}

TEST(CaseLines, LinesOfAnotherBuildAreRefusedAndOtherMachinesNamed) {
    const auto make = [](const Shard& shard, const std::string& commit, const std::string& processor) {
        CaseLines lines("bench", caseCount, {{"processor", processor}, {"commit", commit}});
        for (std::size_t number = 0; number < caseCount; ++number) {
            if (shard.Contains(number)) lines.Add(number, {{"value", number}});
        }
        return lines.GetText();
    };
    const CaseFile first{"a.jsonl", make({.index = 1, .count = 2}, "abc", "fast")};
    const MergedLines merged =
        MergeCaseLines(std::vector<CaseFile>{first, {"b.jsonl", make({.index = 2, .count = 2}, "abc", "slow")}});
    ASSERT_EQ(merged.made.size(), 2u);
    EXPECT_EQ(merged.made[1]["processor"], "slow");
    const std::string message = MessageOf({first, {"b.jsonl", make({.index = 2, .count = 2}, "def", "fast")}});
    EXPECT_NE(message.find("b.jsonl:1: of another build: commit \"def\", before it \"abc\""), std::string::npos)
        << message;
}

TEST(CaseLines, AStoppedRunIsTakenOver) {
    const ScratchFolder folder;
    const auto file = folder.GetPath() / "lines.jsonl", part = folder.GetPath() / "lines.jsonl.part";
    const nlohmann::ordered_json made = {{"commit", "abc"}}, other = {{"commit", "def"}};
    {
        CaseLines stopped("bench", 4, made);
        stopped.Keep(file, false);
        stopped.Add(0, {{"value", 0}});
        stopped.Add(0, {{"value", "second line"}});
        stopped.Add(2, {{"value", 2}});
        stopped.Add(1, {{"value", 1}});  // under way when the run was stopped
    }
    EXPECT_FALSE(folder.Has("lines.jsonl"));
    std::ofstream(part, std::ios::app) << "{\"command\": \"ben";  // half a line
    EXPECT_THROW(CaseLines("bench", 5, made).Keep(file, true), FileError);
    EXPECT_THROW(CaseLines("extremes", 4, made).Keep(file, true), FileError);
    EXPECT_THROW(CaseLines("bench", 4, other).Keep(file, true), FileError);
    CaseLines lines("bench", 4, made);
    lines.Keep(file, true);
    EXPECT_TRUE(lines.Has(0) && lines.Has(2));
    EXPECT_FALSE(lines.Has(1) || lines.Has(3));
    for (const std::size_t number : {3u, 1u}) lines.Add(number, {{"value", number}});
    lines.Finish();
    EXPECT_FALSE(std::filesystem::exists(part));
    CaseLines whole("bench", 4, made);
    whole.Add(0, {{"value", 0}});
    whole.Add(0, {{"value", "second line"}});
    for (const std::size_t number : {1u, 2u, 3u}) whole.Add(number, {{"value", number}});
    EXPECT_EQ(folder.Read("lines.jsonl"), whole.GetText());
}

TEST(Shard, PartsOfNHaveEveryCaseOnce) {
    for (int count = 1; count < 9; ++count) {
        for (std::size_t number = 0; number < 50; ++number) {
            int owners = 0;
            for (int index = 1; index <= count; ++index) owners += Shard{index, count}.Contains(number);
            EXPECT_EQ(owners, 1);
        }
    }
}

TEST(Shard, OnlyIOfNIsRead) {
    const Shard shard = ParseShard("3/12");
    EXPECT_EQ(shard.index, 3);
    EXPECT_EQ(shard.count, 12);
    for (const char* text : {"", "1", "0/2", "3/2", "1/0", "1/2/3", "a/2", "1/b", "-1/2", "1/100001", " 1/2", "1/2 "}) {
        EXPECT_THROW((void)ParseShard(text), UsageError) << text;
    }
}

}  // namespace
}  // namespace testbed
