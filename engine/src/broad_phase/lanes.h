// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Four float lanes and boxes shaped for them: a box is kept as {lx, ly, −ux, −uy}, so that a union is one lane-wise
// minimum and an overlap test one lane-wise "less or equal". SSE2 where the target has it, plain loops elsewhere; only
// minimum, maximum, sum, difference and comparison are used, so both give the same bits.

#pragma once

#include <cstdint>
#include <limits>

#include "scree/math.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace scree::broadphase {

#if defined(__SSE2__)

using F4 = __m128;

inline F4 Load4(const float* p) { return _mm_loadu_ps(p); }
inline void Store4(float* p, F4 v) { _mm_storeu_ps(p, v); }
inline F4 Splat4(float v) { return _mm_set1_ps(v); }
inline F4 Min4(F4 a, F4 b) { return _mm_min_ps(a, b); }
inline F4 Max4(F4 a, F4 b) { return _mm_max_ps(a, b); }
inline F4 Add4(F4 a, F4 b) { return _mm_add_ps(a, b); }
inline F4 Sub4(F4 a, F4 b) { return _mm_sub_ps(a, b); }
/// Lanes {2, 3, 0, 1}.
inline F4 SwapHalves4(F4 v) { return _mm_shuffle_ps(v, v, _MM_SHUFFLE(1, 0, 3, 2)); }
/// One lane in all four.
template <int lane>
F4 SplatLane4(F4 v) {
    return _mm_castsi128_ps(_mm_shuffle_epi32(_mm_castps_si128(v), lane * 0x55));
}
/// Rows become columns.
inline void Transpose4(F4& a, F4& b, F4& c, F4& d) { _MM_TRANSPOSE4_PS(a, b, c, d); }
inline F4 Negate4(F4 v) { return _mm_xor_ps(v, _mm_set1_ps(-0.0f)); }
/// Negates lanes 2 and 3: an AABB as it lies in memory takes the form of Bounds.
inline F4 NegateUpper4(F4 v) { return _mm_xor_ps(v, _mm_setr_ps(0.0f, 0.0f, -0.0f, -0.0f)); }
/// Bit i is set where a[i] <= b[i].
inline uint32_t MaskLessEqual4(F4 a, F4 b) { return static_cast<uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a, b))); }
/// Bit i is set where all four comparisons hold in lane i.
inline uint32_t MaskAllLessEqual4(const F4 (&a)[4], const F4 (&b)[4]) {
    const F4 x = _mm_and_ps(_mm_cmple_ps(a[0], b[0]), _mm_cmple_ps(a[2], b[2]));
    const F4 y = _mm_and_ps(_mm_cmple_ps(a[1], b[1]), _mm_cmple_ps(a[3], b[3]));
    return static_cast<uint32_t>(_mm_movemask_ps(_mm_and_ps(x, y)));
}

/// The lanes set in a mask, first ones first, and how many they are.
struct LaneList {
    uint32_t lanes[4];
    uint32_t count;
};

/// Writes `value` and `base + lane` for each lane set in `mask` without a branch; four places must be free in both
/// arrays. Returns how many count.
inline uint32_t EmitLanes(const LaneList& list, uint32_t value, uint32_t base, uint32_t* values, uint32_t* positions) {
    const __m128i lanes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(list.lanes));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(positions),
                     _mm_add_epi32(lanes, _mm_set1_epi32(static_cast<int>(base))));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(values), _mm_set1_epi32(static_cast<int>(value)));
    return list.count;
}

#else

struct F4 {
    float v[4];
};

