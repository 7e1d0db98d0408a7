// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The contact table against std::map: whatever is added and removed, every pair finds its own row and no other.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

#include "state/contacts.h"

namespace scree {
namespace {

using Key = std::pair<uint32_t, uint32_t>;

TEST(ContactTable, FindsWhatAMapFinds) {
    EXPECT_TRUE(rc::check("lookup equals std::map", [] {
        const auto range = *rc::gen::inRange<uint32_t>(2, 60);
        const auto actions = *rc::gen::inRange(1, 400);
        ContactTable table;
        std::map<Key, int> reference;
        for (int i = 0; i < actions; ++i) {
            const auto a = *rc::gen::inRange<uint32_t>(0, range);
            const auto b = *rc::gen::inRange<uint32_t>(0, range);
            if (a == b) continue;
            const Key key{std::min(a, b), std::max(a, b)};
            const auto found = reference.find(key);
            RC_ASSERT(table.Find(a, b) == (found == reference.end() ? -1 : found->second));
            RC_ASSERT(table.Find(b, a) == table.Find(a, b));
            if (found == reference.end()) {
                reference[key] = table.Add({a, b, 0, 1});
            } else {
                table.Remove(found->second);
                reference.erase(found);
                if (i % 5 == 0) table.Compact();
            }
            RC_ASSERT(table.Count() == static_cast<int>(reference.size()));
        }
        for (const auto& [key, row] : reference) RC_ASSERT(table.Find(key.first, key.second) == row);
    }));
}

TEST(ContactTable, LowestFreeRowIsTakenFirstAfterCompact) {
    ContactTable table;
    for (uint32_t i = 0; i < 10; ++i) table.Add({i, i + 100, 0, 1});
    table.Remove(7);
    table.Remove(2);
    table.Remove(9);
    table.Compact();
    EXPECT_EQ(table.Size(), 9);  // the trailing row is gone
    EXPECT_EQ(table.Add({50, 51, 0, 1}), 2);
    EXPECT_EQ(table.Add({52, 53, 0, 1}), 7);
    EXPECT_EQ(table.Add({54, 55, 0, 1}), 9);
}

TEST(ContactTable, ABodyWithManyContactsStaysFindable) {
    // All keys share one fixture: a hash that ignored the other would degenerate into one run.
    ContactTable table;
    constexpr uint32_t count = 100000;
    for (uint32_t i = 1; i <= count; ++i) table.Add({0, i, 0, 1});
    for (uint32_t i = 1; i <= count; ++i) ASSERT_EQ(table.Find(i, 0), static_cast<int>(i) - 1);
    EXPECT_EQ(table.Find(0, count + 1), -1);
}

TEST(ContactTable, ARowTakesAtMost128Bytes) { EXPECT_LE(ContactTable::GetBytesPerRow(), 128u); }

}  // namespace
}  // namespace scree
