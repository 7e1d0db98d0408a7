// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Broad-phase time by step as a picture. The data stand in the script itself, so that one file is all that passes to
// gnuplot; it is started without a shell, so that no file name needs quoting for one.

#include "testbed/report/timing_plot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

#include "testbed/report/output.h"

extern char** environ;

namespace testbed {

namespace fs = std::filesystem;

namespace {

/// A gnuplot string literal: in single quotes only the quote itself is special.
std::string Quote(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c;
        if (c == '\'') quoted += c;
    }
    return quoted + "'";
}

struct SeriesLook {
    std::string_view engine, title, color;
    int pointType;  ///< gnuplot's number: 7 filled circle, 5 filled square
};

constexpr SeriesLook looks[] = {{"box2d", "Box2D", "#0000cc", 7}, {"scree", "Scree", "#cc0000", 5}};

constexpr std::string_view header = R"(set terminal pngcairo size 1100,640 font 'DejaVu Sans,12' background '#ffffff'
set border 31 linecolor '#000000'
set grid linecolor '#cccccc' linetype 1
set key top right opaque box width 1
set xlabel 'step'
set ylabel 'broad phase [ms]'
set offsets 0, 0, graph 0.14, 0
set yrange [0:*]
)";

constexpr std::string_view boxTwoDNote =
    "Box2D: pair finding and tree update. Its retest of kept contacts runs inside Collide, cannot be separated,"
    " and is not in these times.";

/// Removes the files when the plot is done or failed.
struct TemporaryFiles {
    fs::path script, log;
    ~TemporaryFiles() {
        std::error_code ignored;
        fs::remove(script, ignored);
        fs::remove(log, ignored);
    }
};

/// Exit status of `gnuplot script`, its output in `log`; −1 when it could not be started.
int RunGnuplot(const fs::path& script, const fs::path& log) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    std::string program = "gnuplot", argument = fs::absolute(script).string();
    char* arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return -1;
    int status = 0;
    if (waitpid(child, &status, 0) != child) return -1;
    return status;
}

}  // namespace

void CheckGnuplot() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((fs::path(folder) / "gnuplot").c_str(), X_OK) == 0) return;
    }
    throw ToolError("gnuplot draws the timing plot and is not installed; install it with: apt-get install gnuplot-nox");
}

std::string MakeTimingScript(std::span<const TimingSeries> series, const std::string& title, const fs::path& picture) {
    std::string data, plots;
    bool hasBox2d = false;
    int lastStep = 1;
    for (const SeriesLook& look : looks) {
        const auto one = std::find_if(series.begin(), series.end(),
                                      [&](const TimingSeries& candidate) { return candidate.engine == look.engine; });
        if (one == series.end()) continue;
        hasBox2d = hasBox2d || look.engine == "box2d";
        fmt::format_to(std::back_inserter(data), "${} << END\n", look.engine);
        for (const StepRecord& record : one->steps) {
            lastStep = std::max(lastStep, record.step);
            fmt::format_to(std::back_inserter(data), "{} {:.6f}\n", record.step, record.times.broadPhase);
        }
        data += "END\n";
        fmt::format_to(std::back_inserter(plots),
                       "{}${} with linespoints linecolor '{}' linewidth 1 pointtype {} pointsize 0.9 title '{}'",
                       plots.empty() ? "plot " : ", ", look.engine, look.color, look.pointType, look.title);
    }
    std::string script(header);
    fmt::format_to(std::back_inserter(script), "set output {}\nset title {} noenhanced\nset xrange [{}:{}]\n",
                   Quote(fs::absolute(picture).string()), Quote(title), -0.04 * lastStep, 1.04 * lastStep);
    if (hasBox2d) {
        fmt::format_to(std::back_inserter(script),
                       "set bmargin 5.5\nset label {} at screen 0.5,0.03 center font ',9' noenhanced\n",
                       Quote(boxTwoDNote));
    }
    return script + data + plots + "\n";
}

void DrawTimingPlot(std::span<const TimingSeries> series, const std::string& title, const fs::path& picture) {
    const TemporaryFiles files{picture.string() + ".gp", picture.string() + ".log"};
    WriteTextFile(files.script, MakeTimingScript(series, title, picture));
    const int status = RunGnuplot(files.script, files.log);
    if (status == 0 && fs::exists(picture)) return;
    std::ostringstream words;
    words << std::ifstream(files.log).rdbuf();
    throw ToolError(fmt::format("gnuplot could not draw {}: {}", picture.string(),
                                words.str().empty() ? "it did not start" : words.str()));
}

}  // namespace testbed
