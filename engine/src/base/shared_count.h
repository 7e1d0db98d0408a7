// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Plain numbers that several threads read and write: sums, maxima and bits, which are the same in any order. It uses
// std::atomic_ref, or the compiler's own form where the standard library has none yet (libc++ before 19).

#pragma once

#include <atomic>
#include <cstdint>

namespace scree {

/// Returns what it was before.
inline int AddShared(int& count, int number) {
#if defined(__cpp_lib_atomic_ref)
    return std::atomic_ref(count).fetch_add(number, std::memory_order_relaxed);
#else
    return __atomic_fetch_add(&count, number, __ATOMIC_RELAXED);
#endif
}

/// Raises `most` to `number` if it is smaller.
inline void RaiseShared(int& most, int number) {
#if defined(__cpp_lib_atomic_ref)
    const std::atomic_ref shared(most);
    int seen = shared.load(std::memory_order_relaxed);
    while (seen < number && !shared.compare_exchange_weak(seen, number, std::memory_order_relaxed)) {
    }
#else
    int seen = __atomic_load_n(&most, __ATOMIC_RELAXED);
    while (seen < number &&
           !__atomic_compare_exchange_n(&most, &seen, number, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
#endif
}

inline int LoadShared(int& number) {
#if defined(__cpp_lib_atomic_ref)
    return std::atomic_ref(number).load(std::memory_order_relaxed);
#else
    return __atomic_load_n(&number, __ATOMIC_RELAXED);
#endif
}

inline void StoreShared(int& number, int value) {
#if defined(__cpp_lib_atomic_ref)
    std::atomic_ref(number).store(value, std::memory_order_relaxed);
#else
    __atomic_store_n(&number, value, __ATOMIC_RELAXED);
#endif
}

inline void StoreShared(float& number, float value) {
#if defined(__cpp_lib_atomic_ref)
    std::atomic_ref(number).store(value, std::memory_order_relaxed);
#else
    __atomic_store(&number, &value, __ATOMIC_RELAXED);
#endif
}

/// Makes it another one if it is what is expected; false if not.
inline bool ReplaceShared(int& number, int expected, int other) {
#if defined(__cpp_lib_atomic_ref)
    return std::atomic_ref(number).compare_exchange_strong(expected, other, std::memory_order_relaxed);
#else
    return __atomic_compare_exchange_n(&number, &expected, other, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
#endif
}

/// Sets bits of a byte. Whoever does so at the same time must set the same ones.
inline void SetSharedBits(uint8_t& byte, uint8_t bits) {
#if defined(__cpp_lib_atomic_ref)
    const std::atomic_ref shared(byte);
    shared.store(static_cast<uint8_t>(shared.load(std::memory_order_relaxed) | bits), std::memory_order_relaxed);
#else
    const uint8_t seen = __atomic_load_n(&byte, __ATOMIC_RELAXED);
    __atomic_store_n(&byte, static_cast<uint8_t>(seen | bits), __ATOMIC_RELAXED);
#endif
}

}  // namespace scree
