// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Counts the heap bytes that one engine holds while several live in the process: the growth of the C library's heap
// (mallinfo2: blocks in use and mapped blocks) is added up over that engine's calls only. Other threads must not
// allocate meanwhile. Under a sanitizer, which replaces the allocator, it counts 0.

#pragma once

#include <cstdint>
#include <utility>

namespace testbed {

/// Bytes of the process's heap in use now.
[[nodiscard]] int64_t HeapBytesInUse();

class HeapMeter {
public:
    /// Runs `call` and adds what the heap grew (or shrank) by.
    template <typename Call>
    void Measure(Call&& call) {
        const int64_t before = HeapBytesInUse();
        std::forward<Call>(call)();
        m_bytes += HeapBytesInUse() - before;
    }
    [[nodiscard]] int64_t GetBytes() const { return m_bytes; }

private:
    int64_t m_bytes = 0;
};

}  // namespace testbed
