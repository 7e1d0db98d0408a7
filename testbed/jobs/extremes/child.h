// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs this program again in processes of their own, so that a crash or a hang in one is a result and not the end.

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "testbed/jobs/extremes/outcome.h"

namespace testbed {

struct ChildJob {
    std::vector<std::string> arguments;  ///< of the program, without its name
    double wallSeconds = 60.0;           ///< after which it is killed, whatever it does
};

struct ChildEnd {
    Ending ending;
    std::string output;  ///< what it wrote to stdout
    std::string words;   ///< the last line it wrote to stderr
};

/// At most `parallel` at a time, started in order; `done` is called in the order in which they end. Throws ToolError
/// when the program cannot be started.
void RunChildren(std::span<const ChildJob> jobs, int parallel,
                 const std::function<void(std::size_t job, const ChildEnd& end)>& done);

/// For the child: no more processor time than this (it ends by SIGXCPU) nor more memory than a test machine has, and no
/// core file.
void LimitThisProcess(double cpuSeconds);

}  // namespace testbed
