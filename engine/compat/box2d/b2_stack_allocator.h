// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An allocator for blocks freed in the reverse order of allocation.

#pragma once

#include "b2_api.h"
#include "b2_settings.h"

const int32 b2_stackSize = 100 * 1024;
const int32 b2_maxStackEntries = 32;

/// One block in use.
struct B2_API b2StackEntry {
    char* data;
    int32 size;
    bool usedMalloc;
};

class B2_API b2StackAllocator {
public:
    b2StackAllocator();
    ~b2StackAllocator();
    b2StackAllocator(const b2StackAllocator&) = delete;
    b2StackAllocator& operator=(const b2StackAllocator&) = delete;

    /// Null beyond b2_maxStackEntries blocks. What does not fit the stack comes from b2Alloc.
    void* Allocate(int32 size);
    /// Only the newest block; any other pointer is ignored.
    void Free(void* p);
    /// Most bytes ever in use at once.
    int32 GetMaxAllocation() const;

private:
    alignas(16) char m_data[b2_stackSize];
    int32 m_index;
    int32 m_allocation;
    int32 m_maxAllocation;
    b2StackEntry m_entries[b2_maxStackEntries];
    int32 m_entryCount;
};
