// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws: a page has the command first, then every member of a provenance; of several, each value stands once.

#include "testbed/page/facts.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace testbed {
namespace {

nlohmann::ordered_json Sample() {
    return {{"processor", "some one"}, {"cores", 2}, {"load", 0.5}, {"versions", {{"a", "1.0"}, {"b", "2.0"}}}};
}

TEST(Facts, OfOneRunFollowItsCommand) {
    Page page;
    AddFacts(page, "scree bench", Sample());
    const std::vector<std::pair<std::string, std::string>> expected = {{"command", "scree bench"},
                                                                       {"processor", "some one"},
                                                                       {"cores", "2"},
                                                                       {"load", "0.5"},
                                                                       {"versions", "a 1.0, b 2.0"}};
    ASSERT_EQ(page.facts.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(page.facts[i].name, expected[i].first);
        EXPECT_EQ(page.facts[i].value, expected[i].second);
    }
}

TEST(Facts, OfSeveralRunsEachValueStandsOnce) {
    nlohmann::ordered_json other = Sample();
    other["processor"] = "another one";
    const nlohmann::ordered_json all[] = {Sample(), other, Sample()};
    Page page;
    AddFacts(page, all);
    ASSERT_EQ(page.facts.size(), Sample().size());
    EXPECT_EQ(page.facts.front().value, "some one; another one");
    for (std::size_t i = 1; i < page.facts.size(); ++i) EXPECT_EQ(page.facts[i].value.find(';'), std::string::npos);
}

}  // namespace
}  // namespace testbed
