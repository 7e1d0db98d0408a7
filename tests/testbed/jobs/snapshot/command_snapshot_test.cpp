// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree snapshot`, `diff` and `merge` as programs: exit codes, files, and shards under GNU parallel.

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

using Json = nlohmann::ordered_json;

/// The lines without their wall times.
std::string WithoutTimes(const std::string& text) {
    std::istringstream stream(text);
    std::string line, result;
    while (std::getline(stream, line)) {
        Json object = Json::parse(line);
        EXPECT_TRUE(object.contains("ms")) << line;
        object.erase("ms");
        result += object.dump() + "\n";
    }
    return result;
}

TEST(SnapshotProgram, CheckPrintsTheCommandThatThenMakesItClean) {
    const ScratchFolder scratch;
    const std::string check = "snapshot check --backend cpu --references r -g '^joint-gear/'";
    const ProgramResult missing = scratch.Run(check + " --annotations --junit j.xml");
    EXPECT_EQ(missing.exitCode, exitDiffers) << missing.output;
    EXPECT_NE(missing.output.find("::error file=r/joint-gear/"), std::string::npos) << missing.output;
    EXPECT_TRUE(scratch.Has("out/snapshots/results.json"));
    EXPECT_NE(scratch.Read("j.xml").find("type=\"missing\""), std::string::npos);

    // Every printed command.
    std::istringstream lines(missing.output);
    const std::string mark = "to accept: testbed/run ";
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(mark);
        if (at == std::string::npos || line.starts_with("::error")) continue;
        const ProgramResult update = scratch.Run(line.substr(at + mark.size()) + " --backend cpu");
        EXPECT_EQ(update.exitCode, exitDone) << update.output;
        ++count;
    }
    EXPECT_GT(count, 0) << missing.output;
    const ProgramResult clean = scratch.Run(check);
    EXPECT_EQ(clean.exitCode, exitDone) << clean.output;
}

TEST(SnapshotProgram, TwoShardsUnderGnuParallelGiveTheUnshardedResult) {
    ASSERT_EQ(std::system("command -v parallel >/dev/null"), 0) << "GNU parallel is missing: apt install parallel";
    const ScratchFolder scratch;
    const std::string check = "snapshot check --backend cpu --references r -g '^joint-[fg]|^p|^sensors/'";
    ASSERT_EQ(scratch.Run("snapshot update --backend cpu --references r -g '^p|^sensors/'").exitCode, exitDone);
    const ProgramResult whole = scratch.Run(check + " --json whole.jsonl --report whole");
    EXPECT_EQ(whole.exitCode, exitDiffers) << whole.output;  // the joints have no references

    // parallel takes its command as one text, so the inner quotes must survive.
    const ProgramResult shards = scratch.Run(
        "snapshot check --backend cpu --references r -g \"'^joint-[fg]|^p|^sensors/'\" --shard {}/2 --json {}.jsonl "
        "--report whole-{} ::: 1 2",
        "parallel --will-cite --jobs 2");
    EXPECT_NE(shards.exitCode, exitDone) << shards.output;
    ASSERT_TRUE(scratch.Has("1.jsonl") && scratch.Has("2.jsonl")) << shards.output;
    const ProgramResult merge = scratch.Run("merge 2.jsonl 1.jsonl -o merged.jsonl");
    EXPECT_EQ(merge.exitCode, exitDone) << merge.output;
    const std::string expected = WithoutTimes(scratch.Read("whole.jsonl"));
    EXPECT_EQ(WithoutTimes(scratch.Read("merged.jsonl")), expected);
    EXPECT_NE(expected.find("missing"), std::string::npos);
    EXPECT_NE(scratch.Read("1.jsonl"), scratch.Read("2.jsonl"));

    const ProgramResult half = scratch.Run("merge 1.jsonl");
    EXPECT_EQ(half.exitCode, exitDiffers) << half.output;
    EXPECT_NE(half.output.find("did every shard finish?"), std::string::npos) << half.output;
    EXPECT_EQ(scratch.Run("merge 1.jsonl none.jsonl").exitCode, exitIo);
}

