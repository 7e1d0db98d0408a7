// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The two functions of Microsoft's <intrin.h> that the engine calls, so that lines for its compiler can be run here.

#pragma once

#include <cpuid.h>
#include <immintrin.h>
#undef __cpuid

inline void ReadCpuid(int (&r)[4], int leaf, int subleaf) {
    unsigned a = 0, b = 0, c = 0, d = 0;
    __cpuid_count(leaf, subleaf, a, b, c, d);
    r[0] = static_cast<int>(a), r[1] = static_cast<int>(b), r[2] = static_cast<int>(c), r[3] = static_cast<int>(d);
}
inline void __cpuidex(int (&r)[4], int leaf, int subleaf) { ReadCpuid(r, leaf, subleaf); }
inline void __cpuid(int (&r)[4], int leaf) { ReadCpuid(r, leaf, 0); }
