// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of gnuplot.h.

#include "testbed/page/gnuplot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <span>
#include <system_error>

#include "testbed/base/errors.h"
#include "testbed/base/process.h"

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// gnuplot ends with 0 even where the disk had no room for the picture: a whole one has its end.
bool IsWhole(const fs::path& picture) {
    std::ifstream stream(picture, std::ios::binary | std::ios::ate);
    const std::streamoff size = stream.tellg(), length = std::min<std::streamoff>(size, 32);
    if (length <= 0) return false;
    std::string end(static_cast<std::size_t>(length), ' ');
    stream.seekg(size - length);
    stream.read(end.data(), length);
    return stream && (end.find("</svg>") != std::string::npos || end.find("IEND") != std::string::npos);
}

}  // namespace

void CheckGnuplot() {
    if (IsInstalled("gnuplot")) return;
    throw ToolError("gnuplot draws the plots and is not installed; install it with: apt-get install gnuplot-nox");
}

void RunGnuplot(const std::string& script, const fs::path& picture) {
    const MemoryFile commands, words;
    if (!WriteAll(commands.Get(), std::as_bytes(std::span(script)))) throw ToolError("no memory for a plot's script");
    lseek(commands.Get(), 0, SEEK_SET);
    Process gnuplot;
    const bool started =
        !gnuplot.Start({"gnuplot", "-"}, {.input = commands.Get(), .output = words.Get(), .errors = words.Get()});
    if (started && gnuplot.Wait().IsGood() && IsWhole(picture)) return;
    const std::string said = words.Read();
    const std::string reason = !started        ? "it did not start"
                               : !said.empty() ? said
                                               : "its file is not whole; is the disk full?";
    throw ToolError(fmt::format("gnuplot could not draw {}: {}", picture.string(), reason));
}

}  // namespace testbed
