// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Each program of programs/ runs in both builds; every line it prints must agree: words exactly, numbers within the
// tolerance that the program states.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Output {
    int status = 0;
    std::vector<std::string> lines;
};

Output RunProgram(const std::string& program, const std::string& argument) {
    Output output;
    FILE* pipe = popen(("'" + program + "' " + argument + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return {-1, {}};
    std::string text;
    std::array<char, 4096> buffer;
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
    output.status = pclose(pipe);
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) output.lines.push_back(line);
    return output;
}

/// "~ name of it value tolerance"
struct NumberLine {
    std::string name;
    double value = 0.0, tolerance = 0.0;
};

NumberLine Parse(const std::string& line) {
    const size_t last = line.rfind(' ');
    const size_t middle = line.rfind(' ', last - 1);
    return {line.substr(0, middle), std::stod(line.substr(middle + 1)), std::stod(line.substr(last + 1))};
}

bool Agree(const std::string& theirs, const std::string& ours) {
    if (!theirs.starts_with('~') || !ours.starts_with('~')) return theirs == ours;
    const NumberLine a = Parse(theirs);
    const NumberLine b = Parse(ours);
    return a.name == b.name && std::abs(a.value - b.value) <= a.tolerance;
}

void ExpectAgreement(const Output& wanted, const Output& got) {
    ASSERT_EQ(wanted.status, 0);
    ASSERT_EQ(got.status, 0) << (got.lines.empty() ? "" : got.lines.back());
    EXPECT_FALSE(wanted.lines.empty());
    EXPECT_EQ(wanted.lines.size(), got.lines.size());
    for (size_t i = 0; i < std::min(wanted.lines.size(), got.lines.size()); ++i) {
        EXPECT_TRUE(Agree(wanted.lines[i], got.lines[i]))
            << "wanted: " << wanted.lines[i] << "\ngot:    " << got.lines[i];
    }
}

class Agreement : public testing::TestWithParam<std::string> {};

TEST_P(Agreement, BothBuildsSayTheSame) {
    ExpectAgreement(RunProgram(SCREE_PROGRAMS_BOX2D, GetParam()), RunProgram(SCREE_PROGRAMS_SCREE, GetParam()));
}

TEST(LengthUnits, ChangeNothingButTheUnit) {
    const Output metres = RunProgram(SCREE_UNITS "metres", "");
    EXPECT_GT(metres.lines.size(), 100u);
    for (const char* unit : {"pixels", "kilometres"}) {
        SCOPED_TRACE(unit);
        ExpectAgreement(metres, RunProgram(std::string(SCREE_UNITS) + unit, ""));
    }
}

INSTANTIATE_TEST_SUITE_P(Programs, Agreement, testing::ValuesIn(RunProgram(SCREE_PROGRAMS_SCREE, "--list").lines),
                         [](const auto& tested) { return tested.param; });

}  // namespace
