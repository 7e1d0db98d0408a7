// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Replaces the global allocation functions; kept out of line in a file of its own, so that the compiler always sees
// matching pairs of new and delete elsewhere.

#include "tests/world/allocation_counter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
}

namespace scree::test {
long AllocationCount() { return allocations; }
}  // namespace scree::test

void* operator new(std::size_t size) {
    ++allocations;
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
