// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Steps together: animations and videos instead of single pictures, contact sheets beside them, and the message when
// ffmpeg is missing.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/base/process.h"
#include "testbed/picture/png.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

TEST(Sequences, ApngStandsForTheStepsPictures) {
    const ScratchFolder folder;
    const std::string look = " --engines scree --size 5 --image 320x200 --layers bodies,velocities ";
    ASSERT_EQ(folder.Run("render tiles --steps 2:10:4 --animate apng --contact-sheet" + look).exitCode, 0);
    EXPECT_EQ(FilesBelow(folder.GetPath()),
              (std::set<std::string>{"out/tiles/render-scree.apng", "out/tiles/render-scree-sheet.png"}));
    // A reader of still pictures shows the first frame: the picture of step 2.
    ASSERT_EQ(folder.Run("render tiles --step 2 -o still" + look).exitCode, 0);
    const Image first = ReadPng(folder.GetPath() / "out/tiles/render-scree.apng");
    EXPECT_TRUE(first.pixels == ReadPng(folder.GetPath() / "still/tiles/step-0002/render-scree.png").pixels);
    const std::string bytes = folder.Read("out/tiles/render-scree.apng");
    const size_t control = bytes.find("acTL");
    ASSERT_NE(control, std::string::npos);
    EXPECT_EQ(bytes.substr(control + 4, 4), std::string("\0\0\0\3", 4)) << "steps 2, 6 and 10";
    EXPECT_EQ(ReadPng(folder.GetPath() / "out/tiles/render-scree-sheet.png").width, 320);
}

TEST(Sequences, OverlapMovesAllItsPictures) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("overlap tiles --size 5 --steps 1:3 --animate apng --image 320x200").exitCode, 0);
    const std::string base = "out/tiles/";
    EXPECT_EQ(FilesBelow(folder.GetPath()),
              (std::set<std::string>{base + "scree.apng", base + "box2d.apng", base + "compare.apng",
                                     base + "difference.apng", base + "metrics.csv", base + "metrics.json",
                                     base + "timing.csv", base + "timing.png"}));
}

TEST(Sequences, AContactSheetAddsToThePictures) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("render tiles --size 5 --steps 1:2 --engines box2d --contact-sheet --image 320x200").exitCode,
              0);
    EXPECT_TRUE(folder.Has("out/tiles/render-box2d-sheet.png"));
    EXPECT_TRUE(folder.Has("out/tiles/step-0001/render-box2d.png"));
    EXPECT_TRUE(folder.Has("out/tiles/step-0002/render-box2d.json"));
}

TEST(Sequences, Mp4NeedsFfmpegAndSaysSo) {
    const ScratchFolder folder;
    const ProgramResult result =
        folder.Run("render tiles --size 5 --steps 1:2 --animate mp4 --image 320x200", "PATH=/nowhere");
    EXPECT_EQ(result.exitCode, 4);
    EXPECT_NE(result.output.find("apt-get install ffmpeg"), std::string::npos) << result.output;
    EXPECT_TRUE(FilesBelow(folder.GetPath()).empty());
}

TEST(Sequences, Mp4IsAVideoWhereFfmpegIsInstalled) {
    const ScratchFolder folder;
    // An odd height, which players do not take, becomes even.
    const ProgramResult result =
        folder.Run("render tiles --size 5 --steps 1:6 --engines scree --animate mp4 --image 320x201");
    if (!IsInstalled("ffmpeg")) {
        EXPECT_EQ(result.exitCode, 4);
        return;
    }
    ASSERT_EQ(result.exitCode, 0) << result.output;
    EXPECT_EQ(FilesBelow(folder.GetPath()), (std::set<std::string>{"out/tiles/render-scree.mp4"}));
    const std::string bytes = folder.Read("out/tiles/render-scree.mp4");
    EXPECT_EQ(bytes.substr(4, 4), "ftyp");
    const std::string probe = "cd '" + folder.GetPath().string() +
                              "' && ffprobe -v error -count_frames -select_streams v -show_entries "
                              "stream=width,height,nb_read_frames -of csv=p=0 out/tiles/render-scree.mp4 >probe.txt";
    ASSERT_EQ(std::system(probe.c_str()), 0);
    EXPECT_EQ(folder.Read("probe.txt"), "320,202,6\n");
}

}  // namespace
}  // namespace testbed
