// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Eight float lanes for the solver's kernels: one AVX register, two SSE2 registers, or plain loops, by what the file
// that includes this is compiled for. Only exactly rounded operations, lane by lane and never fused, so all three give
// the same bits. Everything is inlined by force: the same names exist in translation units for different instruction
// sets, and no copy made for one of them may ever be called from another.

#pragma once

#include <cstdint>

#if defined(__AVX2__) || defined(__SSE2__)
#include <immintrin.h>
#endif

#if defined(__GNUC__)
#define SCREE_KERNEL [[gnu::always_inline]] static inline
#else
#define SCREE_KERNEL static inline
#endif

namespace scree {

inline constexpr int laneCount = 8;

#if defined(__AVX2__)

struct F8 {
    __m256 v;
};
SCREE_KERNEL F8 Load8(const float* p) { return {_mm256_load_ps(p)}; }
SCREE_KERNEL void Store8(float* p, F8 a) { _mm256_store_ps(p, a.v); }
SCREE_KERNEL F8 Splat8(float x) { return {_mm256_set1_ps(x)}; }
SCREE_KERNEL F8 operator+(F8 a, F8 b) { return {_mm256_add_ps(a.v, b.v)}; }
SCREE_KERNEL F8 operator-(F8 a, F8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
SCREE_KERNEL F8 operator*(F8 a, F8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
SCREE_KERNEL F8 operator/(F8 a, F8 b) { return {_mm256_div_ps(a.v, b.v)}; }
SCREE_KERNEL F8 Min8(F8 a, F8 b) { return {_mm256_min_ps(a.v, b.v)}; }
SCREE_KERNEL F8 Max8(F8 a, F8 b) { return {_mm256_max_ps(a.v, b.v)}; }
/// Lanes of all ones where the comparison holds.
SCREE_KERNEL F8 Greater8(F8 a, F8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }
SCREE_KERNEL F8 GreaterEqual8(F8 a, F8 b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ)}; }
SCREE_KERNEL F8 And8(F8 a, F8 b) { return {_mm256_and_ps(a.v, b.v)}; }
SCREE_KERNEL F8 Or8(F8 a, F8 b) { return {_mm256_or_ps(a.v, b.v)}; }
/// `yes` where the mask is set, else `no`.
SCREE_KERNEL F8 Select8(F8 mask, F8 yes, F8 no) { return {_mm256_blendv_ps(no.v, yes.v, mask.v)}; }
SCREE_KERNEL bool AnySet8(F8 mask) { return _mm256_movemask_ps(mask.v) != 0; }
SCREE_KERNEL bool AllSet8(F8 mask) { return _mm256_movemask_ps(mask.v) == 0xFF; }
/// Bit i is lane i of the mask.
SCREE_KERNEL uint32_t Bits8(F8 mask) { return static_cast<uint32_t>(_mm256_movemask_ps(mask.v)); }
SCREE_KERNEL F8 Sqrt8(F8 a) { return {_mm256_sqrt_ps(a.v)}; }

SCREE_KERNEL __m256 LoadTwoRows(const float* low, const float* high) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}
/// The numbers of eight rows of four, wherever they are.
SCREE_KERNEL void GatherRows8(const float* const (&row)[laneCount], F8& x, F8& y, F8& z, F8& w) {
    const __m256 r0 = LoadTwoRows(row[0], row[4]), r1 = LoadTwoRows(row[1], row[5]);
    const __m256 r2 = LoadTwoRows(row[2], row[6]), r3 = LoadTwoRows(row[3], row[7]);
    const __m256 xy01 = _mm256_unpacklo_ps(r0, r1), zw01 = _mm256_unpackhi_ps(r0, r1);
    const __m256 xy23 = _mm256_unpacklo_ps(r2, r3), zw23 = _mm256_unpackhi_ps(r2, r3);
    x.v = _mm256_shuffle_ps(xy01, xy23, _MM_SHUFFLE(1, 0, 1, 0));
    y.v = _mm256_shuffle_ps(xy01, xy23, _MM_SHUFFLE(3, 2, 3, 2));
    z.v = _mm256_shuffle_ps(zw01, zw23, _MM_SHUFFLE(1, 0, 1, 0));
    w.v = _mm256_shuffle_ps(zw01, zw23, _MM_SHUFFLE(3, 2, 3, 2));
}
/// Writes eight rows of four, the last lane first: where lanes name the same row, the first wins.
SCREE_KERNEL void Scatter8(float* rows, const int32_t* index, F8 x, F8 y, F8 z, F8 w) {
    const __m256 xyLow = _mm256_unpacklo_ps(x.v, y.v), xyHigh = _mm256_unpackhi_ps(x.v, y.v);
    const __m256 zwLow = _mm256_unpacklo_ps(z.v, w.v), zwHigh = _mm256_unpackhi_ps(z.v, w.v);
    const __m256 r[4] = {_mm256_shuffle_ps(xyLow, zwLow, _MM_SHUFFLE(1, 0, 1, 0)),
                         _mm256_shuffle_ps(xyLow, zwLow, _MM_SHUFFLE(3, 2, 3, 2)),
                         _mm256_shuffle_ps(xyHigh, zwHigh, _MM_SHUFFLE(1, 0, 1, 0)),
                         _mm256_shuffle_ps(xyHigh, zwHigh, _MM_SHUFFLE(3, 2, 3, 2))};
    for (int i = 3; i >= 0; --i) {
        _mm_store_ps(rows + 4 * static_cast<int64_t>(index[i + 4]), _mm256_extractf128_ps(r[i], 1));
    }
    for (int i = 3; i >= 0; --i) _mm_store_ps(rows + 4 * static_cast<int64_t>(index[i]), _mm256_castps256_ps128(r[i]));
}

