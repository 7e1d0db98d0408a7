// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Files that appear whole or not at all: temporary names, devices, pipes, links, limits, and the program stopped while
// it writes.

#include "testbed/base/new_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/process.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

/// Of a run whose standard output is `place`; the rest of the command is its standard error.
ProgramResult RunInto(const ScratchFolder& folder, const std::string& arguments, const std::string& place) {
    return folder.Run(arguments + " 2>&1 >" + place + " #");
}

TEST(NewFile, HasItsNameOnlyWhenFinished) {
    const ScratchFolder folder;
    const fs::path path = folder.GetPath() / "a.txt";
    {
        NewFile file(path);
        file.Write("half");
        EXPECT_FALSE(fs::exists(path));
        EXPECT_EQ(file.GetPlace().parent_path(), folder.GetPath()) << "a name elsewhere could not be renamed";
        EXPECT_TRUE(fs::exists(file.GetPlace()));
    }
    EXPECT_TRUE(fs::is_empty(folder.GetPath())) << "what was not finished is gone";
    NewFile file(path);
    file.Write("whole");
    NewFile moved = std::move(file);
    moved.Finish();
    EXPECT_EQ(folder.Read("a.txt"), "whole");
    EXPECT_EQ(FilesBelow(folder.GetPath()).size(), 1u);
}

TEST(NewFile, LeavesTheOldFileWhereTheNewOneFails) {
    const ScratchFolder folder;
    const fs::path path = folder.GetPath() / "a.txt";
    WriteTextFile(path, "old");
    {
        NewFile file(path);
        file.Write("new");
    }
    EXPECT_EQ(folder.Read("a.txt"), "old");
    EXPECT_THROW(WriteTextFile(folder.GetPath() / "none/a.txt", "text"), FileError);
}

TEST(NewFile, WritesTheTargetOfALink) {
    const ScratchFolder folder;
    WriteTextFile(folder.GetPath() / "target.txt", "old");
    fs::create_symlink("target.txt", folder.GetPath() / "link.txt");
    fs::create_symlink("later.txt", folder.GetPath() / "dangling.txt");
    WriteTextFile(folder.GetPath() / "link.txt", "new");
    WriteTextFile(folder.GetPath() / "dangling.txt", "first");
    EXPECT_EQ(folder.Read("target.txt"), "new");
    EXPECT_EQ(folder.Read("later.txt"), "first");
    EXPECT_TRUE(fs::is_symlink(folder.GetPath() / "link.txt"));
    EXPECT_TRUE(fs::is_symlink(folder.GetPath() / "dangling.txt"));
}

TEST(NewFile, WritesDevicesAndPipesInPlace) {
    const ScratchFolder folder;
    WriteTextFile("/dev/null", "text");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    try {
        WriteTextFile("/dev/full", "text");
        ADD_FAILURE() << "/dev/full took it";
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "cannot write /dev/full: No space left on device");
    }
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    const fs::path pipe = folder.GetPath() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] {
        std::ifstream stream(pipe);
        got.assign(std::istreambuf_iterator<char>(stream), {});
    });
    WriteTextFile(pipe, "through the pipe");
    reader.join();
    EXPECT_EQ(got, "through the pipe");
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(Outputs, AFullOrClosedStandardOutputIsAnError) {
    const ScratchFolder folder;
    for (const std::string arguments :
         {"list", "list --json", "env", "--help", "--version", "metrics tiles --size 4 --steps 2"}) {
        const ProgramResult full = RunInto(folder, arguments, "/dev/full");
        EXPECT_EQ(full.exitCode, exitIo) << arguments;
        EXPECT_NE(full.output.find("standard output: No space left on device"), std::string::npos) << arguments << "\n"
                                                                                                   << full.output;
        const ProgramResult closed = RunInto(folder, arguments, "&-");
        EXPECT_EQ(closed.exitCode, exitIo) << arguments << "\n" << closed.output;
        EXPECT_NE(closed.output.find("standard output"), std::string::npos) << arguments << "\n" << closed.output;
    }
    // A reader that goes away is an error too, not a silent end by a signal.
    const ProgramResult gone = folder.Run("list 2>&3 | true; } 3>&1 #", "{ sleep 0;");
    EXPECT_EQ(gone.output.find("terminate"), std::string::npos) << gone.output;
}

