// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two disks → at most one contact point between their centres. Manifold layout of Box2D 2.4.

#include "geometry/collide_circles.h"

namespace scree {

void CollideCircles(Manifold* manifold, const CircleShape* circleA, const Transform& xfA, const CircleShape* circleB,
                    const Transform& xfB) {
    manifold->pointCount = 0;
    if (!DoCirclesTouch(*circleA, xfA, *circleB, xfB)) return;

    manifold->type = Manifold::e_circles;
    manifold->localPoint = circleA->m_p;
    manifold->localNormal.SetZero();
    manifold->pointCount = 1;
    manifold->points[0].localPoint = circleB->m_p;
    manifold->points[0].id.key = 0;
}

}  // namespace scree
