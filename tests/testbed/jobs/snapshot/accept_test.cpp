// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `snapshot accept`, `snapshot merge` and `--state` as programs. What a check left becomes the references that an
// update would have made. A foreign or stale artifact changes nothing, and reports of shards become one.

#include "testbed/jobs/snapshot/accept.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/base/text.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Every file below a folder with its bytes.
std::map<std::string, std::string> ReadFolder(const ScratchFolder& scratch, const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const std::string& file : FilesBelow(scratch.GetPath() / folder)) {
        files[file] = scratch.Read(fs::path(folder) / file);
    }
    return files;
}

/// References `r` of one scene that are up to date, and in `wanted` a copy of them.
class SnapshotAccept : public testing::Test {
protected:
    SnapshotAccept() {
        const ProgramResult result = m_scratch.Run("snapshot update --references r -g '^joint-gear/'");
        EXPECT_EQ(result.exitCode, exitDone) << result.output;
        fs::copy(m_scratch.GetPath() / "r", m_scratch.GetPath() / "wanted", fs::copy_options::recursive);
        for (const auto& [file, bytes] : ReadFolder(m_scratch, "r")) {
            if (file.ends_with(".png")) m_ids.push_back(file.substr(0, file.size() - 4));
        }
    }

    [[nodiscard]] fs::path File(const std::string& id, const char* extension, const char* folder = "r") const {
        return m_scratch.GetPath() / folder / (id + extension);
    }
    void ChangePixel(const std::string& id) const {
        Image image = ReadPng(File(id, ".png"));
        image.At(100, 100).r ^= 1;
        WritePng(File(id, ".png"), image);
    }
    void Forget(const std::string& id) const {
        fs::remove(File(id, ".png"));
        fs::remove(File(id, ".json"));
    }
    void ChangeJson(const fs::path& file, const std::function<void(Json&)>& change) const {
        Json json = Json::parse(std::ifstream(file));
        change(json);
        std::ofstream(file) << json;
    }
    /// Another state below equal pixels, as a last bit that changed would make it.
    void ChangeState(const std::string& id) const {
        ChangeJson(File(id, ".json"), [](Json& sidecar) { sidecar["state_hash"] = "0123456789abcdef"; });
    }
    [[nodiscard]] ProgramResult Check(const std::string& options = "") const {
        return m_scratch.Run("snapshot check --references r -g '^joint-gear/' " + options);
    }
    [[nodiscard]] ProgramResult Accept(const std::string& options = "out/snapshots") const {
        return m_scratch.Run("snapshot accept --references r " + options);
    }
    /// Accepting is refused with `words`, and no reference changes.
    void ExpectRefused(const std::string& words, int exitCode = exitIo,
                       const std::string& options = "out/snapshots") const {
        const auto before = ReadFolder(m_scratch, "r");
        const ProgramResult result = Accept(options);
        EXPECT_EQ(result.exitCode, exitCode) << result.output;
        EXPECT_NE(result.output.find(words), std::string::npos) << words << " is not in\n" << result.output;
        EXPECT_EQ(ReadFolder(m_scratch, "r"), before) << words;
    }
    [[nodiscard]] bool IsAsWanted() const { return ReadFolder(m_scratch, "r") == ReadFolder(m_scratch, "wanted"); }

    ScratchFolder m_scratch;
    std::vector<std::string> m_ids;
};

TEST_F(SnapshotAccept, WritesTheBytesThatAnUpdateWrites) {
    ChangePixel(m_ids[0]);
    Forget(m_ids[1]);
    fs::remove(File(m_ids[2], ".json"));
    ChangeState(m_ids[3]);
    std::ofstream(File(m_ids[4], ".png")) << "no picture";
    std::ofstream(File("joint-gear/step-9999-gone", ".json")) << "{}";
    EXPECT_EQ(Check().exitCode, exitDiffers);
    const ProgramResult result = Accept();
    EXPECT_EQ(result.exitCode, exitDone) << result.output;
    EXPECT_NE(result.output.find("5 written, 1 removed, 0 already"), std::string::npos) << result.output;
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NE(result.output.find("written  " + m_ids[i] + "\n"), std::string::npos) << result.output;
    }
    EXPECT_NE(result.output.find("removed  joint-gear/step-9999-gone\n"), std::string::npos) << result.output;
    EXPECT_TRUE(IsAsWanted());
    EXPECT_EQ(Check("--state exact").exitCode, exitDone);

    const ProgramResult again = Accept();
    EXPECT_EQ(again.exitCode, exitDone) << again.output;
    EXPECT_NE(again.output.find("0 written, 0 removed, 6 already"), std::string::npos) << again.output;
    EXPECT_TRUE(IsAsWanted());
}

