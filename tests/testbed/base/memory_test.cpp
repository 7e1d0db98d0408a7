// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Laws: freed memory that is kept costs no page faults when it is used again, and memory that was returned does. Sizes
// on both sides of the allocator's own limit. Sanitizers and other libraries have allocators that this is not about.

#include "testbed/base/memory.h"

#include <gtest/gtest.h>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <sys/resource.h>
#include <unistd.h>

#include <memory>

namespace testbed {
namespace {

/// Page faults of writing to every page of a new block, which is then freed.
long CountFaults(std::size_t bytes) {
    const auto now = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_minflt;
    };
    const long before = now();
    const std::unique_ptr<volatile char[]> block(new volatile char[bytes]);
    for (std::size_t i = 0; i < bytes; i += 4096) block[i] = 1;
    return now() - before;
}

TEST(Memory, KeptOrReturned) {
    KeepFreedMemory();
    for (const std::size_t bytes : {std::size_t{100} << 10, std::size_t{3} << 20, std::size_t{64} << 20}) {
        const long pages = static_cast<long>(bytes / 4096);
        (void)CountFaults(bytes);
        EXPECT_LE(CountFaults(bytes), pages / 10) << bytes;
    }
    ReturnFreedMemory();
    EXPECT_GE(CountFaults(std::size_t{64} << 20), 30);  // with pages of 2 MB, where the system has them
}

}  // namespace
}  // namespace testbed

#endif
