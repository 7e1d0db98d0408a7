// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of gnuplot.h.

#include "testbed/page/gnuplot.h"

#include <fmt/format.h>

#include <system_error>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"
#include "testbed/base/process.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// Removes the file when the plot is done or failed.
struct TemporaryFile {
    fs::path path;
    ~TemporaryFile() {
        std::error_code ignored;
        fs::remove(path, ignored);
    }
};

}  // namespace

void CheckGnuplot() {
    if (IsInstalled("gnuplot")) return;
    throw ToolError("gnuplot draws the plots and is not installed; install it with: apt-get install gnuplot-nox");
}

void RunGnuplot(const std::string& script, const fs::path& picture) {
    const TemporaryFile file{picture.string() + ".gp"};
    WriteTextFile(file.path, script);
    const MemoryFile words;
    Process gnuplot;
    const bool started =
        !gnuplot.Start({"gnuplot", fs::absolute(file.path).string()}, {.output = words.Get(), .errors = words.Get()});
    if (started && gnuplot.Wait().IsGood() && fs::exists(picture)) return;
    const std::string said = words.Read();
    throw ToolError(
        fmt::format("gnuplot could not draw {}: {}", picture.string(), said.empty() ? "it did not start" : said));
}

}  // namespace testbed
