// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// An allocator of small blocks by size class. The world clones shapes with one; programs may use their own.

#pragma once

#include "b2_api.h"
#include "b2_settings.h"

/// Number of size classes.
const int32 b2_blockSizeCount = 14;

struct b2Block;
struct b2Chunk;

class B2_API b2BlockAllocator {
public:
    b2BlockAllocator();
    ~b2BlockAllocator();
    b2BlockAllocator(const b2BlockAllocator&) = delete;
    b2BlockAllocator& operator=(const b2BlockAllocator&) = delete;

    /// Null for a size of 0 or less. Sizes above the largest class come from b2Alloc.
    void* Allocate(int32 size);
    /// `size` as given to Allocate.
    void Free(void* p, int32 size);
    /// Takes back every small block at once.
    void Clear();

private:
    b2Chunk* m_chunks;
    b2Block* m_freeLists[b2_blockSizeCount];
};
