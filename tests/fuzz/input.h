// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The bytes of a fuzzer as choices and numbers, and what a target does when a law is broken.

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "scree/math.h"

namespace fuzz {

/// What becomes of a broken law: a crash, for which a fuzzer keeps the input. Tests set something else.
inline void (*onBroken)(const char* law) = [](const char* law) {
    std::fprintf(stderr, "broken: %s\n", law);
    std::abort();
};
inline void Demand(bool holds, const char* law) {
    if (!holds) onBroken(law);
}

/// Gives zeros once the bytes have run out. Take one thing a statement, or in braces: arguments of a call are read in
/// an order that depends on the compiler. What one finds could then not be repeated with another.
class Input {
public:
    Input(const uint8_t* data, size_t size) : m_data(data), m_size(size) {}

    [[nodiscard]] bool IsEmpty() const { return m_size == 0; }
    uint8_t Byte() {
        if (m_size == 0) return 0;
        --m_size;
        return *m_data++;
    }
    size_t Word() {
        const size_t high = Byte();
        return high << 8 | Byte();
    }
    /// 0 … count − 1.
    int Choose(int count) { return Byte() % count; }
    bool Flip() { return (Byte() & 1) != 0; }

    /// Mostly of a size that worlds have, sometimes any number at all.
    float Number() {
        constexpr float odd[] = {0.0f,
                                 -0.0f,
                                 1.0f,
                                 -1.0f,
                                 1e-7f,
                                 1e-20f,
                                 1e-40f,
                                 1e4f,
                                 -1e9f,
                                 1e18f,
                                 -1e18f,
                                 2e18f,
                                 1e30f,
                                 std::numeric_limits<float>::max(),
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::quiet_NaN()};
        const uint8_t kind = Byte();
        if (kind < 200) return (static_cast<float>(kind) - 100.0f) / 8.0f;
        if (kind < 232) return odd[kind % 16];
        uint32_t bits = 0;  // the lowest byte first, whatever the processor's order
        for (int shift = 0; shift < 32; shift += 8) bits |= static_cast<uint32_t>(Byte()) << shift;
        return std::bit_cast<float>(bits);
    }
    float Amount() {
        const float number = Number();
        return number < 0.0f && Flip() ? -number : number;
    }
    scree::Vec2 Point() {
        const float x = Number();
        return {x, Number()};
    }

private:
    const uint8_t* m_data;
    size_t m_size;
};

}  // namespace fuzz
