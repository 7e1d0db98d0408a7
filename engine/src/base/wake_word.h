// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A number that threads sleep on until it is another one.
//
// That is std::atomic::wait, but for one library. Where libstdc++ has no futex, as on Windows, a thread may fall asleep
// just after it was to be woken, and never wake. There a mutex and a condition variable are used.

#pragma once

#include <atomic>
#include <cstdint>

#include "base/compiler.h"

#if defined(__GLIBCXX__) && !defined(__linux__)
#define SCREE_MAY_MISS_WAKES
#endif
#if defined(SCREE_HAS_THREADS) && defined(SCREE_MAY_MISS_WAKES)
#include <condition_variable>
#include <mutex>
#endif

namespace scree {

class WakeWord {
public:
    [[nodiscard]] uint32_t Load() const { return m_value.load(); }
    /// Another number; who sleeps goes on sleeping until WakeAll.
    void Advance() { m_value.fetch_add(1); }

#if defined(SCREE_HAS_THREADS) && defined(SCREE_MAY_MISS_WAKES)
    /// Until the number is not `old`.
    void Wait(uint32_t old) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return Load() != old; });
    }
    void WakeAll() {
        // Who has seen the old number sleeps by now, or has not got the lock yet and will see the new one.
        { const std::lock_guard lock(m_mutex); }
        m_changed.notify_all();
    }
#elif defined(SCREE_HAS_THREADS)
    void Wait(uint32_t old) const { m_value.wait(old); }
    void WakeAll() { m_value.notify_all(); }
#endif

private:
    std::atomic<uint32_t> m_value{0};
#if defined(SCREE_HAS_THREADS) && defined(SCREE_MAY_MISS_WAKES)
    std::mutex m_mutex;
    std::condition_variable m_changed;
#endif
};

}  // namespace scree