TEST(Outputs, AFullOrClosedStandardErrorChangesNoExitCode) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("convert falling-squares --size 4 whole.track --steps 400").exitCode, exitDone);
    const std::string bytes = folder.Read("whole.track");
    WriteTextFile(folder.GetPath() / "cut.track", bytes.substr(0, bytes.size() * 3 / 4));
    const std::pair<const char*, int> cases[] = {
        {"metrics tiles --size 4 --steps 2", exitDone},
        {"find cut.track --speed 0.5", exitDiffers},
        {"find none.track", exitIo},
        {"nonsense", exitUsage},
        {"", exitUsage},
        {"list >/dev/full", exitIo},
        {"merge none.jsonl", exitIo},
    };
    for (const auto& [arguments, exitCode] : cases) {
        for (const char* place : {" 2>/dev/full #", " 2>&- #"}) {
            EXPECT_EQ(folder.Run(std::string(arguments) + place).exitCode, exitCode) << arguments << place;
        }
    }
}

TEST(Outputs, ADashIsStandardOutputAndAllElseGoesToStandardError) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("bench tiles --sizes 4 --steps 2 --json - >lines.jsonl 2>words.txt #").exitCode, 0)
        << folder.Read("words.txt");
    const std::string lines = folder.Read("lines.jsonl");
    EXPECT_EQ(lines.substr(0, 2), "{\"") << lines;
    EXPECT_EQ(lines.back(), '\n');
    EXPECT_FALSE(folder.Read("words.txt").empty());
    const ProgramResult full = RunInto(folder, "merge lines.jsonl -o -", "/dev/full");
    EXPECT_EQ(full.exitCode, exitIo) << full.output;
    ASSERT_EQ(folder.Run("merge lines.jsonl -o - >again.jsonl #").exitCode, 0);
    EXPECT_EQ(folder.Read("again.jsonl"), lines);
    // An ending says the kind of a file; "-" has none and is a scene.
    ASSERT_EQ(folder.Run("convert pyramid --size 3 level.scene.json").exitCode, 0);
    ASSERT_EQ(folder.Run("convert pyramid --size 3 - >piped.scene.json 2>words.txt #").exitCode, 0);
    EXPECT_EQ(folder.Read("piped.scene.json"), folder.Read("level.scene.json"));
    EXPECT_NE(folder.Read("words.txt").find("standard output"), std::string::npos) << folder.Read("words.txt");
}

TEST(Outputs, ATrackOnAFullDiskTellsTheReasonAndTheNameThatWasGiven) {
    const ScratchFolder folder;
    const std::string convert = "convert tiles session.track --size 8 --steps 60";
    const ProgramResult limited = folder.RunOnFullDisk(convert, 4);
    EXPECT_EQ(limited.exitCode, exitIo) << limited.output;
    EXPECT_NE(limited.output.find("cannot write session.track: the track cannot be written to its end: File too large"),
              std::string::npos)
        << limited.output;
    EXPECT_EQ(FilesBelow(folder.GetPath()), std::set<std::string>());
    // A device is written in place; as a link to it its name says the kind of file.
    fs::create_symlink("/dev/full", folder.GetPath() / "session.track");
    const ProgramResult full = folder.Run(convert);
    EXPECT_EQ(full.exitCode, exitIo) << full.output;
    EXPECT_NE(full.output.find("cannot write session.track: No space left on device"), std::string::npos)
        << full.output;
}

TEST(Outputs, AFullDiskIsAnErrorWithItsReasonWhereverItStrikes) {
    for (const int blocks : {1, 4, 16, 40}) {
        for (const std::string arguments :
             {"overlap tiles --size 6 --step 3 --image 640x400 --backend cpu",
              "render tiles --size 8 --steps 1:9 --animate apng --image 640x400 --backend cpu"}) {
            const ScratchFolder folder;
            const ProgramResult result = folder.RunOnFullDisk(arguments, blocks);
            if (result.exitCode == exitDone) continue;  // its files are smaller
            EXPECT_EQ(result.exitCode, exitIo) << blocks << " " << arguments << "\n" << result.output;
            for (const std::string& file : FilesBelow(folder.GetPath())) {
                EXPECT_EQ(file.find(".tmp"), std::string::npos) << file;
            }
            EXPECT_TRUE(result.output.find("File too large") != std::string::npos ||
                        result.output.find("gnuplot could not") != std::string::npos)
                << result.output;
        }
    }
}

