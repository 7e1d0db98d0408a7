// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A wrong command line ends with exit code 2 and one line that names the cure. A folder that cannot be written ends
// with 4 and a missing backend with 3 (or 77). All end before anything is simulated.

#include <gtest/gtest.h>

#include <algorithm>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/cli/command_line.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

struct UsageCase {
    const char* arguments;
    const char* mention;  ///< must stand in the message
};

void PrintTo(const UsageCase& usage, std::ostream* stream) { *stream << "scree " << usage.arguments; }

class WrongUsage : public testing::TestWithParam<UsageCase> {};

TEST_P(WrongUsage, ExitsWithTwoAndNamesTheCure) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run(GetParam().arguments);
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_NE(result.output.find(GetParam().mention), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("scree: "), 0u) << result.output;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
    EXPECT_TRUE(std::filesystem::is_empty(folder.GetPath())) << "nothing may be written";
}

constexpr UsageCase usageCases[] = {
    {"overlap tils", "did you mean 'tiles'"},
    {"render add-pair-40", "did you mean 'add-pair-400'"},
    {"overlpa tiles", "did you mean 'overlap'"},
    {"overlap tiles --siez 20", "did you mean '--size'"},
    {"overlap tiles --brod-phase=keys", "did you mean '--broad-phase'"},
    {"--verison", "did you mean '--version'"},
    {"overlap tiles --broad-phase unifed", "did you mean 'unified'"},
    {"overlap tiles --style hate", "did you mean 'heat'"},
    {"overlap tiles --engines scree,box3d", "did you mean 'box2d'"},
    {"overlap tiles --engines ''", "unknown engine ''"},
    {"overlap tiles --poses scre", "did you mean 'scree'"},
    {"overlap tiles --backend osmes", "did you mean 'osmesa'"},
    {"overlap tiles --theme lite", "did you mean 'light'"},
    {"overlap tiles --animate apg", "did you mean 'apng'"},
    {"render tiles --animate apng --fps 0", "from 1 to 120"},
    {"render tiles --contact-sheet --steps 1:500", "first:last:stride"},
    {"overlap tiles --size 0", "from 1 to 2000"},
    {"overlap tiles --size 2001", "from 1 to 2000"},
    {"overlap tiles --size many", "--size many: that is not a whole number"},
    {"overlap tiles --size 1e9", "--size 1e9: that is not a whole number"},
    {"overlap tiles --gravity 0/-5", "did you mean '--set gravity=VALUE'?"},
    {"overlap tiles --engines box2d --substeps 4", "substeps"},
    {"overlap tiles --zzzzzzzz", "unknown option '--zzzzzzzz'; `scree overlap --help` shows all"},
    {"overlap foo", "unknown scene 'foo'; `scree list` shows all"},
    {"overlap tiles --style gypsum", "unknown style 'gypsum'; known: "},
    {"requires pyramid -5", "from 1 to 1500"},
    {"requires pyramid --markdown page.md", "leave SCENE out, or add --ablation"},
    {"extremes --limit nan", "above 0"},
    {"extremes --limit inf", "above 0"},
    {"bench tiles --time-limit nan", "0 or a number above it"},
    {"bench tiles --time-limit -1", "0 or a number above it"},
    {"bench tiles --against . --at-least nan", "above 0"},
    {"find tiles --speed nan", "0 or a number above it"},
    {"overlap add-pair-400 --size 500", "is 400"},
    {"overlap tiles add-pair-400 --size 100", "'add-pair-400' is 400"},
    {"overlap", "scree list"},
    {"overlap tiles --step 0", "from 1 to 1000000"},
    {"overlap tiles --step 1000001", "from 1 to 1000000"},
    {"overlap tiles --steps 5", "--step N"},
    {"overlap tiles --steps 0:5", "from 1 to 1000000"},
    {"overlap tiles --steps 9:5", "not after the last"},
    {"overlap tiles --steps 1:5:0", "stride"},
    {"overlap tiles --steps 1:5:1:1", "first:last"},
    {"overlap tiles --steps 1:x", "first:last"},
    {"overlap tiles --step 5 --steps 1:5", "excludes"},
    {"overlap tiles --worst 0", "from 1 to 20"},
    {"overlap tiles --worst 21", "from 1 to 20"},
    {"overlap tiles --worst 2 --worst-by tiem", "did you mean 'time'"},
    {"overlap tiles --nodes intern", "internal"},
    {"overlap tiles --nodes levels=3..1", "levels=A..B"},
    {"overlap tiles --opacity 0", "--opacity"},
    {"overlap tiles --opacity 1.5", "--opacity"},
    {"overlap tiles --scale-max -3", "--scale-max"},
    {"overlap tiles --query-size -1", "--query-size"},
    {"overlap tiles --image 1920", "1920x1080"},
    {"overlap tiles --image 8x8", "--image"},
    {"overlap tiles --camera 1,2", "camera"},
    {"overlap tiles --camera 1,2,-3", "camera"},
    {"overlap tiles --threads 0", "--threads"},
    {"render tiles --layers bodies,contact", "contacts"},
    {"render tiles add-pair-400", "too many arguments"},
    {"metrics tiles --steps 0", "from 1 to 1000000"},
    {"metrics", "scree list"},
    {"list extra", "too many arguments"},
};

