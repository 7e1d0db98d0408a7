// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Whole files in a folder.

#include "testbed/base/output.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

TEST(OutputFolder, ReplacesWholeFilesAndRemembersThem) {
    const ScratchFolder folder;
    OutputFolder output(folder.GetPath() / "new/deep");
    output.WriteText("a/b.txt", "first");
    output.WriteText("a/b.txt", "second");
    EXPECT_EQ(folder.Read("new/deep/a/b.txt"), "second");
    EXPECT_EQ(output.GetFiles().size(), 2u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.GetPath() / "new/deep/a"), {}), 1);
}

TEST(OutputFolder, AFileInTheWayIsAFileError) {
    const ScratchFolder folder;
    std::ofstream(folder.GetPath() / "file") << "x";
    EXPECT_THROW(OutputFolder(folder.GetPath() / "file"), FileError);
    EXPECT_THROW(OutputFolder(folder.GetPath() / "file/below"), FileError);
    EXPECT_EQ(folder.Read("file"), "x");
}

}  // namespace
}  // namespace testbed
