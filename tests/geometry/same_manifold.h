// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Two manifolds that must have the same bits, impulses aside.

#pragma once

#include <gtest/gtest.h>

#include "scree/collision.h"

namespace scree::test {

inline void ExpectSame(const Manifold& expected, const Manifold& found) {
    ASSERT_EQ(found.pointCount, expected.pointCount);
    if (expected.pointCount == 0) return;
    ASSERT_EQ(found.type, expected.type);
    ASSERT_TRUE(found.localNormal == expected.localNormal);
    ASSERT_TRUE(found.localPoint == expected.localPoint);
    for (int i = 0; i < expected.pointCount; ++i) {
        ASSERT_TRUE(found.points[i].localPoint == expected.points[i].localPoint) << i;
        ASSERT_EQ(found.points[i].id.key, expected.points[i].id.key) << i;
    }
}

}  // namespace scree::test
