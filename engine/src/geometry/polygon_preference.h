// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Which of two polygons, or of other convex shapes, gives the reference face.

#pragma once

#include "scree/math.h"
#include "scree/settings.h"

namespace scree {

/// A needs to be clearly worse to lose, by this much, m: two faces nearly in one plane would otherwise alternate as the
/// reference. Small bodies have a thin skin (WorldDef::lengthScale); that share of the default one is the usual
/// preference. `radius` is that of both skins together.
inline float ReferencePreference(float radius) {
    constexpr float usual = 0.1f * linearSlop;
    return radius > 0.0f ? Min(usual, 0.025f * radius) : usual;
}

/// The same for convex shapes, whose radius may be as large as they are. Cores nearer than this have a direction
/// between them that is mostly rounding.
inline constexpr float convexPreference = 0.1f * linearSlop;

}  // namespace scree
