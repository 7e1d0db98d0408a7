// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The engine calls no function whose last digit depends on the system's
// library: sine, arc tangent and their like. The square root is exact
// everywhere. compat/ is not looked at: Box2D's own formulas stand there.

#include <gtest/gtest.h>

#include <regex>

#include "source_tree.h"

namespace architecture {
namespace {

TEST(Arithmetic, TheEngineCallsNoTranscendentalFunctionOfTheSystem) {
    const std::regex call(
        R"((^|[^A-Za-z0-9_.>])(std::|::)?(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|sincos|erf|tgamma|lgamma)[fl]?\()");
    int files = 0;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with("engine/src/") && !file.path.starts_with("engine/include/")) continue;
        ++files;
        int number = 0;
        for (const std::string& line : file.lines) {
            ++number;
            const std::string code = line.substr(0, line.find("//"));
            EXPECT_FALSE(std::regex_search(code, call)) << file.path << ':' << number << ": " << line;
        }
    }
    EXPECT_GT(files, 100);
}

}  // namespace
}  // namespace architecture
