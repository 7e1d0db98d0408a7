// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What an index of one kind may not do, as the compiler sees it; columns against vectors.

#include "base/index.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "base/slots.h"
#include "state/indices.h"

namespace scree {
namespace {

template <typename Rows, typename I>
concept TakesIndex = requires(Rows rows, I index) {
    rows[index];
};
template <typename A, typename B>
concept Compares = requires(A a, B b) {
    a == b;
};

using BodyColumn = Column<BodyIndex, float>;
static_assert(TakesIndex<BodyColumn, BodyIndex> && TakesIndex<const BodyColumn, BodyIndex>);
static_assert(!TakesIndex<BodyColumn, ContactIndex> && !TakesIndex<BodyColumn, FixtureIndex>);
static_assert(!TakesIndex<BodyColumn, JointIndex> && !TakesIndex<BodyColumn, MoverRow>);
static_assert(!TakesIndex<BodyColumn, int> && !TakesIndex<BodyColumn, size_t>);
static_assert(!TakesIndex<StableColumn<ContactNumber, float>, ContactIndex>);
static_assert(!TakesIndex<std::vector<float>, BodyIndex> && !TakesIndex<float*, BodyIndex>);
static_assert(TakesIndex<Column<int, float>, int> && !TakesIndex<Column<int, float>, BodyIndex>);

static_assert(!std::is_convertible_v<int, BodyIndex> && !std::is_convertible_v<BodyIndex, int>);
static_assert(!std::is_convertible_v<ContactIndex, BodyIndex> && !Compares<BodyIndex, ContactIndex>);
static_assert(!std::is_convertible_v<BodyColumn, std::vector<float>>);

static_assert(sizeof(BodyIndex) == sizeof(int) && std::is_trivially_copyable_v<BodyIndex>);
static_assert(ToInt(BodyIndex::none) == -1 && IsNone(BodyIndex::none) && IsSome(BodyIndex{0}));
static_assert(NextOf(BodyIndex{6}) == BodyIndex{7} && BodyIndex{6} < BodyIndex{7} && ToSize(BodyIndex{6}) == 6);

TEST(Column, HasTheRowsOfAVector) {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        Column<JointIndex, int> column;
        std::vector<int> vector;
        for (size_t i = random() % 40; i > 0; --i) {
            const int value = static_cast<int>(random() % 1000);
            EXPECT_EQ(ToSize(column.End()), vector.size());
            column.push_back(value), vector.push_back(value);
        }
        size_t walked = 0;
        for (const JointIndex joint : column.Rows()) {
            ASSERT_EQ(ToSize(joint), walked);
            EXPECT_EQ(column[joint], vector[walked]);
            EXPECT_TRUE(column.Has(joint));
            ++walked;
        }
        EXPECT_EQ(walked, vector.size());
        EXPECT_FALSE(column.Has(JointIndex::none) || column.Has(column.End()));
        EXPECT_FALSE(column.Has(JointIndex{std::numeric_limits<int>::min()}));
    }
}

TEST(Column, GrowsToHoldARow) {
    Column<ContactIndex, int> column;
    EnsureRow(column, ContactIndex{4}, 7);
    EXPECT_EQ(column, (Column<ContactIndex, int>{7, 7, 7, 7, 7}));
    EnsureRow(column, ContactIndex{2}, 9);
    EXPECT_EQ(column.size(), 5u) << "it is there";
}

TEST(Slots, HandOutTheIndexThatWasFreedLast) {
    Slots<FixtureIndex> slots;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(slots.Allocate(), FixtureIndex{i});
    slots.Free(FixtureIndex{0}), slots.Free(FixtureIndex{2});
    EXPECT_FALSE(slots.IsAlive(FixtureIndex{2}) || slots.IsAlive(FixtureIndex::none));
    EXPECT_EQ(slots.Prepare(), FixtureIndex{2});
    EXPECT_EQ(slots.Allocate(), FixtureIndex{2});
    EXPECT_EQ(slots.GetGeneration(FixtureIndex{2}), 1u);
    EXPECT_TRUE(slots.IsConsistent());
}

}  // namespace
}  // namespace scree
