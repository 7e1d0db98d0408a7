// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of heap_meter.h. The C library's allocation functions are replaced in the whole process, for libbox2d
// too. The replacements count the usable bytes of every block and call those of glibc. So blocks that live only within
// a step are seen, and blocks that the allocator keeps for itself are not. The process has one counter, in this file,
// since an allocation has no owner that could carry it.

#include "testbed/engines/heap_meter.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace testbed {
namespace {

constinit std::atomic<int64_t> inUse{0};
constinit std::atomic<int64_t> most{0};

}  // namespace

int64_t HeapBytesInUse() { return inUse.load(std::memory_order_relaxed); }

int64_t HeapBytesPeak() { return most.load(std::memory_order_relaxed); }

void ResetHeapPeak() { most.store(HeapBytesInUse(), std::memory_order_relaxed); }

}  // namespace testbed

// A sanitizer brings its own allocator.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

extern "C" {

void* __libc_malloc(size_t size) noexcept;
void* __libc_calloc(size_t count, size_t size) noexcept;
void* __libc_realloc(void* block, size_t size) noexcept;
void* __libc_memalign(size_t alignment, size_t size) noexcept;
void __libc_free(void* block) noexcept;

}  // extern "C"

namespace {

void Count(int64_t bytes) noexcept {
    const int64_t now = testbed::inUse.fetch_add(bytes, std::memory_order_relaxed) + bytes;
    int64_t highest = testbed::most.load(std::memory_order_relaxed);
    while (now > highest && !testbed::most.compare_exchange_weak(highest, now, std::memory_order_relaxed)) {
    }
}

int64_t SizeOf(void* block) noexcept { return static_cast<int64_t>(malloc_usable_size(block)); }

void* Counted(void* block) noexcept {
    Count(SizeOf(block));
    return block;
}

}  // namespace

extern "C" {

void* malloc(size_t size) noexcept { return Counted(__libc_malloc(size)); }

void* calloc(size_t count, size_t size) noexcept { return Counted(__libc_calloc(count, size)); }

void* realloc(void* block, size_t size) noexcept {
    const int64_t before = SizeOf(block);
    void* moved = __libc_realloc(block, size);
    // A failed call leaves the old block as it was; size 0 frees it.
    if (moved != nullptr || size == 0) Count(SizeOf(moved) - before);
    return moved;
}

void* memalign(size_t alignment, size_t size) noexcept { return Counted(__libc_memalign(alignment, size)); }

void* aligned_alloc(size_t alignment, size_t size) noexcept { return Counted(__libc_memalign(alignment, size)); }

int posix_memalign(void** block, size_t alignment, size_t size) noexcept {
    if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) return EINVAL;
    void* made = Counted(__libc_memalign(alignment, size));
    if (made == nullptr) return ENOMEM;
    *block = made;
    return 0;
}

void free(void* block) noexcept {
    Count(-SizeOf(block));
    __libc_free(block);
}

}  // extern "C"

#endif
