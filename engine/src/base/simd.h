// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The one vocabulary of vectors: kernels are written once with it, and a file is compiled to the widest instructions
// that its flags allow. Only exactly rounded operations, lane by lane and never fused, so that all sets give the same
// bits.
//
// Four lanes are what an instruction set must supply (simd/sse2.inc, neon.inc, wasm.inc, plain loops in portable.inc);
// eight are two times four (simd/pairs.inc), or one AVX register (simd/avx2.inc). All functions are inlined by force,
// and all names lie in an inline namespace of the set, because one program has files for several sets.
// SCREE_FORCE_PORTABLE chooses the loops on every target.
//
// F4, F8: floats. Load, Store, Splat, + − · /, Min, Max, Sqrt, …
//
// D4: doubles, two times D2 or AVX. Load, Store, Splat, + − · /, Greater, Keep, Transpose. SplitF8 and JoinF8 go from
// floats to doubles and back.
//
// Mask4, Mask8, MaskD4: per lane yes or no from comparisons. And, Or, Not, Select, Keep, Bits. No number becomes a mask
// or back.
//
// U4: four uint32_t. Load, Store, Splat, +.
//
// S8: eight int16_t, which are keys of boxes. Load, Min, Max.
//
// Min(a, b) is a < b ? a : b and Max(a, b) is a > b ? a : b, so that b is the answer where one is not a number.

#pragma once

#include <cstdint>

#include "base/compiler.h"

#if defined(SCREE_FORCE_PORTABLE)
#define SCREE_SIMD_SET portable
#elif defined(__AVX2__)
#define SCREE_SIMD_SET avx2
#elif defined(SCREE_HAS_SSE2)
#define SCREE_SIMD_SET sse2
#elif defined(__ARM_NEON) && (defined(__aarch64__) || defined(_M_ARM64)) && defined(__GNUC__)
#define SCREE_SIMD_SET neon  // that of 32-bit ARM rounds numbers near 0 to 0
#define SCREE_SIMD_NEON
#elif defined(__wasm_simd128__)
#define SCREE_SIMD_SET wasm
#define SCREE_SIMD_WASM
#else
#define SCREE_SIMD_SET portable
#endif

#if !defined(SCREE_FORCE_PORTABLE) && defined(SCREE_HAS_SSE2)
#include "base/simd/sse2.inc"
#elif defined(SCREE_SIMD_NEON)
#include "base/simd/neon.inc"
#elif defined(SCREE_SIMD_WASM)
#include "base/simd/wasm.inc"
#else
#include "base/simd/portable.inc"
#endif

#if !defined(SCREE_FORCE_PORTABLE) && defined(__AVX2__)
#include "base/simd/avx2.inc"
#else
#include "base/simd/pairs.inc"
#endif

#define SCREE_SIMD_TEXT(name) #name
#define SCREE_SIMD_NAME_OF(set) SCREE_SIMD_TEXT(set)

namespace scree {
inline namespace SCREE_SIMD_SET {

/// The set that this file is compiled for.
inline constexpr const char* simdName = SCREE_SIMD_NAME_OF(SCREE_SIMD_SET);

/// Lanes {2, 3, 0, 1}.
SCREE_KERNEL F4 SwapHalves4(F4 v) { return Shuffle4<2, 3, 0, 1>(v, v); }

/// The lanes of `a` below `count`, then those of `b`.
SCREE_KERNEL F4 FirstLanes4(int count, F4 a, F4 b) {
    const auto n = static_cast<float>(count);
    return Select4(Less4(Set4(0.0f, 1.0f, 2.0f, 3.0f), Splat4(n)), a, b);
}

SCREE_KERNEL bool AnySet8(Mask8 mask) { return Bits8(mask) != 0; }
SCREE_KERNEL bool AllSet8(Mask8 mask) { return Bits8(mask) == 0xFF; }

/// The numbers of eight rows of four, by their indices.
SCREE_KERNEL void Gather8(const float* rows, const int32_t* index, F8& x, F8& y, F8& z, F8& w) {
    const float* row[laneCount];
    for (int i = 0; i < laneCount; ++i) row[i] = rows + 4 * static_cast<int64_t>(index[i]);
    GatherRows8(row, x, y, z, w);
}
/// The first three numbers of eight rows of four.
SCREE_KERNEL void Gather8(const float* rows, const int32_t* index, F8& x, F8& y, F8& z) {
    F8 unused;
    Gather8(rows, index, x, y, z, unused);
}
/// The same rows with 0 as the fourth number.
SCREE_KERNEL void Scatter8(float* rows, const int32_t* index, F8 x, F8 y, F8 z) {
    Scatter8(rows, index, x, y, z, Splat8(0.0f));
}

/// The numbers of four rows of four doubles, by their indices; rows begin at multiples of 32 bytes. What nobody needs
/// of them may go to one and the same place.
SCREE_KERNEL void GatherD4(const double* rows, const int32_t* index, D4& x, D4& y, D4& z, D4& w) {
    D4 a = LoadD4(rows + 4 * static_cast<int64_t>(index[0])), b = LoadD4(rows + 4 * static_cast<int64_t>(index[1]));
    D4 c = LoadD4(rows + 4 * static_cast<int64_t>(index[2])), d = LoadD4(rows + 4 * static_cast<int64_t>(index[3]));
    TransposeD4(a, b, c, d);
    x = a, y = b, z = c, w = d;
}
/// Writes four rows of four doubles, the last lane last.
SCREE_KERNEL void ScatterD4(double* rows, const int32_t* index, D4 x, D4 y, D4 z, D4 w) {
    TransposeD4(x, y, z, w);
    StoreD4(rows + 4 * static_cast<int64_t>(index[0]), x), StoreD4(rows + 4 * static_cast<int64_t>(index[1]), y);
    StoreD4(rows + 4 * static_cast<int64_t>(index[2]), z), StoreD4(rows + 4 * static_cast<int64_t>(index[3]), w);
}

}  // namespace SCREE_SIMD_SET
}  // namespace scree
