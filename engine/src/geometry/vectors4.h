// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Vectors and placements of scree/math.h into four lanes each, for functions that treat four vertices or faces alike.

#pragma once

#include "base/simd_math.h"
#include "scree/math.h"

namespace scree {

SCREE_KERNEL Vector4 SplatVector4(Vec2 v) { return SplatVector4(v.x, v.y); }
SCREE_KERNEL Rotation4 SplatRotation4(Rot q) { return {Splat4(q.s), Splat4(q.c)}; }
SCREE_KERNEL Placement4 SplatPlacement4(const Transform& t) { return {SplatVector4(t.p), SplatRotation4(t.q)}; }

}  // namespace scree
