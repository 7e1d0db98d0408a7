// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Sets that threads join at once are those of a search, and their lowest number stands for each.

#include "base/joined_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "base/task_pool.h"

namespace scree {
namespace {

enum class Number : int { none = -1 };

struct Pair {
    int a, b;
};

/// By passes over the pairs until nothing changes.
std::vector<int> FindLowest(int count, const std::vector<Pair>& pairs) {
    std::vector<int> lowest(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) lowest[static_cast<size_t>(i)] = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Pair& pair : pairs) {
            int &a = lowest[static_cast<size_t>(pair.a)], &b = lowest[static_cast<size_t>(pair.b)];
            changed = changed || a != b;
            a = b = std::min(a, b);
        }
    }
    return lowest;
}

TEST(JoinedSets, AreThoseOfASearchWhoeverJoinsThem) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
        const int count = 1 + below(4000);
        std::vector<Pair> pairs;
        const int far = seed % 3 == 0 ? 1 : count;  // long rows, or anything with anything
        for (int i = below(2 * count); i >= 0; --i) {
            const int a = below(count);
            pairs.push_back({a, std::min(count - 1, a + below(far + 1))});
            if (below(2) == 0) std::swap(pairs.back().a, pairs.back().b);
        }
        const std::vector<int> lowest = FindLowest(count, pairs);
        for (const int workers : {1, 2, 4}) {
            TaskPool pool(workers, {});
            pool.ShareAlways();
            pool.Begin();
            JoinedSets<Number> sets;
            sets.Reserve(static_cast<size_t>(count));
            for (int i = 0; i < count; ++i) sets.Begin(Number{i});
            pool.For(static_cast<int>(pairs.size()), 2, [&](int begin, int end, int /*worker*/) {
                for (int i = begin; i < end; ++i) {
                    const Pair& pair = pairs[static_cast<size_t>(i)];
                    sets.Join(Number{pair.a}, Number{pair.b});
                }
            });
            pool.End();
            for (int i = 0; i < count; ++i)
                ASSERT_EQ(ToInt(sets.Find(Number{i})), lowest[static_cast<size_t>(i)]) << seed << ' ' << workers;
        }
    }
}

}  // namespace
}  // namespace scree
