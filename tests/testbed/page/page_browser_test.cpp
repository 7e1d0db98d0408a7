// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The report pages in a browser: writes sample reports, moves the page away from its folder, and has
// page_browser_test.py drive it in headless Chromium like a reader. Without Chromium the test fails and says what to
// install: a page that nobody opened is not tested.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"
#include "testbed/jobs/snapshot/page.h"
#include "tests/testbed/page/sample_pages.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

struct DriverResult {
    int exitCode = -1;
    std::string output;
};

DriverResult DriveBrowser(const fs::path& folder) {
    const std::string command =
        "python3 -B '" SCREE_TESTS "/testbed/page/page_browser_test.py' '" + folder.string() + "' 2>&1 </dev/null";
    DriverResult result;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return result;
    char buffer[4096];
    for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
        result.output.append(buffer, count);
    }
    const int status = pclose(pipe);
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

TEST(PageInBrowser, DoesWhatAReaderAsks) {
    const ScratchFolder scratch;
    const fs::path report = scratch.GetPath() / "report", moved = scratch.GetPath() / "moved";
    fs::create_directories(moved);
    const SampleComparison sample = MakeSampleComparison(report);
    ASSERT_EQ(WriteSnapshotPage(report, sample.origin, sample.results), report / "index.html");
    WritePage(report / "sample.html", MakeSamplePage(report));
    // Alone: a page that needs the files beside it fails.
    fs::rename(report / "index.html", moved / "index.html");
    fs::rename(report / "sample.html", moved / "sample.html");
    nlohmann::json counts = nlohmann::json::array();
    for (const SampleCount& count : sample.counts) {
        counts.push_back({{"x", count.x}, {"y", count.y}, {"expected", count.expected}, {"actual", count.actual}});
    }
    WriteTextFile(moved / "counts.json", counts.dump());

    const DriverResult result = DriveBrowser(moved);
    EXPECT_EQ(result.exitCode, 0) << result.output;
    if (result.exitCode != 0) return;
    for (const char* name : {"sample-light", "sample-dark", "snapshot-light", "snapshot-dark", "snapshot-slider",
                             "snapshot-difference", "snapshot-structure"}) {
        EXPECT_TRUE(fs::exists(moved / (std::string(name) + ".png"))) << name;
    }
}

}  // namespace
}  // namespace testbed
