// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The meter sees what is allocated inside its calls and nothing else.

#include "testbed/engines/heap_meter.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <memory>

using namespace testbed;

// A sanitizer brings its own allocator, of which the C library counts nothing.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(HeapMeter, CountsOnlyInsideItsCalls) {
    auto probe = std::make_unique<char[]>(1000);
    // Small enough for the heap, large enough for a mapping of its own: both must count.
    for (const size_t size : {size_t{50'000}, size_t{5'000'000}}) {
        HeapMeter meter;
        std::unique_ptr<char[]> inside;
        meter.Measure([&] { inside = std::make_unique<char[]>(size); });
        const auto outside = std::make_unique<char[]>(size);
        EXPECT_GE(meter.GetBytes(), static_cast<int64_t>(size));
        // A block costs a header and at most one page of rounding.
        EXPECT_LE(meter.GetBytes(), static_cast<int64_t>(size) + 2 * 4096);
        meter.Measure([&] { inside.reset(); });
        EXPECT_EQ(meter.GetBytes(), 0);
    }
}

TEST(HeapMeter, SeesBlocksThatLiveOnlyWithinACall) {
    constexpr size_t size = 3'000'000, kept = 1'000'000;
    const auto outside = std::make_unique<char[]>(2 * size);
    HeapMeter meter;
    std::unique_ptr<char[]> inside;
    meter.Measure([&] { inside = std::make_unique<char[]>(kept); });
    meter.Measure([&] { std::make_unique<char[]>(size).reset(); });
    EXPECT_GE(meter.GetPeakBytes(), static_cast<int64_t>(kept + size));
    EXPECT_LE(meter.GetPeakBytes(), static_cast<int64_t>(kept + size) + 4 * 4096);
    EXPECT_LE(meter.GetBytes(), static_cast<int64_t>(kept) + 2 * 4096);
    meter.Measure([&] { inside.reset(); });
    EXPECT_EQ(meter.GetBytes(), 0);
}

TEST(HeapMeter, CountsEverySiblingOfMalloc) {
    constexpr size_t size = 40'000;
    const auto grown = [](auto&& call) {
        HeapMeter meter;
        meter.Measure(call);
        return meter.GetBytes();
    };
    void* block = nullptr;
    const auto expectBlock = [&](int64_t bytes) {
        EXPECT_GE(bytes, static_cast<int64_t>(size));
        EXPECT_LE(bytes, static_cast<int64_t>(size) + 4096);
    };
    const auto release = [&] { std::free(block); };
    expectBlock(grown([&] { block = std::calloc(size, 1); }));
    EXPECT_EQ(grown([&] { block = std::realloc(block, 3 * size); }) / static_cast<int64_t>(size), 2);
    EXPECT_LE(grown(release), -static_cast<int64_t>(3 * size));
    expectBlock(grown([&] { block = std::aligned_alloc(64, size); }));
    grown(release);
    expectBlock(grown([&] { EXPECT_EQ(posix_memalign(&block, 4096, size), 0); }));
    EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % 4096, 0u);
    grown(release);
    EXPECT_EQ(posix_memalign(&block, 3, size), EINVAL);
}
#endif
