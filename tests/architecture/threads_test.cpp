// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The engine compiles where the standard library has neither threads nor mutexes, as for WebAssembly: what names them
// stands between macros of base/compiler.h. compat/ is not looked at.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "source_tree.h"

namespace architecture {
namespace {

TEST(Threads, AreNotNeededByTheEngine) {
    const std::regex need(
        "std::(this_thread|j?thread|(shared_|timed_|recursive_)?mutex|(lock|scoped|unique|shared)_(guard|lock)|"
        "condition_variable|once_flag|call_once|future|async|barrier|latch)|"
        "#include <(thread|mutex|shared_mutex|condition_variable|future|barrier|latch|semaphore|stop_token)>");
    int files = 0, guarded = 0;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/src/") && !file.path.starts_with("engine/include/")) continue;
        ++files;
        std::vector<bool> isGuard;  // of the conditions around the line
        int number = 0;
        for (const std::string& line : file.lines) {
            ++number;
            if (line.starts_with("#if")) {
                isGuard.push_back(line.starts_with("#if defined(SCREE_HAS_MUTEXES)") ||
                                  line.starts_with("#if defined(SCREE_HAS_THREADS)"));
            } else if (line.starts_with("#el") && !isGuard.empty()) {
                isGuard.back() = false;
            } else if (line.starts_with("#endif") && !isGuard.empty()) {
                isGuard.pop_back();
            }
            const std::string code = line.substr(0, line.find("//"));
            if (!std::regex_search(code, need)) continue;
            const bool isGuarded = std::find(isGuard.begin(), isGuard.end(), true) != isGuard.end();
            guarded += isGuarded ? 1 : 0;
            EXPECT_TRUE(isGuarded) << file.path << ':' << number << ": " << line;
        }
    }
    EXPECT_GT(files, 100);
    EXPECT_GT(guarded, 3);
}

}  // namespace
}  // namespace architecture