TEST_F(SnapshotAccept, ThePrintedLineAcceptsAllAlsoFromACopy) {
    ChangePixel(m_ids[0]);
    const ProgramResult check = Check("--report 'a report'");
    for (const std::string action : {"accept", "update"}) {
        const std::string mark = action == "accept" ? "to accept all that is in the report: testbed/run "
                                                    : "to make all again and accept them: testbed/run ";
        const std::size_t at = check.output.find(mark);
        ASSERT_NE(at, std::string::npos) << check.output;
        const std::size_t begin = at + mark.size();
        const ProgramResult result = m_scratch.Run(check.output.substr(begin, check.output.find('\n', begin) - begin));
        EXPECT_EQ(result.exitCode, exitDone) << result.output;
        EXPECT_NE(result.output.find("written  " + m_ids[0]), std::string::npos) << result.output;
        EXPECT_TRUE(IsAsWanted());
        ChangePixel(m_ids[0]);
    }
    // What CI kept, below another folder and beside other files.
    fs::create_directories(m_scratch.GetPath() / "artifact/out");
    fs::rename(m_scratch.GetPath() / "a report", m_scratch.GetPath() / "artifact/out/snapshots");
    std::ofstream(m_scratch.GetPath() / "artifact/results.txt") << "another file";
    EXPECT_EQ(Accept("artifact").exitCode, exitDone);
    EXPECT_TRUE(IsAsWanted());
}

TEST_F(SnapshotAccept, TakesOnlyWhatTheFilterAndTheModeName) {
    ChangePixel(m_ids[0]);
    ChangePixel(m_ids[1]);
    Forget(m_ids[2]);
    EXPECT_EQ(Check().exitCode, exitDiffers);
    EXPECT_EQ(Accept("out/snapshots -g '^" + m_ids[0] + "$'").exitCode, exitDone);
    EXPECT_FALSE(IsAsWanted());
    EXPECT_EQ(m_scratch.Read("r/" + m_ids[0] + ".png"), m_scratch.Read("wanted/" + m_ids[0] + ".png"));
    EXPECT_NE(m_scratch.Read("r/" + m_ids[1] + ".png"), m_scratch.Read("wanted/" + m_ids[1] + ".png"));
    const ProgramResult missing = Accept("out/snapshots --update missing");
    EXPECT_EQ(missing.exitCode, exitDiffers) << missing.output;
    EXPECT_NE(missing.output.find("written  " + m_ids[2]), std::string::npos) << missing.output;
    EXPECT_NE(missing.output.find("left     " + m_ids[1] + ", changed"), std::string::npos) << missing.output;
    ExpectRefused("-g nothing: no case of the artifact matches", exitUsage, "out/snapshots -g nothing");
    EXPECT_EQ(Accept().exitCode, exitDone);
    EXPECT_TRUE(IsAsWanted());
}

TEST_F(SnapshotAccept, KeepsTheRuleOfASidecar) {
    ChangePixel(m_ids[0]);
    EXPECT_EQ(Check().exitCode, exitDiffers);
    const Json rule = {{"tolerance", 3}, {"reason", "a test"}};
    ChangeJson(File(m_ids[0], ".json"), [&](Json& sidecar) { sidecar["compare"] = rule; });
    EXPECT_EQ(Accept().exitCode, exitDone);
    EXPECT_EQ(Json::parse(m_scratch.Read("r/" + m_ids[0] + ".json"))["compare"], rule);
}

