// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Clipping of a contact segment against a side plane of the reference face: two points with feature ids → two points,
// or nothing. Sutherland and Hodgman (Communications of the ACM 17, 1974) for one segment; ids and point order as in
// Box2D 2.4, because the order of the points is part of the manifold that warm starting and the solver see.

#pragma once

#include "scree/collision.h"

namespace scree {

/// A point of a segment being clipped, and the features that made it.
struct ClipVertex {
    Vec2 v;
    ContactID id;
};

/// The id of a contact made by feature `indexA` of the reference shape and `indexB` of the other.
inline ContactID MakeContactID(int indexA, ContactFeature::Type typeA, int indexB, ContactFeature::Type typeB) {
    ContactID id;
    id.cf = {static_cast<uint8_t>(indexA), static_cast<uint8_t>(indexB), static_cast<uint8_t>(typeA),
             static_cast<uint8_t>(typeB)};
    return id;
}

/// The same contact named from the other shape's side.
inline ContactID SwapContactID(ContactID id) {
    ContactID out;
    out.cf = {id.cf.indexB, id.cf.indexA, id.cf.typeB, id.cf.typeA};
    return out;
}

/// Keeps the part of the segment with dot(normal, v) <= offset. A cut end becomes the second point and takes the id of
/// the reference shape's corner `cornerIndex`. False, with the segment undefined, if fewer than two points remain.
[[nodiscard]] inline bool ClipSegmentToLine(ClipVertex segment[2], Vec2 normal, float offset, int cornerIndex) {
    const float distance0 = Dot(normal, segment[0].v) - offset;
    const float distance1 = Dot(normal, segment[1].v) - offset;
    if (distance0 <= 0.0f && distance1 <= 0.0f) return true;
    if (!(distance0 * distance1 < 0.0f)) return false;

    const float fraction = distance0 / (distance0 - distance1);
    const Vec2 cut = segment[0].v + fraction * (segment[1].v - segment[0].v);
    const ContactID id =
        MakeContactID(cornerIndex, ContactFeature::e_vertex, segment[0].id.cf.indexB, ContactFeature::e_face);
    if (distance0 > 0.0f) segment[0] = segment[1];
    segment[1] = {cut, id};
    return true;
}

}  // namespace scree