TEST(SnapshotProgram, VerifyFindsAllBackendsAndThreadsEqual) {
    const ScratchFolder scratch;
    const ProgramResult verify =
        scratch.Run("snapshot verify --skip-missing-backend -g '^(pyramid|joint-wheel)/' --json v.jsonl");
    EXPECT_EQ(verify.exitCode, exitDone) << verify.output;
    EXPECT_NE(verify.output.find("all equal"), std::string::npos) << verify.output;
    EXPECT_NE(scratch.Read("v.jsonl").find("\"status\":\"equal\""), std::string::npos);
}

TEST(SnapshotProgram, RefusesWhatCannotBeMeant) {
    const ScratchFolder scratch;
    for (const char* arguments : {"snapshot", "snapshot chek", "snapshot check --shard 3/2", "snapshot check -g '('",
                                  "snapshot check -g nothing-like-this", "snapshot update --update some",
                                  "snapshot list --junit x.xml", "snapshot check --backend gpu"}) {
        const ProgramResult result = scratch.Run(arguments);
        EXPECT_EQ(result.exitCode, exitUsage) << arguments << "\n" << result.output;
    }
    EXPECT_NE(scratch.Run("snapshot chek").output.find("did you mean 'check'"), std::string::npos);
    EXPECT_EQ(scratch.Run("snapshot check --references r -g '^car/' --report /proc/none").exitCode, exitIo);
}

TEST(DiffProgram, TellsEqualChangedNewDeletedAndSize) {
    const ScratchFolder scratch;
    const auto& root = scratch.GetPath();
    for (const char* name : {"a", "b"}) std::filesystem::create_directories(root / name / "sub");
    Image image(40, 30, Color{9, 9, 9, 255});
    WritePng(root / "a/sub/same.png", image);
    WritePng(root / "b/sub/same.png", image);
    EXPECT_EQ(scratch.Run("diff a b").exitCode, exitDone);
    WritePng(root / "a/sub/changed.png", image);
    WritePng(root / "a/gone.png", image);
    WritePng(root / "a/size.png", image);
    WritePng(root / "b/size.png", Image(41, 30, Color{9, 9, 9, 255}));
    WritePng(root / "b/more.png", image);
    image.At(7, 8).b = 12;
    WritePng(root / "b/sub/changed.png", image);
    const ProgramResult result = scratch.Run("diff a b -o d");
    EXPECT_EQ(result.exitCode, exitDiffers);
    const Json counts = Json::parse(scratch.Read("d/results.json"))["counts"];
    for (const char* status : {"equal", "changed", "size", "new", "deleted"}) EXPECT_EQ(counts[status], 1) << status;
    EXPECT_TRUE(scratch.Has("d/diff/sub/changed.png") && scratch.Has("d/actual/more.png"));
    EXPECT_NE(result.output.find("1 pixel differs by up to 3, in x 7..7, y 8..8"), std::string::npos) << result.output;
    EXPECT_EQ(scratch.Run("diff a/sub/changed.png b/sub/changed.png").exitCode, exitDiffers);
    EXPECT_EQ(scratch.Run("diff a/sub/changed.png b/sub/changed.png --tolerance 3").exitCode, exitDone);
    EXPECT_EQ(scratch.Run("diff a/sub/changed.png b/sub/changed.png --tolerance 2").exitCode, exitDiffers);
    EXPECT_EQ(scratch.Run("diff a b/more.png").exitCode, exitUsage);
    EXPECT_EQ(scratch.Run("diff a nowhere").exitCode, exitIo);
}

TEST(DiffProgram, TakesNamesThatAreNoUtf8) {
    const ScratchFolder scratch;
    Image image(8, 8, Color{9, 9, 9, 255});
    WritePng(scratch.GetPath() / "name-\xe9.png", image);
    image.At(7, 7).b = 12;
    WritePng(scratch.GetPath() / "b.png", image);
    const ProgramResult result = scratch.Run("diff name-*.png b.png -o d");
    EXPECT_EQ(result.exitCode, exitDiffers) << result.output;
    EXPECT_EQ(Json::parse(scratch.Read("d/results.json"))["counts"]["changed"], 1);
    EXPECT_TRUE(scratch.Has("d/index.html"));
}

}  // namespace
}  // namespace testbed