INSTANTIATE_TEST_SUITE_P(All, WrongUsage, testing::ValuesIn(usageCases));

TEST(Usage, NoCommandShowsTheHelp) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("");
    EXPECT_EQ(result.exitCode, 2);
    for (const char* command : {"list", "overlap", "render", "metrics", "env"}) {
        EXPECT_NE(result.output.find(command), std::string::npos) << command;
    }
}

TEST(Usage, HelpAndVersionExitWithZero) {
    const ScratchFolder folder;
    EXPECT_EQ(folder.Run("--help").exitCode, 0);
    EXPECT_TRUE(folder.Run("--version").output.starts_with("scree 0.1.0, commit "));
    const ProgramResult help = folder.Run("overlap --help");
    EXPECT_EQ(help.exitCode, 0);
    for (const char* option :
         {"--size",    "--step",      "--steps",      "--worst",       "--worst-by", "--nodes",   "--style",
          "--opacity", "--scale-max", "--query-size", "--broad-phase", "--poses",    "--engines", "--image",
          "--camera",  "--backend",   "--output",     "--theme",       "--animate",  "--fps",     "--contact-sheet"}) {
        EXPECT_NE(help.output.find(option), std::string::npos) << option;
    }
}

TEST(Usage, AFolderThatCannotBeWrittenIsFoundBeforeTheRun) {
    const ScratchFolder folder;
    // A file in the way stops root as well, whom permissions do not.
    ASSERT_EQ(folder.Run("list > file").exitCode, 0);
    for (const char* command : {"overlap", "render", "metrics"}) {
        const ProgramResult result = folder.Run(std::string(command) + " falling-squares -o file/below");
        EXPECT_EQ(result.exitCode, 4) << result.output;
        EXPECT_NE(result.output.find("file/below"), std::string::npos) << result.output;
        EXPECT_NE(result.output.find("-o DIR"), std::string::npos) << result.output;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
    }
}

TEST(Usage, AHeaderThatCannotBeWrittenIsFoundBeforeTheRun) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("requires pyramid --header nowhere/header.h");
    EXPECT_EQ(result.exitCode, 4) << result.output;
    EXPECT_EQ(result.output, "scree: cannot write nowhere/header.h: No such file or directory\n");
}

TEST(Usage, AMissingGnuplotIsFoundBeforeTheRun) {
    const ScratchFolder folder;
    const ProgramResult result = folder.Run("overlap tiles", "PATH=/nowhere");
    EXPECT_EQ(result.exitCode, 4) << result.output;
    EXPECT_NE(result.output.find("gnuplot-nox"), std::string::npos) << result.output;
    EXPECT_TRUE(std::filesystem::is_empty(folder.GetPath()));
}

class MissingBackend : public testing::Test {
protected:
    MissingBackend() {
        m_options.osmesaLibrary = "libabsent-osmesa.so.1";
        m_options.eglLibrary = "libabsent-egl.so.1";
    }
    ContextOptions m_options;
    ScratchFolder m_folder;
};

TEST_F(MissingBackend, ExitsWithThreeAndNamesThePackage) {
    testing::internal::CaptureStderr();
    const int code =
        RunCommandLine({"overlap", "tiles", "--backend", "auto", "-o", m_folder.GetPath().string()}, m_options);
    const std::string message = testing::internal::GetCapturedStderr();
    EXPECT_EQ(code, 3);
    EXPECT_NE(message.find("libosmesa6"), std::string::npos) << message;
}

TEST_F(MissingBackend, ExitsWithSeventySevenWhenAskedToSkip) {
    testing::internal::CaptureStderr();
    const int code = RunCommandLine(
        {"render", "tiles", "--backend", "osmesa", "--skip-missing-backend", "-o", m_folder.GetPath().string()},
        m_options);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("skipped"), std::string::npos);
    EXPECT_EQ(code, 77);
}

TEST_F(MissingBackend, DoesNotMatterToTheBuiltInOneAndToMetrics) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const std::string out = m_folder.GetPath().string();
    EXPECT_EQ(RunCommandLine({"metrics", "tiles", "--size", "5", "--steps", "2", "-o", out}, m_options), 0);
    EXPECT_EQ(
        RunCommandLine({"overlap", "tiles", "--size", "5", "--step", "2", "--image", "320x200", "-o", out}, m_options),
        0);
    testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
}

}  // namespace
}  // namespace testbed