/// Starts the program in the folder, waits until it has an unfinished file, and stops it by a signal.
ProcessEnd StopWhileItWrites(const ScratchFolder& folder, int signal) {
    Process process;
    const MemoryFile words;
    const std::string output = (folder.GetPath() / "out").string();
    EXPECT_FALSE(process.Start({SCREE_PROGRAM, "render", "tiles", "--size", "30", "--steps", "1:4000", "--animate",
                                "apng", "--image", "640x400", "--backend", "cpu", "--camera", "0,20,80", "-o", output},
                               {.output = words.Get(), .errors = words.Get()}));
    for (int tries = 0; tries < 1000; ++tries) {
        if (fs::exists(output) && !FilesBelow(output).empty()) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_FALSE(FilesBelow(output).empty()) << words.Read();
    process.Stop(signal);
    return process.Wait();
}

TEST(Outputs, SignalsLeaveNoUnfinishedFiles) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const ScratchFolder folder;
        EXPECT_EQ(StopWhileItWrites(folder, signal).GetSignal(), signal);
        EXPECT_EQ(FilesBelow(folder.GetPath()), std::set<std::string>());
    }
}

TEST(Outputs, AStoppedBenchGoesOnWithTheSameNumbers) {
    const ScratchFolder folder;
    const std::string command = "bench tiles pyramid --sizes 5,10,20 --solver si --steps 20 --repeat 1 --json ";
    ASSERT_EQ(folder.Run(command + "whole.jsonl").exitCode, 0);
    // What a run leaves that was stopped in its fourth case.
    std::string text = folder.Read("whole.jsonl");
    std::size_t end = 0;
    for (int line = 0; line < 6; ++line) end = text.find('\n', end) + 1;
    WriteTextFile(folder.GetPath() / "half.jsonl.part", text.substr(0, end + 20));
    const ProgramResult resumed = folder.Run(command + "half.jsonl --resume --csv half.csv");
    ASSERT_EQ(resumed.exitCode, 0) << resumed.output;
    const std::string half = folder.Read("half.jsonl");
    EXPECT_EQ(half.substr(0, end), text.substr(0, end)) << "measured once";
    EXPECT_EQ(std::count(half.begin(), half.end(), '\n'), std::count(text.begin(), text.end(), '\n'));
    const std::string csv = folder.Read("half.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + std::count(text.begin(), text.end(), '\n'));
    EXPECT_FALSE(folder.Has("half.jsonl.part"));
    EXPECT_EQ(folder.Run("bench tiles --resume").exitCode, exitUsage);
}

TEST(Outputs, TwoRunsIntoOneFolderBothComplete) {
    const ScratchFolder folder;
    const std::string command = "tiles --size 6 --image 320x200 --backend cpu --animate apng -o two";
    const ProgramResult result =
        folder.Run("render " + command + " --steps 1:30 >one.txt 2>&1 & p=$!; '" SCREE_PROGRAM "' render " + command +
                       " --steps 2:31 >two.txt 2>&1; second=$?; wait $p || exit 1; exit $second; } #",
                   "{");  // both in the folder
    ASSERT_TRUE(folder.Has("one.txt") && folder.Has("two.txt"));
    EXPECT_EQ(result.exitCode, 0) << folder.Read("one.txt") << folder.Read("two.txt");
    // One of both is there, whole.
    for (const char* name : {"two/tiles/render-scree.apng", "two/tiles/render-box2d.apng"}) {
        const std::string bytes = folder.Read(name);
        ASSERT_GT(bytes.size(), 12u);
        EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND") << name;
    }
    EXPECT_EQ(FilesBelow(folder.GetPath() / "two").size(), 2u);
}

TEST(Process, EndsWithItsParentHoweverThatEnds) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(pipe(ends), 0);
    const pid_t parent = fork();
    if (parent == 0) {
        Process child;
        if (child.Start({"sleep", "1000"}, {.output = ends[1]})) _exit(1);
        close(ends[1]);
        raise(SIGKILL);
    }
    close(ends[1]);
    int status = 0;
    waitpid(parent, &status, 0);
    EXPECT_EQ(WIFSIGNALED(status) ? WTERMSIG(status) : 0, SIGKILL);
    char byte = 0;
    EXPECT_EQ(read(ends[0], &byte, 1), 0) << "the last holder of the pipe has ended";
    close(ends[0]);
}

}  // namespace
}  // namespace testbed
