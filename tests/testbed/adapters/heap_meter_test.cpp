// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The meter sees what is allocated inside its calls and nothing else.

#include "testbed/adapters/heap_meter.h"

#include <gtest/gtest.h>

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
#endif
