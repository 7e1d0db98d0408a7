// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Law: the table from fixtures to slots answers like a standard map after any sequence of sets and erasures, with small
// (direct) and large (hashed) indices mixed.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <unordered_map>

#include "broad_phase/fixture_table.h"

namespace scree::test {
namespace {

TEST(FixtureTable, AnswersLikeAMap) {
    EXPECT_TRUE(rc::check("table equals a map", [] {
        broadphase::FixtureTable table;
        std::unordered_map<uint32_t, uint32_t> map;
        const auto base = *rc::gen::element(0u, broadphase::FixtureTable::directLimit - 20u, 0xFFFFFF00u);
        const auto steps = *rc::gen::container<std::vector<std::pair<uint32_t, bool>>>(
            rc::gen::pair(rc::gen::inRange(0u, 40u), rc::gen::arbitrary<bool>()));
        uint32_t slot = 0;
        for (const auto& [offset, set] : steps) {
            const uint32_t fixture = base + offset;
            if (set) {
                table.Set(fixture, slot);
                map[fixture] = slot++;
            } else {
                table.Erase(fixture);
                map.erase(fixture);
            }
            for (uint32_t i = 0; i < 40; ++i) {
                const auto found = map.find(base + i);
                RC_ASSERT(table.Find(base + i) == (found == map.end() ? broadphase::noSlot : found->second));
            }
        }
    }));
}

TEST(FixtureTable, GrowsWithManyLargeIndices) {
    broadphase::FixtureTable table;
    for (uint32_t i = 0; i < 5000; ++i) table.Set(0x80000000u + 7919u * i, i);
    for (uint32_t i = 0; i < 5000; i += 2) table.Erase(0x80000000u + 7919u * i);
    for (uint32_t i = 0; i < 5000; ++i) {
        EXPECT_EQ(table.Find(0x80000000u + 7919u * i), i % 2 == 0 ? broadphase::noSlot : i);
    }
}

}  // namespace
}  // namespace scree::test
