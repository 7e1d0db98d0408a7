// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Steps together: animations and videos instead of single pictures, contact sheets beside them, and the message when
// ffmpeg is missing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

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
    // A reader of still pictures shows the first frame: the picture of step 2 among those of the same steps.
    ASSERT_EQ(folder.Run("render tiles --steps 2:10:4 -o still" + look).exitCode, 0);
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

TEST(Sequences, StepsShareCameraAndScales) {
    const ScratchFolder folder;
    const auto read = [&](const std::string& step, const std::string& name) {
        return nlohmann::json::parse(folder.Read("out/add-pair/step-00" + step + "/" + name + ".json"));
    };
    const std::vector<std::string> steps{"02", "14", "26"};
    const std::string common = "add-pair --size 50 --steps 2:26:12 --style heat --image 320x200";
    ASSERT_EQ(folder.Run("overlap " + common).exitCode, 0);
    int largest = 0;
    std::set<int> maxima;
    for (const std::string& step : steps) {
        for (const char* pane : {"scree", "box2d", "compare", "difference"}) {
            EXPECT_EQ(read(step, pane)["camera"], read("02", "scree")["camera"]) << step << " " << pane;
            EXPECT_EQ(read(step, pane)["scale_max"], read("02", "scree")["scale_max"]) << step << " " << pane;
        }
        for (const char* pane : {"scree", "box2d"}) {
            const int max = read(step, pane)["engines"][0]["metrics"]["overlap_max"];
            largest = std::max(largest, max);
            maxima.insert(max);
        }
    }
    EXPECT_EQ(read("02", "scree")["scale_max"], largest);
    EXPECT_GT(maxima.size(), 1u) << "each step alone would have had its own scale";
    ASSERT_EQ(folder.Run("render " + common + " --layers bodies,velocities").exitCode, 0);
    for (const std::string& step : steps) {
        EXPECT_EQ(read(step, "render-scree")["camera"], read("26", "render-box2d")["camera"]) << step;
    }
    // The worst steps are known late, and are a sequence all the same.
    ASSERT_EQ(folder.Run("overlap add-pair --size 50 --steps 2:26 --worst 3 --worst-by overlap --image 320x200 -o w")
                  .exitCode,
              0);
    std::set<std::string> cameras;
    for (const std::string& file : FilesBelow(folder.GetPath())) {
        if (!file.starts_with("w/") || !file.ends_with("scree.json")) continue;
        cameras.insert(nlohmann::json::parse(folder.Read(file))["camera"].dump());
    }
    EXPECT_EQ(cameras.size(), 1u);
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
