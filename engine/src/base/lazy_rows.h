// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Rows that are made when somebody first asks for them, by const functions that several threads may call at once: the
// first one makes them, the others wait. Who has found them made reads them without a lock.

#pragma once

#include <atomic>

#include "base/compiler.h"

#if defined(SCREE_HAS_MUTEXES)
#include <mutex>
#endif

namespace scree {

class LazyRows {
public:
    LazyRows() = default;
    /// A copy has made as many.
    LazyRows(const LazyRows& other) : m_count(other.Count()) {}
    LazyRows& operator=(const LazyRows& other) {
        Set(other.Count());
        return *this;
    }
    /// How many there are. What was written before they were made is visible to the caller.
    [[nodiscard]] int Count() const { return m_count.load(std::memory_order_acquire); }
    /// Sees to `count` rows: make() is called at most once, and by one thread.
    template <typename Make>
    void Ensure(int count, Make&& make) {
        if (Count() >= count) return;
#if defined(SCREE_HAS_MUTEXES)
        const std::lock_guard lock(m_mutex);
        if (Count() >= count) return;
#endif
        make();
        m_count.store(count, std::memory_order_release);
    }
    /// While nobody else asks.
    void Set(int count) { m_count.store(count, std::memory_order_relaxed); }

private:
    std::atomic<int> m_count{0};
#if defined(SCREE_HAS_MUTEXES)
    std::mutex m_mutex;
#endif
};

}  // namespace scree
