// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Area and moments of a closed outline: vertices → integrals over a fan of triangles.

#pragma once

#include "scree/math.h"

namespace scree {

/// Area, first moment divided by area, and second moment of a fan of triangles, all about its first vertex.
struct FanMoments {
    float area = 0.0f;
    Vec2 center{0.0f, 0.0f};
    float secondMoment = 0.0f;
};

inline FanMoments IntegrateFan(const Vec2* vertices, int count) {
    // Measuring from a vertex instead of the origin keeps the digits of a small polygon far from the body's origin.
    constexpr float oneThird = 1.0f / 3.0f;
    FanMoments out;
    const Vec2 apex = vertices[0];
    for (int i = 1; i + 1 < count; ++i) {
        const Vec2 e1 = vertices[i] - apex;
        const Vec2 e2 = vertices[i + 1] - apex;
        const float doubleArea = Cross(e1, e2);
        const float triangleArea = 0.5f * doubleArea;
        out.area += triangleArea;
        out.center += triangleArea * oneThird * (e1 + e2);
        const float integralX2 = e1.x * e1.x + e2.x * e1.x + e2.x * e2.x;
        const float integralY2 = e1.y * e1.y + e2.y * e1.y + e2.y * e2.y;
        out.secondMoment += (0.25f * oneThird * doubleArea) * (integralX2 + integralY2);
    }
    if (out.area > 0.0f) out.center *= 1.0f / out.area;
    return out;
}

}  // namespace scree
