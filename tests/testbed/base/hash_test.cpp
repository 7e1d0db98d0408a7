// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// FNV-1a gives the sums that its authors publish, and words show like bytes.

#include "testbed/base/hash.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <string_view>

namespace testbed {
namespace {

template <typename Word>
Word HashOf(std::string_view text) {
    Fnv1a<Word> hash;
    hash.Add(text);
    return hash.Get();
}

TEST(Fnv1a, HasThePublishedValues) {
    // http://www.isthe.com/chongo/src/fnv/test_fnv.c
    EXPECT_EQ(HashOf<uint32_t>(""), 0x811c9dc5u);
    EXPECT_EQ(HashOf<uint32_t>("a"), 0xe40c292cu);
    EXPECT_EQ(HashOf<uint32_t>("foobar"), 0xbf9cf968u);
    EXPECT_EQ(HashOf<uint64_t>(""), 0xcbf29ce484222325u);
    EXPECT_EQ(HashOf<uint64_t>("a"), 0xaf63dc4c8601ec8cu);
    EXPECT_EQ(HashOf<uint64_t>("foobar"), 0x85944171f73967e8u);
}

TEST(Fnv1a, TakesTheBytesOfAWordLowestFirst) {
    Fnv1a<uint64_t> hash;
    hash.AddBytes(0x626f6f66u);  // "foob"
    hash.Add(std::string_view("ar"));
    EXPECT_EQ(hash.Get(), HashOf<uint64_t>("foobar"));
}

TEST(Fnv1a, AChangedWordShows) {
    EXPECT_TRUE(rc::check("one word changed", [](uint64_t before, uint64_t word, uint64_t other, uint64_t after) {
        RC_PRE(word != other);
        Fnv1a<uint64_t> a, b;
        a.Add(before), b.Add(before);
        a.Add(word), b.Add(other);
        a.Add(after), b.Add(after);
        RC_ASSERT(a.Get() != b.Get());
    }));
}

}  // namespace
}  // namespace testbed
