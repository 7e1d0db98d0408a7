// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Every line of a file is read, and a bad one is named with what is wrong.

#include "testbed/base/json_lines.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"

namespace testbed {
namespace {

std::vector<int> ReadNumbers(const std::string& text) {
    std::vector<int> numbers;
    ParseJsonLines("f.jsonl", text, "find", [&](const auto& object) { numbers.push_back(object.at("n")); });
    return numbers;
}

TEST(JsonLines, AreReadInOrder) {
    EXPECT_EQ(ReadNumbers("{\"n\": 1}\n\n{\"n\": 2}\n{\"n\": 3}"), (std::vector{1, 2, 3}));
    EXPECT_TRUE(ReadNumbers("").empty());
}

TEST(JsonLines, ABadLineIsNamed) {
    for (const auto& [line, problem] : std::vector<std::pair<std::string, std::string>>{
             {"{", "parse error"}, {"[1]", "not a JSON object"}, {"{}", "'n' not found"}, {"{\"n\": \"x\"}", "type"}}) {
        try {
            (void)ReadNumbers("{\"n\": 1}\n" + line);
            ADD_FAILURE() << line;
        } catch (const FileError& error) {
            const std::string words = error.what();
            EXPECT_TRUE(words.starts_with("f.jsonl:2: not a line of `scree find --json`: ")) << words;
            EXPECT_NE(words.find(problem), std::string::npos) << words;
        }
    }
}

}  // namespace
}  // namespace testbed
