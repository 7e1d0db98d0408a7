// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What measurements say of their machine, build and day.

#include "testbed/engines/provenance.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "testbed/engines/engine_list.h"
#include "tests/testbed/program.h"

namespace testbed {
namespace {

TEST(Provenance, HasNothingEmpty) {
    const Provenance p = FindProvenance();
    for (const std::string& text : {p.processor, p.compiler, p.flags, p.commit, p.date}) EXPECT_FALSE(text.empty());
    EXPECT_GE(p.cores, 1);
    EXPECT_GE(p.load, 0.0);
    EXPECT_TRUE(std::regex_match(p.date, std::regex("20[0-9]{2}-[01][0-9]-[0-3][0-9]"))) << p.date;
    EXPECT_EQ(p.versions.size(), GetEngines().size());
    EXPECT_EQ(ToJson(p)["versions"].size(), GetEngines().size());
}

TEST(Provenance, StandsInEveryLineAndOnThePage) {
    const ScratchFolder folder;
    ASSERT_EQ(folder.Run("bench tiles --sizes 3 --steps 2 --repeat 1 --json l.jsonl -o out").exitCode, 0);
    const nlohmann::json expected = ToJson(FindProvenance());
    std::istringstream lines(folder.Read("l.jsonl"));
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json made = nlohmann::json::parse(line).at("made");
        for (const char* key : {"processor", "compiler", "commit", "flags", "versions"})
            EXPECT_EQ(made[key], expected[key]);
    }
    const std::string page = folder.Read("out/index.html");
    EXPECT_NE(page.find(expected["commit"].get<std::string>()), std::string::npos);
    EXPECT_NE(page.find(expected["compiler"].get<std::string>()), std::string::npos);
}

}  // namespace
}  // namespace testbed