inline F4 Load4(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
inline void Store4(float* p, F4 a) {
    for (int i = 0; i < 4; ++i) p[i] = a.v[i];
}
inline F4 Splat4(float x) { return {{x, x, x, x}}; }
inline F4 Min4(F4 a, F4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
    return a;
}
inline F4 Max4(F4 a, F4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
    return a;
}
inline F4 Add4(F4 a, F4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] += b.v[i];
    return a;
}
inline F4 Sub4(F4 a, F4 b) {
    for (int i = 0; i < 4; ++i) a.v[i] -= b.v[i];
    return a;
}
inline F4 SwapHalves4(F4 a) { return {{a.v[2], a.v[3], a.v[0], a.v[1]}}; }
template <int lane>
F4 SplatLane4(F4 a) {
    return Splat4(a.v[lane]);
}
inline void Transpose4(F4& a, F4& b, F4& c, F4& d) {
    const F4 in[4] = {a, b, c, d};
    a = {{in[0].v[0], in[1].v[0], in[2].v[0], in[3].v[0]}};
    b = {{in[0].v[1], in[1].v[1], in[2].v[1], in[3].v[1]}};
    c = {{in[0].v[2], in[1].v[2], in[2].v[2], in[3].v[2]}};
    d = {{in[0].v[3], in[1].v[3], in[2].v[3], in[3].v[3]}};
}
inline F4 Negate4(F4 a) { return {{-a.v[0], -a.v[1], -a.v[2], -a.v[3]}}; }
inline F4 NegateUpper4(F4 a) { return {{a.v[0], a.v[1], -a.v[2], -a.v[3]}}; }
inline uint32_t MaskLessEqual4(F4 a, F4 b) {
    uint32_t mask = 0;
    for (int i = 0; i < 4; ++i) mask |= static_cast<uint32_t>(a.v[i] <= b.v[i]) << i;
    return mask;
}
inline uint32_t MaskAllLessEqual4(const F4 (&a)[4], const F4 (&b)[4]) {
    return MaskLessEqual4(a[0], b[0]) & MaskLessEqual4(a[1], b[1]) & MaskLessEqual4(a[2], b[2]) &
           MaskLessEqual4(a[3], b[3]);
}

struct LaneList {
    uint32_t lanes[4];
    uint32_t count;
};

inline uint32_t EmitLanes(const LaneList& list, uint32_t value, uint32_t base, uint32_t* values, uint32_t* positions) {
    for (uint32_t i = 0; i < 4; ++i) {
        positions[i] = base + list.lanes[i];
        values[i] = value;
    }
    return list.count;
}

#endif

/// By mask.
inline constexpr LaneList laneLists[16] = {{{0, 0, 0, 0}, 0}, {{0, 0, 0, 0}, 1}, {{1, 0, 0, 0}, 1}, {{0, 1, 0, 0}, 2},
                                           {{2, 0, 0, 0}, 1}, {{0, 2, 0, 0}, 2}, {{1, 2, 0, 0}, 2}, {{0, 1, 2, 0}, 3},
                                           {{3, 0, 0, 0}, 1}, {{0, 3, 0, 0}, 2}, {{1, 3, 0, 0}, 2}, {{0, 1, 3, 0}, 3},
                                           {{2, 3, 0, 0}, 2}, {{0, 2, 3, 0}, 3}, {{1, 2, 3, 0}, 3}, {{0, 1, 2, 3}, 4}};

/// A box with its upper corner negated.
struct Bounds {
    float lx, ly, nux, nuy;
};

inline constexpr float infinity = std::numeric_limits<float>::infinity();
/// Neutral for unions; overlaps nothing.
inline constexpr Bounds emptyBounds{infinity, infinity, infinity, infinity};

constexpr Bounds ToBounds(const AABB& b) { return {b.lowerBound.x, b.lowerBound.y, -b.upperBound.x, -b.upperBound.y}; }
constexpr AABB ToAabb(const Bounds& b) { return {{b.lx, b.ly}, {-b.nux, -b.nuy}}; }

inline F4 Load(const Bounds& b) { return Load4(&b.lx); }
inline void Store(Bounds& b, F4 v) { Store4(&b.lx, v); }
inline F4 Load(const AABB& b) { return NegateUpper4(Load4(&b.lowerBound.x)); }

/// The other side of an overlap test: {ux, uy, −lx, −ly}.
inline F4 ProbeOf(F4 bounds) { return Negate4(SwapHalves4(bounds)); }
/// Whether the box (in the form of Bounds) and the box the probe was made of overlap, borders included.
inline bool Overlaps(F4 bounds, F4 probe) { return MaskLessEqual4(bounds, probe) == 15u; }
/// {sx, sy, −sx, −sy} with s = lower + upper, twice the centre: the minimum over many boxes bounds their centres.
inline F4 CentreOf(F4 bounds) { return Sub4(bounds, SwapHalves4(bounds)); }
/// Half of the perimeter.
constexpr float HalfPerimeter(const Bounds& b) { return -((b.lx + b.nux) + (b.ly + b.nuy)); }

}  // namespace scree::broadphase