TEST_F(SnapshotAccept, RefusesWhatDoesNotBelongAndChangesNothing) {
    ChangePixel(m_ids[0]);
    ChangePixel(m_ids[1]);
    EXPECT_EQ(Check().exitCode, exitDiffers);
    const fs::path report = m_scratch.GetPath() / "out/snapshots", kept = m_scratch.GetPath() / "kept";
    fs::copy(report, kept, fs::copy_options::recursive);
    // The second case is wrong: the first one must stay as it is, too.
    const fs::path actual = report / "actual" / (m_ids[1] + ".json");
    const auto expectRefused = [&](const std::string& words, const std::function<void()>& change) {
        change();
        ExpectRefused(words);
        fs::remove_all(report);
        fs::copy(kept, report, fs::copy_options::recursive);
    };
    const auto set = [&](const char* key, const Json& value) {
        return [&, key, value] { ChangeJson(actual, [&](Json& sidecar) { sidecar[key] = value; }); };
    };
    expectRefused("made with step 3, but this case has", set("step", 3));
    expectRefused("made with settings \"solver=soft@4\", but", set("settings", "solver=soft@4"));
    expectRefused("it has no state hash", set("state_hash", "no hash"));
    expectRefused("its structure is damaged", set("structure", Json::object()));
    expectRefused("has 64x64 pixels, this case has 480x300", [&] {
        WritePng(report / "actual" / (m_ids[1] + ".png"), Image(64, 64, Color{1, 2, 3, 255}));
    });
    expectRefused("actual/" + m_ids[1] + ".png is not there",
                  [&] { fs::remove(report / "actual" / (m_ids[1] + ".png")); });
    expectRefused("is not a PNG picture",
                  [&] { std::ofstream(report / "actual" / (m_ids[1] + ".png")) << "no picture"; });
    const auto setResult = [&](const char* key, const Json& value) {
        return [&, key, value] {
            ChangeJson(report / "results.json", [&](Json& json) {
                for (Json& result : json["results"]) {
                    if (result["id"] == m_ids[1]) result[key] = value;
                }
            });
        };
    };
    expectRefused("there is no snapshot joint-gear/step-0001-new here", [&] {
        const std::string id = "joint-gear/step-0001-new", stem = "actual/" + id;
        setResult("actual", {{"image", stem + ".png"}, {"sidecar", stem + ".json"}, {"width", 480}, {"height", 300}})();
        setResult("expected", nullptr)();
        setResult("difference", nullptr)();
        setResult("id", id)();
    });
    expectRefused("'../x' cannot be the name of a case", setResult("id", "../x"));
    expectRefused("belongs to no snapshot there, but to one here", setResult("status", "orphan"));
    expectRefused("unknown status 'odd'", setResult("status", "odd"));
    expectRefused("not a JSON object",
                  [&] { std::ofstream(report / "results.json") << R"({"command": "scree snapshot check")"; });
    EXPECT_EQ(Accept().exitCode, exitDone);
    EXPECT_TRUE(IsAsWanted());
}

TEST_F(SnapshotAccept, RefusesAStaleArtifact) {
    ChangePixel(m_ids[0]);
    ChangePixel(m_ids[1]);
    EXPECT_EQ(Check().exitCode, exitDiffers);
    Image image = ReadPng(File(m_ids[1], ".png"));
    image.At(7, 7).g ^= 1;
    WritePng(File(m_ids[1], ".png"), image);
    ExpectRefused("the reference " + m_ids[1] + " is not the one that the check saw");
    EXPECT_EQ(Accept("out/snapshots -g '^" + m_ids[0] + "$'").exitCode, exitDone);
}

TEST_F(SnapshotAccept, RefusesPicturesMadeInAnotherWay) {
    const ProgramResult check = Check("--set iterations=1/1");
    EXPECT_EQ(check.exitCode, exitDiffers);
    EXPECT_EQ(check.output.find("to accept"), std::string::npos) << check.output;
    ExpectRefused("without --set");
}

TEST_F(SnapshotAccept, RefusesWhatIsNoReport) {
    std::ofstream(m_scratch.GetPath() / "snapshots.zip") << "PK";
    ExpectRefused("unpack it (unzip snapshots.zip -d snapshots)", exitUsage, "snapshots.zip");
    ExpectRefused("there is no such folder", exitIo, "nowhere");
    ExpectRefused("no report of `scree snapshot check` is in it or below it", exitUsage, "wanted");
    ExpectRefused("give the folder that `snapshot check` wrote its report to", exitUsage, "");
    ExpectRefused("snapshot accept takes no --set", exitUsage, "wanted --set iterations=1/1");
    ExpectRefused("snapshot accept takes no --state", exitUsage, "wanted --state exact");
    EXPECT_EQ(m_scratch.Run("diff r/joint-gear wanted/joint-gear -o out/diff").exitCode, exitDone);
    ExpectRefused("not of `scree snapshot check`", exitUsage, "out/diff");
}

// The sidecar of a reference is larger than two blocks. What fails, fails before the first name is taken.
TEST_F(SnapshotAccept, AWriteThatFailsChangesNothing) {
    ChangePixel(m_ids[0]);
    ChangePixel(m_ids[1]);
    EXPECT_EQ(Check().exitCode, exitDiffers);
    const auto before = ReadFolder(m_scratch, "r");
    const ProgramResult result = m_scratch.RunOnFullDisk("snapshot accept --references r out/snapshots", 2);
    EXPECT_EQ(result.exitCode, exitIo) << result.output;
    EXPECT_NE(result.output.find("File too large"), std::string::npos) << result.output;
    EXPECT_EQ(ReadFolder(m_scratch, "r"), before);
}

