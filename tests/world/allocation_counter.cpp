// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Replaces the global allocation functions; kept out of line in a file of its own, so that the compiler always sees
// matching pairs of new and delete elsewhere.

#include "tests/world/allocation_counter.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
std::atomic<long> bytes{0};
std::atomic<long> untilFailure{-1};
}  // namespace

namespace scree::test {
long AllocationCount() { return allocations; }
long AllocatedBytes() { return bytes; }
void FailAllocation(long count) { untilFailure = count; }
}  // namespace scree::test

namespace {

void* Allocate(std::size_t size, std::size_t alignment) {
    ++allocations;
    if (untilFailure >= 0 && untilFailure-- == 0) throw std::bad_alloc();
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    void* p = alignment > __STDCPP_DEFAULT_NEW_ALIGNMENT__ ? std::aligned_alloc(alignment, rounded) : std::malloc(size);
    if (p == nullptr) throw std::bad_alloc();
    bytes += static_cast<long>(malloc_usable_size(p));
    return p;
}

void Free(void* p) noexcept {
    if (p != nullptr) bytes -= static_cast<long>(malloc_usable_size(p));
    std::free(p);
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size, 1); }
// Algorithms of the library that want a buffer ask in this way.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    try {
        return Allocate(size, 1);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return Allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* p) noexcept { Free(p); }
void operator delete(void* p, std::size_t) noexcept { Free(p); }
void operator delete(void* p, std::align_val_t) noexcept { Free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { Free(p); }
