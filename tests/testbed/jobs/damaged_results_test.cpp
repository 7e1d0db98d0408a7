// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Damaged files that the program wrote itself and reads again: lines of results, reports of snapshots, sidecars of
// references, and the list of pictures in a folder of scenes. Each ends in what can be used, or in an error that names
// the file.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/json_lines.h"
#include "testbed/jobs/bench/row.h"
#include "testbed/jobs/extremes/report.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/jobs/snapshot/result.h"
#include "testbed/jobs/snapshot/scene_folder.h"
#include "testbed/jobs/tradeoff/trade.h"
#include "tests/testbed/input/damage.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

/// A sound text, and what reads it.
struct Sample {
    std::string name;  ///< of the file, which messages begin with
    std::string text;
    std::function<void(const std::string& text)> read;
};

class DamagedResults : public testing::Test {
protected:
    /// Reads as many damaged ones of each.
    void ReadDamaged(const std::vector<Sample>& samples, int usual) const {
        const int count = CountOfMutations(usual) * static_cast<int>(samples.size());
        std::mt19937 random(31);
        int refused = 0;
        for (const Sample& sample : samples) {
            ASSERT_FALSE(sample.text.empty()) << sample.name;
            ASSERT_NO_THROW(sample.read(sample.text)) << sample.name;
        }
        for (int i = 0; i < count; ++i) {
            const Sample& sample = samples[static_cast<std::size_t>(i) % samples.size()];
            std::string text = sample.text;
            Damage(text, random, 2, [&](std::string& whole, std::size_t at) { ReplaceValue(whole, at, random); });
            try {
                sample.read(text);
            } catch (const FileError& error) {
                ++refused;
                ASSERT_NE(std::string(error.what()).find(sample.name), std::string::npos) << error.what();
            }
        }
        EXPECT_GT(refused, count / 3);
        RecordMutations(count, refused);
    }
    /// A value of JSON becomes another one.
    static void ReplaceValue(std::string& text, std::size_t at, std::mt19937& random) {
        static const std::vector<std::string> hostile{"1e308", "-1e39", "99999999999999999999", "null", "{}",
                                                      "[]",    "\"\"",  "\"\\u0000\"",          "-1",   "true",
                                                      "0.5",   "[[[[",  "2147483648",           "\xff", "[1,2]"};
        const std::size_t colon = text.find(':', at);
        if (colon == std::string::npos) return;
        const std::size_t end = text.find_first_of(",}]\n", colon);
        text.replace(colon + 1, end == std::string::npos ? end : end - colon - 1,
                     hostile[Below(hostile.size(), random)]);
    }
    void Make(const std::string& arguments, int exitCode = exitDone) const {
        const ProgramResult result = folder.Run(arguments);
        ASSERT_EQ(result.exitCode, exitCode) << result.output;
    }
    /// A reader of files gets the text as one.
    [[nodiscard]] std::function<void(const std::string&)> FromFile(
        const std::string& name, std::function<void(const std::filesystem::path&)> read) const {
        const std::filesystem::path file = folder.GetPath() / name;
        return [file, read = std::move(read)](const std::string& text) {
            std::ofstream(file, std::ios::binary) << text;
            read(file);
        };
    }

    ScratchFolder folder;
};

TEST_F(DamagedResults, DamagedLinesOfResultsEndInAnErrorOrInRows) {
    Make("bench n2 --sizes 5 --steps 2 --engines scree,box2d --json bench.json");
    Make("extremes --quick -g '^dt-1-30$' --engines scree --json extremes.json -o e");
    Make("tradeoff --quick -g '^free-spin$' --engines scree --json tradeoff.json -o t");
    ReadDamaged({{"bench.json", folder.Read("bench.json"),
                  [](const std::string& text) { (void)ReadBenchRows("bench.json", text); }},
                 {"extremes.json", folder.Read("extremes.json"),
                  [](const std::string& text) {
                      ParseJsonLines("extremes.json", text, "extremes",
                                     [](const auto& fields) { (void)ExtremeResultFromJson(fields); });
                  }},
                 {"tradeoff.json", folder.Read("tradeoff.json"),
                  [](const std::string& text) {
                      ParseJsonLines("tradeoff.json", text, "tradeoff",
                                     [](const auto& fields) { (void)TradeCaseFromJson(fields); });
                  }}},
                1000);
}

TEST_F(DamagedResults, DamagedFilesOfSnapshotsEndInAnErrorOrInCases) {
    std::filesystem::copy(SCREE_SOURCE_DIR "/tests/own_repository/levels", folder.GetPath() / "levels",
                          std::filesystem::copy_options::recursive);
    Make("snapshot check --scenes levels --report report");
    const std::string id = "tower/step-0120-render";
    ReadDamaged(
        {{"results.json", folder.Read("report/results.json"),
          FromFile("report/results.json", [](const auto& file) { (void)ReadResults(file); })},
         {"step-0120-render.json", folder.Read("levels/references/" + id + ".json"),
          FromFile("levels/references/" + id + ".json",
                   [&](const auto&) { (void)ReadReference(folder.GetPath() / "levels/references", id); })},
         {"snapshots.json", folder.Read("levels/snapshots.json"),
          FromFile("levels/snapshots.json", [](const auto& file) { (void)ReadSceneFolder(file.parent_path()); })}},
        500);
}

}  // namespace
}  // namespace testbed
