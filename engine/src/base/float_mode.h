// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Arithmetic as IEEE 754 has it, whatever a program has set for its threads: rounding to nearest, and numbers near 0
// kept. Games and audio code let the processor round those to 0; states would then depend on it.

#pragma once

#include <cstdint>

#include "base/compiler.h"

namespace scree {

/// Sets the mode of this thread while it lives, and puts back what was set. Where a processor has no such modes, or the
/// compiler no way to set them, nothing happens.
class StandardFloats {
public:
    StandardFloats() : m_before(Read()) {
        if ((m_before & controlBits) != standard) Write(standard);
    }
    ~StandardFloats() {
        if ((m_before & controlBits) != standard) Write(m_before);
    }
    StandardFloats(const StandardFloats&) = delete;
    StandardFloats& operator=(const StandardFloats&) = delete;

private:
    using Word = uintptr_t;
#if defined(SCREE_HAS_SSE2)
    static constexpr Word standard = 0x1F80;             // all exceptions masked
    static constexpr Word controlBits = 0xFFFF & ~0x3F;  // below: which exceptions there were
    static Word Read() { return _mm_getcsr(); }
    static void Write(Word mode) { _mm_setcsr(static_cast<unsigned>(mode)); }
#elif defined(__aarch64__) && defined(__GNUC__)
    static constexpr Word standard = 0;
    static constexpr Word controlBits = 0x07C00000;  // half precision, default NaN, flush to zero, rounding
    static Word Read() {
        Word mode = 0;
        asm volatile("mrs %0, fpcr" : "=r"(mode));
        return mode;
    }
    static void Write(Word mode) { asm volatile("msr fpcr, %0" : : "r"(mode) : "memory"); }
#elif defined(__arm__) && defined(__VFP_FP__) && defined(__ARM_FP) && defined(__GNUC__)
    static constexpr Word standard = 0;
    static constexpr Word controlBits = 0x07C00000;
    static Word Read() {
        Word mode = 0;
        asm volatile("vmrs %0, fpscr" : "=r"(mode));
        return mode;
    }
    static void Write(Word mode) { asm volatile("vmsr fpscr, %0" : : "r"(mode) : "memory"); }
#else
    static constexpr Word standard = 0, controlBits = 0;
    static Word Read() { return 0; }
    static void Write(Word) {}
#endif

    const Word m_before;
};

}  // namespace scree
