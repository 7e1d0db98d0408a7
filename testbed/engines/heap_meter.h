// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Counts the heap bytes that one engine holds while several live in the process. It adds up the growth of the heap over
// that engine's calls alone. Meanwhile no threads but the engine's may allocate. Under a sanitizer, which replaces the
// allocator, it counts 0.

#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

namespace testbed {

/// Bytes of the process's heap in use now.
[[nodiscard]] int64_t HeapBytesInUse();

/// The most that was in use at any moment since ResetHeapPeak.
[[nodiscard]] int64_t HeapBytesPeak();
void ResetHeapPeak();

class HeapMeter {
public:
    /// Runs `call` and adds what the heap grew (or shrank) by.
    template <typename Call>
    void Measure(Call&& call) {
        const int64_t before = HeapBytesInUse();
        ResetHeapPeak();
        std::forward<Call>(call)();
        m_peak = std::max(m_peak, m_bytes + HeapBytesPeak() - before);
        m_bytes += HeapBytesInUse() - before;
    }
    [[nodiscard]] int64_t GetBytes() const { return m_bytes; }
    /// The most that was held at any moment, also within a call.
    [[nodiscard]] int64_t GetPeakBytes() const { return m_peak; }

private:
    int64_t m_bytes = 0;
    int64_t m_peak = 0;
};

}  // namespace testbed
