// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Clipping of a contact segment against a side plane of the reference face: two points with feature ids → two points,
// or nothing. Sutherland and Hodgman (Communications of the ACM 17, 1974) for one segment. Ids and point order are
// those of Box2D 2.4, because the order is part of the manifold that warm starting and the solver see.

#pragma once

#include <bit>

#include "scree/collision.h"

namespace scree {

/// A point of a segment being clipped, and the key (ContactID::key) of the features that made it. Plain integers
/// instead of the union: the compiler keeps them in registers.
struct ClipVertex {
    Vec2 v;
    uint32_t key;
};

/// The key of a contact made by feature `indexA` of the reference shape and `indexB` of the other.
inline uint32_t MakeContactKey(int indexA, ContactFeature::Type typeA, int indexB, ContactFeature::Type typeB) {
    return std::bit_cast<uint32_t>(
        ContactFeature{static_cast<uint8_t>(indexA), static_cast<uint8_t>(indexB), typeA, typeB});
}

/// The key of a cut: the reference shape's corner `indexA` on the face or vertex `indexB` of `key`.
inline uint32_t MakeCutKey(uint32_t key, int indexA) {
    constexpr uint32_t keptBits = std::bit_cast<uint32_t>(ContactFeature{0, 0xff, 0, 0});
    return (key & keptBits) | MakeContactKey(indexA, ContactFeature::e_vertex, 0, ContactFeature::e_face);
}

/// The same contact named from the other shape's side: indices and types are neighbouring bytes of the key.
inline uint32_t SwapContactKey(uint32_t key) {
    constexpr uint32_t everySecondByte = 0x00ff00ffu;
    return ((key & everySecondByte) << 8) | ((key >> 8) & everySecondByte);
}

/// The segment being clipped. Two members and no array: they stay in registers.
struct ClipSegment {
    ClipVertex first, second;
};

/// Keeps the part of the segment with dot(normal, v) <= offset. A cut end becomes the second point and takes the key of
/// the reference shape's corner `cornerIndex`. False, with the segment undefined, if fewer than two points remain.
[[nodiscard]] inline bool ClipSegmentToLine(ClipSegment& segment, Vec2 normal, float offset, int cornerIndex) {
    const float distance1 = Dot(normal, segment.first.v) - offset;
    const float distance2 = Dot(normal, segment.second.v) - offset;
    if (distance1 <= 0.0f && distance2 <= 0.0f) return true;
    if (!(distance1 * distance2 < 0.0f)) return false;

    const float fraction = distance1 / (distance1 - distance2);
    const Vec2 cut = segment.first.v + fraction * (segment.second.v - segment.first.v);
    const uint32_t key = MakeCutKey(segment.first.key, cornerIndex);
    if (distance1 > 0.0f) segment.first = segment.second;
    segment.second = {cut, key};
    return true;
}

}  // namespace scree