#elif defined(__SSE2__)

struct F8 {
    __m128 lo, hi;
};
SCREE_KERNEL F8 Load8(const float* p) { return {_mm_load_ps(p), _mm_load_ps(p + 4)}; }
SCREE_KERNEL void Store8(float* p, F8 a) { _mm_store_ps(p, a.lo), _mm_store_ps(p + 4, a.hi); }
SCREE_KERNEL F8 Splat8(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
SCREE_KERNEL F8 operator+(F8 a, F8 b) { return {_mm_add_ps(a.lo, b.lo), _mm_add_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 operator-(F8 a, F8 b) { return {_mm_sub_ps(a.lo, b.lo), _mm_sub_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 operator*(F8 a, F8 b) { return {_mm_mul_ps(a.lo, b.lo), _mm_mul_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 operator/(F8 a, F8 b) { return {_mm_div_ps(a.lo, b.lo), _mm_div_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 Min8(F8 a, F8 b) { return {_mm_min_ps(a.lo, b.lo), _mm_min_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 Max8(F8 a, F8 b) { return {_mm_max_ps(a.lo, b.lo), _mm_max_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 Greater8(F8 a, F8 b) { return {_mm_cmpgt_ps(a.lo, b.lo), _mm_cmpgt_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 GreaterEqual8(F8 a, F8 b) { return {_mm_cmpge_ps(a.lo, b.lo), _mm_cmpge_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 And8(F8 a, F8 b) { return {_mm_and_ps(a.lo, b.lo), _mm_and_ps(a.hi, b.hi)}; }
SCREE_KERNEL F8 Or8(F8 a, F8 b) { return {_mm_or_ps(a.lo, b.lo), _mm_or_ps(a.hi, b.hi)}; }
SCREE_KERNEL __m128 Select4(__m128 mask, __m128 yes, __m128 no) {
    return _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no));
}
SCREE_KERNEL F8 Select8(F8 mask, F8 yes, F8 no) {
    return {Select4(mask.lo, yes.lo, no.lo), Select4(mask.hi, yes.hi, no.hi)};
}
SCREE_KERNEL bool AnySet8(F8 mask) { return (_mm_movemask_ps(mask.lo) | _mm_movemask_ps(mask.hi)) != 0; }
SCREE_KERNEL bool AllSet8(F8 mask) { return (_mm_movemask_ps(mask.lo) & _mm_movemask_ps(mask.hi)) == 0xF; }
SCREE_KERNEL uint32_t Bits8(F8 mask) {
    return static_cast<uint32_t>(_mm_movemask_ps(mask.lo) | _mm_movemask_ps(mask.hi) << 4);
}
SCREE_KERNEL F8 Sqrt8(F8 a) { return {_mm_sqrt_ps(a.lo), _mm_sqrt_ps(a.hi)}; }

SCREE_KERNEL void Transpose4(const float* r0, const float* r1, const float* r2, const float* r3, __m128* columns) {
    columns[0] = _mm_loadu_ps(r0), columns[1] = _mm_loadu_ps(r1);
    columns[2] = _mm_loadu_ps(r2), columns[3] = _mm_loadu_ps(r3);
    _MM_TRANSPOSE4_PS(columns[0], columns[1], columns[2], columns[3]);
}
SCREE_KERNEL void GatherRows8(const float* const (&row)[laneCount], F8& x, F8& y, F8& z, F8& w) {
    __m128 lo[4], hi[4];
    Transpose4(row[0], row[1], row[2], row[3], lo);
    Transpose4(row[4], row[5], row[6], row[7], hi);
    x = {lo[0], hi[0]}, y = {lo[1], hi[1]}, z = {lo[2], hi[2]}, w = {lo[3], hi[3]};
}
SCREE_KERNEL void Scatter4(float* rows, const int32_t* index, __m128 x, __m128 y, __m128 z, __m128 w) {
    _MM_TRANSPOSE4_PS(x, y, z, w);
    _mm_store_ps(rows + 4 * static_cast<int64_t>(index[3]), w);
    _mm_store_ps(rows + 4 * static_cast<int64_t>(index[2]), z);
    _mm_store_ps(rows + 4 * static_cast<int64_t>(index[1]), y);
    _mm_store_ps(rows + 4 * static_cast<int64_t>(index[0]), x);
}
SCREE_KERNEL void Scatter8(float* rows, const int32_t* index, F8 x, F8 y, F8 z, F8 w) {
    Scatter4(rows, index + 4, x.hi, y.hi, z.hi, w.hi);
    Scatter4(rows, index, x.lo, y.lo, z.lo, w.lo);
}

#else

struct F8 {
    float v[laneCount];
};
/// Masks are 0 and 1 here: only Select8, And8, Or8 and AnySet8 look at them.
template <typename Function>
SCREE_KERNEL F8 EachLane(Function&& function) {
    F8 out;
    for (int i = 0; i < laneCount; ++i) out.v[i] = function(i);
    return out;
}
SCREE_KERNEL F8 Load8(const float* p) {
    return EachLane([&](int i) { return p[i]; });
}
SCREE_KERNEL void Store8(float* p, F8 a) {
    for (int i = 0; i < laneCount; ++i) p[i] = a.v[i];
}
SCREE_KERNEL F8 Splat8(float x) {
    return EachLane([&](int) { return x; });
}
SCREE_KERNEL F8 operator+(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] + b.v[i]; });
}
SCREE_KERNEL F8 operator-(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] - b.v[i]; });
}
SCREE_KERNEL F8 operator*(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] * b.v[i]; });
}
SCREE_KERNEL F8 operator/(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] / b.v[i]; });
}
SCREE_KERNEL F8 Min8(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] < b.v[i] ? a.v[i] : b.v[i]; });
}
SCREE_KERNEL F8 Max8(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] > b.v[i] ? a.v[i] : b.v[i]; });
}
SCREE_KERNEL F8 Greater8(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] > b.v[i] ? 1.0f : 0.0f; });
}
SCREE_KERNEL F8 GreaterEqual8(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] >= b.v[i] ? 1.0f : 0.0f; });
}
SCREE_KERNEL F8 And8(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] != 0.0f && b.v[i] != 0.0f ? 1.0f : 0.0f; });
}
SCREE_KERNEL F8 Or8(F8 a, F8 b) {
    return EachLane([&](int i) { return a.v[i] != 0.0f || b.v[i] != 0.0f ? 1.0f : 0.0f; });
}
SCREE_KERNEL F8 Select8(F8 mask, F8 yes, F8 no) {
    return EachLane([&](int i) { return mask.v[i] != 0.0f ? yes.v[i] : no.v[i]; });
}
SCREE_KERNEL bool AnySet8(F8 mask) {
    for (const float m : mask.v) {
        if (m != 0.0f) return true;
    }
    return false;
}
SCREE_KERNEL bool AllSet8(F8 mask) {
    for (const float m : mask.v) {
        if (m == 0.0f) return false;
    }
    return true;
}
SCREE_KERNEL uint32_t Bits8(F8 mask) {
    uint32_t bits = 0;
    for (int i = 0; i < laneCount; ++i) bits |= (mask.v[i] != 0.0f ? 1u : 0u) << i;
    return bits;
}
SCREE_KERNEL F8 Sqrt8(F8 a) {
    return EachLane([&](int i) { return __builtin_sqrtf(a.v[i]); });
}
SCREE_KERNEL void GatherRows8(const float* const (&row)[laneCount], F8& x, F8& y, F8& z, F8& w) {
    for (int i = 0; i < laneCount; ++i) {
        x.v[i] = row[i][0], y.v[i] = row[i][1], z.v[i] = row[i][2], w.v[i] = row[i][3];
    }
}
SCREE_KERNEL void Scatter8(float* rows, const int32_t* index, F8 x, F8 y, F8 z, F8 w) {
    for (int i = laneCount; i-- > 0;) {
        float* row = rows + 4 * static_cast<int64_t>(index[i]);
        row[0] = x.v[i], row[1] = y.v[i], row[2] = z.v[i], row[3] = w.v[i];
    }
}

#endif

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

}  // namespace scree
