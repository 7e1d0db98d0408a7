// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of gnuplot.h.

#include "testbed/page/gnuplot.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <system_error>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"

extern char** environ;

namespace testbed {

namespace fs = std::filesystem;

namespace {

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
int Run(const fs::path& script, const fs::path& log) {
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
    if (IsInstalled("gnuplot")) return;
    throw ToolError("gnuplot draws the plots and is not installed; install it with: apt-get install gnuplot-nox");
}

std::string QuoteForGnuplot(std::string_view text) {
    // In single quotes only the quote itself is special.
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c;
        if (c == '\'') quoted += c;
    }
    return quoted + "'";
}

void RunGnuplot(const std::string& script, const fs::path& picture) {
    const TemporaryFiles files{picture.string() + ".gp", picture.string() + ".log"};
    WriteTextFile(files.script, script);
    const int status = Run(files.script, files.log);
    if (status == 0 && fs::exists(picture)) return;
    std::ostringstream words;
    words << std::ifstream(files.log).rdbuf();
    throw ToolError(fmt::format("gnuplot could not draw {}: {}", picture.string(),
                                words.str().empty() ? "it did not start" : words.str()));
}

}  // namespace testbed
