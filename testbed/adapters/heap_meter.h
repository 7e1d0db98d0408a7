// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Counts the heap bytes that one engine holds while several live in the process: the growth of the C library's heap
// (mallinfo2: blocks in use and mapped blocks) is added up over that engine's calls only. Other threads must not
// allocate meanwhile. Under a sanitizer, which replaces the allocator, it counts 0.

#pragma once

#include <algorithm>
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
        m_peak = std::max(m_peak, m_bytes);
    }
    [[nodiscard]] int64_t GetBytes() const { return m_bytes; }
    /// The most that was held after any of the calls.
    [[nodiscard]] int64_t GetPeakBytes() const { return m_peak; }

private:
    int64_t m_bytes = 0;
    int64_t m_peak = 0;
};

}  // namespace testbed
