// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT

#include "testbed/base/input.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <thread>

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

TEST(ReadText, GivesEveryByteOfFilesAndPipes) {
    const ScratchFolder folder;
    std::mt19937 random(3);
    for (std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{random() % 1000}, std::size_t{(1 << 16) - 1},
                             std::size_t{1 << 16}, std::size_t{(1 << 16) + 1}, std::size_t{random() % 1000000}}) {
        std::string text(size, '\0');
        for (char& c : text) c = static_cast<char>(random());
        const auto file = folder.GetPath() / "file", pipe = folder.GetPath() / "pipe";
        std::ofstream(file, std::ios::binary) << text;
        EXPECT_EQ(ReadText(file, ""), text) << size;
        ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
        std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << text; });
        EXPECT_EQ(ReadText(pipe, ""), text) << size;
        writer.join();
        std::filesystem::remove(pipe);
    }
}

TEST(ReadText, WhatCannotBeReadIsAnErrorWithTheCure) {
    const ScratchFolder folder;
    for (const auto& path : {folder.GetPath(), folder.GetPath() / "nothing"}) {
        try {
            (void)ReadText(path, "check its path");
            ADD_FAILURE() << path;
        } catch (const FileError& error) {
            EXPECT_TRUE(std::string_view(error.what()).starts_with(path.string())) << error.what();
            EXPECT_NE(std::string_view(error.what()).find("check its path"), std::string_view::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace testbed
