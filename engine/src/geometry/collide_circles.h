// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The test that decides about most pairs of circles, inlined where manifolds are computed.

#pragma once

#include "base/compiler.h"
#include "scree/collision.h"

namespace scree {

SCREE_INLINE bool DoCirclesTouch(const CircleShape& a, const Transform& xfA, const CircleShape& b,
                                 const Transform& xfB) {
    const float radius = a.m_radius + b.m_radius;
    return DistanceSquared(Mul(xfB, b.m_p), Mul(xfA, a.m_p)) <= radius * radius;
}

}  // namespace scree
