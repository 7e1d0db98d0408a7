// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Damage to a file for the tests of its reader: flips, cuts, splices, and values that hurt readers where one is read.

#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

namespace testbed {

inline std::size_t Below(std::size_t end, std::mt19937& random) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

/// Damages `text` one to three times. replaceValue(text, at) puts something hostile in the place of a value at or
/// behind `at`. It is chosen as often as each other kind of damage, times `weight`.
template <typename Replace>
void Damage(std::string& text, std::mt19937& random, std::size_t weight, Replace&& replaceValue) {
    const int times = 1 + static_cast<int>(Below(3, random));
    for (int i = 0; i < times && !text.empty(); ++i) {
        const std::size_t at = Below(text.size(), random);
        switch (Below(4 + weight, random)) {
            case 0:
                text[at] = static_cast<char>(text[at] ^ (1 << Below(8, random)));
                break;
            case 1:
                text.erase(at, 1 + Below(40, random));
                break;
            case 2:
                text.insert(at, text.substr(Below(text.size(), random), 1 + Below(60, random)));
                break;
            case 3:
                text.resize(at);
                break;
            default:
                replaceValue(text, at);
        }
    }
}

/// How many damaged files a test reads: SCREE_MUTATIONS asks for more, for long runs.
inline int CountOfMutations(int usual) {
    const char* asked = std::getenv("SCREE_MUTATIONS");
    return asked != nullptr ? std::atoi(asked) : usual;
}

/// What came of them, for the table that tests/fuzz/mutations writes.
inline void RecordMutations(int count, int refused) {
    testing::Test::RecordProperty("damaged", count);
    testing::Test::RecordProperty("refused", refused);
}

}  // namespace testbed