TEST_F(SnapshotAccept, StateExactFailsForABitThatNoPixelShows) {
    EXPECT_EQ(Check("--state exact").exitCode, exitDone);
    ChangeState(m_ids[0]);
    const ProgramResult close = Check("--state close");
    EXPECT_EQ(close.exitCode, exitDone) << close.output;
    EXPECT_NE(close.output.find("1 equal in their pixels alone"), std::string::npos) << close.output;
    EXPECT_EQ(Check().exitCode, exitDone) << "close is the default";
    const ProgramResult exact = Check("--state exact --junit j.xml");
    EXPECT_EQ(exact.exitCode, exitDiffers) << exact.output;
    EXPECT_NE(exact.output.find("state    " + m_ids[0] + ": no pixel differs; the state hash is \""), std::string::npos)
        << exact.output;
    EXPECT_NE(exact.output.find("the reference has \"0123456789abcdef\""), std::string::npos) << exact.output;
    EXPECT_NE(m_scratch.Read("j.xml").find("<failure type=\"state\""), std::string::npos);
    EXPECT_EQ(Json::parse(m_scratch.Read("out/snapshots/results.json"))["counts"]["state"], 1);
    EXPECT_EQ(Accept().exitCode, exitDone);
    EXPECT_TRUE(IsAsWanted());
    const ProgramResult unknown = Check("--state near");
    EXPECT_EQ(unknown.exitCode, exitUsage) << unknown.output;
}

TEST_F(SnapshotAccept, ReportsOfShardsBecomeTheReportOfTheWhole) {
    // Two groups of settings at least, so that each shard has cases.
    for (const std::string& id : m_ids) ChangePixel(id);
    EXPECT_EQ(Check("--report whole").exitCode, exitDiffers);
    EXPECT_EQ(Check("--report parts/1 --shard 1/2").exitCode, exitDiffers);
    EXPECT_EQ(Check("--report parts/2 --shard 2/2").exitCode, exitDiffers);
    const ProgramResult merge = m_scratch.Run("snapshot merge parts/2 parts/1 --report joined --junit joined.xml");
    EXPECT_EQ(merge.exitCode, exitDiffers) << merge.output;
    const auto withoutTimes = [&](const char* folder) {
        Json json = Json::parse(m_scratch.Read(fs::path(folder) / "results.json"));
        for (Json& result : json["results"]) result.erase("ms");
        return json;
    };
    EXPECT_EQ(withoutTimes("joined"), withoutTimes("whole"));
    EXPECT_GT(withoutTimes("whole")["results"].size(), withoutTimes("parts/1")["results"].size());
    auto whole = ReadFolder(m_scratch, "whole"), joined = ReadFolder(m_scratch, "joined");
    const std::string page = joined["index.html"];
    for (const std::string& id : m_ids) EXPECT_NE(page.find("\"id\":\"" + id + "\""), std::string::npos) << id;
    for (const char* file : {"index.html", "results.json"}) {
        whole.erase(file);
        joined.erase(file);
    }
    EXPECT_EQ(joined, whole);
    const std::string junit = m_scratch.Read("joined.xml");
    EXPECT_NE(junit.find("failures=\"" + std::to_string(m_ids.size()) + "\""), std::string::npos) << junit;

    // Both parts below one folder; also to be accepted from.
    EXPECT_EQ(m_scratch.Run("snapshot merge parts --report again").exitCode, exitDiffers);
    EXPECT_EQ(withoutTimes("again"), withoutTimes("whole"));
    EXPECT_EQ(Accept("parts/1 parts/2").exitCode, exitDone);
    EXPECT_TRUE(IsAsWanted());
    EXPECT_EQ(Accept("joined").exitCode, exitDone);
}

TEST_F(SnapshotAccept, MergeNamesWhatIsMissingAndRefusesWhatIsNoRun) {
    EXPECT_EQ(Check("--report 1 --shard 1/2").exitCode, exitDone);
    EXPECT_EQ(Check("--report 2 --shard 2/2").exitCode, exitDone);
    EXPECT_EQ(m_scratch.Run("snapshot merge 1 2 --report joined").exitCode, exitDone);
    const ProgramResult half = m_scratch.Run("snapshot merge 1 --report joined");
    EXPECT_EQ(half.exitCode, exitDiffers) << half.output;
    EXPECT_NE(half.output.find("did every shard finish?"), std::string::npos) << half.output;
    const ProgramResult twice = m_scratch.Run("snapshot merge 1 1 --report joined");
    EXPECT_EQ(twice.exitCode, exitIo) << twice.output;
    EXPECT_EQ(m_scratch.Run("snapshot check --references r -g '^joint-weld/' --report other").exitCode, exitDiffers);
    const ProgramResult other = m_scratch.Run("snapshot merge 1 other --report joined");
    EXPECT_EQ(other.exitCode, exitIo) << other.output;
    EXPECT_NE(other.output.find("give the reports of one run"), std::string::npos) << other.output;
    for (const char* report : {"1", "."}) {  // a new report removes what is in its folder
        const ProgramResult own = m_scratch.Run(std::string("snapshot merge 1 2 --report ") + report);
        EXPECT_EQ(own.exitCode, exitUsage) << own.output;
        EXPECT_TRUE(m_scratch.Has("1/results.json"));
    }
}

}  // namespace
}  // namespace testbed
