// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Differences of arrays of any size and likeness give back what they were made of.

#include "base/byte_difference.h"

#include <gtest/gtest.h>

#include <random>

namespace scree::test {
namespace {

using Array = std::vector<std::byte>;

Array RandomArray(std::mt19937& random, size_t size) {
    Array array(size);
    for (std::byte& byte : array) byte = static_cast<std::byte>(random());
    return array;
}

/// Changes about one byte in `every`.
Array Changed(std::mt19937& random, const Array& base, size_t size, uint32_t every) {
    Array now = base;
    now.resize(size);
    for (std::byte& byte : now) {
        if (random() % every == 0) byte = static_cast<std::byte>(random());
    }
    return now;
}

Array ReadBack(DifferenceReader& reader, const Array& base) {
    Array read(reader.NextSize(), std::byte{0xA5});
    reader.Read(base, read);
    return read;
}

TEST(ByteDifference, GivesBackArraysOfAnySizeAndLikeness) {
    std::mt19937 random(4);
    for (int trial = 0; trial < 3000; ++trial) {
        std::vector<Array> bases, arrays;
        DifferenceWriter::Bytes bytes;
        DifferenceWriter writer(bytes);
        for (uint32_t count = 1 + random() % 5; count > 0; --count) {
            const size_t size = random() % 700, other = random() % 3 == 0 ? random() % 700 : size;
            bases.push_back(RandomArray(random, size));
            arrays.push_back(Changed(random, bases.back(), other, 1u << random() % 12));
            writer.Add(bases.back(), arrays.back());
        }
        DifferenceReader reader(bytes);
        for (size_t i = 0; i < arrays.size(); ++i) ASSERT_EQ(ReadBack(reader, bases[i]), arrays[i]) << trial;
    }
}

TEST(ByteDifference, HoldsOnlyTheWordsThatChanged) {
    std::mt19937 random(5);
    const Array base = RandomArray(random, 6400);
    Array now = base;
    DifferenceWriter::Bytes bytes;
    DifferenceWriter(bytes).Add(base, now);
    const size_t ofNone = bytes.size();
    EXPECT_LT(ofNone, 40);
    for (size_t word = 0; word < 10; ++word) now[640 * word + 5] ^= std::byte{1};  // each in a block of its own
    DifferenceWriter(bytes).Add(base, now);
    EXPECT_LE(bytes.size(), ofNone + 10 * (2 + 4 + 4));
}

TEST(ByteDifference, LongRunsOfEqualBlocksArePutTogether) {
    std::mt19937 random(6);
    const Array base = RandomArray(random, 64 * 200001 + 7);
    Array now = base;
    now.back() ^= std::byte{1};
    now[64 * 70000] ^= std::byte{1};
    DifferenceWriter::Bytes bytes;
    DifferenceWriter(bytes).Add(base, now);
    EXPECT_LT(bytes.size(), 80);
    DifferenceReader reader(bytes);
    EXPECT_EQ(ReadBack(reader, base), now);
}

}  // namespace
}  // namespace scree::test
