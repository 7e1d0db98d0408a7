// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What parts keep stands in order, whatever the number of threads; against std::copy_if.

#include "base/gather_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace scree {
namespace {

TEST(Parts, CoverTheRangeInOrder) {
    TaskPool pool(8, {});
    pool.Begin();
    for (const int count : {0, 1, 63, 64, 1000, 4095, 100000}) {
        const Parts parts(pool, count, 500);
        EXPECT_EQ(parts.Count() > 1, count >= 500);
        std::vector<int> owner(ToSize(count), -1);
        parts.For(pool,
                  [&](int part, int begin, int end) { std::fill(owner.begin() + begin, owner.begin() + end, part); });
        EXPECT_TRUE(std::ranges::is_sorted(owner)) << count;
        EXPECT_EQ(std::ranges::count(owner, -1), 0) << count;
    }
    pool.End();
}

TEST(GatherParts, KeepWhatOneThreadWould) {
    std::mt19937 random(7);
    for (const int workers : {1, 2, 4, 8}) {
        TaskPool pool(workers, {});
        pool.ShareAlways();
        pool.Begin();
        std::vector<int> kept, rest, scratch;
        for (int round = 0; round < 40; ++round) {
            const int count = std::uniform_int_distribution(0, 5000)(random);
            const int share = std::uniform_int_distribution(0, 10)(random);
            std::vector<int> numbers(ToSize(count));
            for (int& number : numbers) number = std::uniform_int_distribution(0, 9)(random);
            std::vector<int> expectedKept, expectedRest;
            for (const int number : numbers) (number < share ? expectedKept : expectedRest).push_back(number);
            GatherParts<int, 2>(
                pool, count, 100, {&kept, &rest}, [&](int begin, int end, const std::array<int*, 2>& places) {
                    int *yes = places[0], *no = places[1];
                    for (int i = begin; i < end; ++i)
                        (numbers[ToSize(i)] < share ? *yes++ : *no++) = numbers[ToSize(i)];
                    return std::array{static_cast<size_t>(yes - places[0]), static_cast<size_t>(no - places[1])};
                });
            EXPECT_EQ(kept, expectedKept) << workers << " workers, " << count << " numbers";
            EXPECT_EQ(rest, expectedRest) << workers << " workers, " << count << " numbers";
            const auto [used] = WriteParts<int, 1>(
                pool, count, 100, {&scratch}, [&](int begin, int end, const std::array<int*, 1>& places) {
                    const auto isKept = [&](int number) { return number < share; };
                    const auto out = std::copy_if(numbers.begin() + begin, numbers.begin() + end, places[0], isKept);
                    return std::array{static_cast<size_t>(out - places[0])};
                });
            scratch.resize(std::max(scratch.size(), used));
            EXPECT_TRUE(std::equal(expectedKept.begin(), expectedKept.end(), scratch.begin(),
                                   scratch.begin() + static_cast<ptrdiff_t>(used)));
        }
        pool.End();
    }
}

TEST(AllOf, FindsTheOneThatDoesNotHold) {
    std::mt19937 random(8);
    for (const int workers : {1, 2, 4, 8}) {
        TaskPool pool(workers, {});
        pool.Begin();
        for (int round = 0; round < 60; ++round) {
            const int count = std::uniform_int_distribution(0, 3000)(random);
            std::vector<uint8_t> holds(ToSize(count), 1);
            const int wrong = std::min(count, std::uniform_int_distribution(0, 2)(random));
            for (int i = 0; i < wrong; ++i) holds[random() % ToSize(count)] = 0;
            const auto all = [&](int begin, int end) {
                return std::ranges::count(holds.begin() + begin, holds.begin() + end, 0) == 0;
            };
            EXPECT_EQ(AllOf(pool, count, 100, all), wrong == 0) << workers << " workers, " << count << " items";
        }
        pool.End();
    }
}

}  // namespace
}  // namespace scree
