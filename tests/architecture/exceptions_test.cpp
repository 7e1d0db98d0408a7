// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The engine compiles without exceptions and run-time type information: what would need them stands between macros of
// base/compiler.h. compat/ is not looked at.

#include <gtest/gtest.h>

#include <regex>

#include "source_tree.h"

namespace architecture {
namespace {

TEST(Exceptions, AreNotNeededByTheEngine) {
    const std::regex need(R"((^|[^A-Za-z0-9_"])(throw|try|catch|dynamic_cast|typeid)([^A-Za-z0-9_]|$))");
    int files = 0;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/src/") && !file.path.starts_with("engine/include/")) continue;
        ++files;
        bool isGuarded = false;
        int number = 0;
        for (const std::string& line : file.lines) {
            ++number;
            if (line.starts_with("#if defined(SCREE_HAS_EXCEPTIONS)") ||
                line.find("__cpp_exceptions") != std::string::npos)
                isGuarded = true;
            if (line.starts_with("#else") || line.starts_with("#endif")) isGuarded = false;
            const std::string code = line.substr(0, line.find("//"));
            EXPECT_TRUE(isGuarded || !std::regex_search(code, need)) << file.path << ':' << number << ": " << line;
        }
    }
    EXPECT_GT(files, 100);
}

}  // namespace
}  // namespace architecture
