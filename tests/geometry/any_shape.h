// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Random shapes of every kind that is not a chain.

#pragma once

#include "scree/convex_shape.h"
#include "scree/shape.h"
#include "tests/geometry/source.h"

namespace scree::test {

struct AnyShape {
    CircleShape circle;
    EdgeShape edge;
    PolygonShape polygon;
    ConvexShape convex;
    const Shape* shape = nullptr;
};

inline void MakeShape(AnyShape& any, float size, Source& random) {
    switch (random.Below(6)) {
        case 0:
            any.circle.m_radius = size;
            any.circle.m_p = random.InSquare(0.3f * size);
            any.shape = &any.circle;
            break;
        case 1: {
            const Vec2 half = size * random.Direction();
            const Vec2 middle = random.InSquare(size);
            any.edge.SetTwoSided(middle - half, middle + half);
            any.shape = &any.edge;
            break;
        }
        case 2: {
            Vec2 points[6];
            for (Vec2& p : points) p = random.InSquare(size);
            if (!any.polygon.Set(points, 6)) any.polygon.SetAsBox(size, 0.5f * size);
            any.shape = &any.polygon;
            break;
        }
        case 3:
            any.polygon.SetAsBox(size, random.Size(0.01f, 1.0f) * size);
            any.shape = &any.polygon;
            break;
        case 4: {
            any.convex = MakeCapsule(random.InSquare(size), random.InSquare(size), 0.3f * size);
            any.shape = &any.convex;
            break;
        }
        default:
            any.convex = MakeEllipse(size, 0.6f * size);
            any.shape = &any.convex;
            break;
    }
}

}  // namespace scree::test
