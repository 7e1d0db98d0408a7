// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Block allocator: free lists per size class, carved from chunks. Stack allocator: a bump pointer with a list of what
// is in use.

#include <cstddef>
#include <iterator>

#include "../box2d/b2_block_allocator.h"
#include "../box2d/b2_stack_allocator.h"

/// A free block.
struct b2Block {
    b2Block* next;
};

/// A piece of memory that blocks are cut from; the blocks follow it.
struct alignas(std::max_align_t) b2Chunk {
    b2Chunk* next;
};

namespace {

constexpr int32 chunkSize = 16 * 1024;
/// Bytes of a block in each class: fine steps for small objects, coarse ones for large.
constexpr int32 blockSizes[b2_blockSizeCount] = {16, 32, 64, 96, 128, 160, 192, 224, 256, 320, 384, 448, 512, 640};

/// The smallest class that holds `size`, or b2_blockSizeCount.
int32 ClassOf(int32 size) {
    int32 index = 0;
    while (index < b2_blockSizeCount && blockSizes[index] < size) ++index;
    return index;
}

}  // namespace

b2BlockAllocator::b2BlockAllocator() : m_chunks(nullptr), m_freeLists{} {}
b2BlockAllocator::~b2BlockAllocator() { Clear(); }

void* b2BlockAllocator::Allocate(int32 size) {
    if (size <= 0) return nullptr;
    const int32 index = ClassOf(size);
    if (index == b2_blockSizeCount) return b2Alloc(size);
    if (m_freeLists[index] == nullptr) {
        auto* chunk = static_cast<b2Chunk*>(b2Alloc(chunkSize));
        chunk->next = m_chunks;
        m_chunks = chunk;
        char* memory = reinterpret_cast<char*>(chunk);
        for (int32 at = static_cast<int32>(sizeof(b2Chunk)); at + blockSizes[index] <= chunkSize;
             at += blockSizes[index]) {
            auto* block = reinterpret_cast<b2Block*>(memory + at);
            block->next = m_freeLists[index];
            m_freeLists[index] = block;
        }
    }
    b2Block* block = m_freeLists[index];
    m_freeLists[index] = block->next;
    return block;
}

void b2BlockAllocator::Free(void* p, int32 size) {
    if (p == nullptr || size <= 0) return;
    const int32 index = ClassOf(size);
    if (index == b2_blockSizeCount) return b2Free(p);
    auto* block = static_cast<b2Block*>(p);
    block->next = m_freeLists[index];
    m_freeLists[index] = block;
}

void b2BlockAllocator::Clear() {
    while (m_chunks != nullptr) {
        b2Chunk* next = m_chunks->next;
        b2Free(m_chunks);
        m_chunks = next;
    }
    for (b2Block*& list : m_freeLists) list = nullptr;
}

b2StackAllocator::b2StackAllocator() : m_index(0), m_allocation(0), m_maxAllocation(0), m_entryCount(0) {}

b2StackAllocator::~b2StackAllocator() {
    while (m_entryCount > 0) Free(m_entries[m_entryCount - 1].data);
}

void* b2StackAllocator::Allocate(int32 size) {
    if (m_entryCount == b2_maxStackEntries || size < 0) return nullptr;
    b2StackEntry& entry = m_entries[m_entryCount++];
    entry.size = size;
    entry.usedMalloc = size > b2_stackSize - m_index;
    entry.data = entry.usedMalloc ? static_cast<char*>(b2Alloc(size)) : m_data + m_index;
    if (!entry.usedMalloc) m_index += size;
    m_allocation += size;
    if (m_allocation > m_maxAllocation) m_maxAllocation = m_allocation;
    return entry.data;
}

void b2StackAllocator::Free(void* p) {
    if (m_entryCount == 0 || m_entries[m_entryCount - 1].data != p) return;
    const b2StackEntry& entry = m_entries[--m_entryCount];
    if (entry.usedMalloc) {
        b2Free(p);
    } else {
        m_index -= entry.size;
    }
    m_allocation -= entry.size;
}

int32 b2StackAllocator::GetMaxAllocation() const { return m_maxAllocation; }
