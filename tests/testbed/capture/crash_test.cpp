// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A flight recorder in a program that crashes: what its handler saved is a whole track, with the moment before the
// crash.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

TEST(FlightRecorder, ACrashHandlerSavesTheSecondsBefore) {
    for (const auto& [kind, signal] : {std::pair("segv", SIGSEGV), {"abort", SIGABRT}, {"throw", SIGABRT}}) {
        const ScratchFolder folder;
        const std::string command =
            "cd '" + folder.GetPath().string() + "' && exec '" SCREE_CRASH_PROGRAM "' " + kind + " 2>said </dev/null";
        const int status = std::system(command.c_str());
        ASSERT_TRUE(WIFSIGNALED(status)) << kind << ' ' << status << folder.Read("said");
        EXPECT_EQ(WTERMSIG(status), signal) << kind << ": it ends as it would have ended";

        const ProgramResult info = folder.Run("info crash.track --json");
        ASSERT_EQ(info.exitCode, exitDone) << kind << info.output;
        const auto facts = nlohmann::json::parse(info.output).at("files").at(0);
        EXPECT_EQ(facts.at("damage"), "") << kind;
        EXPECT_EQ(facts.at("last_step"), 320) << kind << ": the step before the crash";
        EXPECT_GT(facts.at("first_step"), 120) << kind << ": older ones are gone";
        EXPECT_LE(facts.at("first_step"), 261) << kind << ": a second is there";

        const ProgramResult found = folder.Run("find crash.track --tunnel --json found.json");
        EXPECT_EQ(found.exitCode, 1) << kind << found.output;
        const auto moments = nlohmann::json::parse(folder.Read("found.json")).at("moments");
        ASSERT_EQ(moments.size(), 1u) << found.output;
        EXPECT_EQ(moments[0].at("bodies")[0].at("name"), "shot");
        EXPECT_NEAR(moments[0].at("step").get<int>(), 283, 2) << kind;
    }
}

TEST(FlightRecorder, ThePageHasTheHandlerOfTheProgram) {
    const auto handlerIn = [](const char* file) {
        std::ifstream stream(std::string(SCREE_SOURCE_DIR "/") + file);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        const std::size_t begin = text.find("void OnCrash(");
        EXPECT_NE(begin, std::string::npos) << file;
        return text.substr(begin, text.find("\n}\n", begin) - begin);
    };
    EXPECT_EQ(handlerIn("testbed/docs/own-world.md"), handlerIn("tests/capture/crash_program.cpp"));
}

}  // namespace
}  // namespace testbed
