// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Room for elements: who needs it has it, whoever asked for it first.

#include "base/bytes.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace scree {
namespace {

struct Row {
    std::vector<int> numbers, found;

    void MatchRoomOf(const Row& other) { MatchRoom(numbers, other.numbers); }
};

TEST(Bytes, EachRowHasTheRoomOfTheLargest) {
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round) {
        std::vector<Row> rows(std::uniform_int_distribution<size_t>(1, 9)(random));
        size_t largest = 0;
        for (Row& row : rows) {
            row.numbers.resize(std::uniform_int_distribution<size_t>(0, 1000)(random), 5);
            largest = std::max(largest, row.numbers.size());
        }
        const std::vector<Row> before = rows;
        MatchRooms(rows);
        for (size_t i = 0; i < rows.size(); ++i) {
            EXPECT_GE(rows[i].numbers.capacity(), largest);
            EXPECT_EQ(rows[i].numbers, before[i].numbers);
        }
    }
}

TEST(Bytes, OneRowHasRoomForWhatAllHaveFound) {
    std::mt19937 random(4);
    for (int round = 0; round < 100; ++round) {
        std::vector<Row> rows(std::uniform_int_distribution<size_t>(1, 9)(random));
        size_t all = 0;
        for (Row& row : rows) {
            row.found.resize(std::uniform_int_distribution<size_t>(0, 1000)(random));
            all += row.found.size();
        }
        ReserveEach(rows, &Row::found, all);
        for (Row& row : rows) {
            EXPECT_GE(row.found.capacity(), all);
            const int* const place = row.found.data();
            row.found.resize(all);
            EXPECT_EQ(row.found.data(), place) << "nothing is allocated for it";
        }
    }
}

}  // namespace
}  // namespace scree
