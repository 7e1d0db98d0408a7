// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Law. The swept box of a shape contains the shape's boxes at all moments of any motion, and the quick one contains the
// swept box.

#include "geometry/swept_box.h"

#include <gtest/gtest.h>

#include "tests/geometry/any_shape.h"
#include "tests/geometry/source.h"

namespace scree::test {
namespace {

bool Contains(const AABB& outer, const AABB& inner, float rounding) {
    const Vec2 r{rounding, rounding};
    return AABB{outer.lowerBound - r, outer.upperBound + r}.Contains(inner);
}

TEST(SweptBox, CoversTheWholeWay) {
    Source random(11);
    for (int round = 0; round < 20000; ++round) {
        const float size = random.Size(0.05f, 20.0f);
        AnyShape any;
        MakeShape(any, size, random);
        Sweep sweep;
        sweep.localCenter = random.InSquare(random.Chance(4) ? 5.0f * size : 0.5f * size);
        sweep.c0 = random.InSquare(random.Chance(3) ? 1000.0f : size);
        sweep.c = sweep.c0 + (random.Chance(5) ? vec2Zero : random.Size(0.001f, 30.0f) * random.Direction());
        sweep.a0 = random.Between(-10.0f, 10.0f);
        sweep.a = sweep.a0 + (random.Chance(4) ? 0.0f : random.Size(0.001f, 8.0f) * (random.Chance(2) ? 1.0f : -1.0f));
        sweep.alpha0 = 0.0f;
        Transform start, end;
        sweep.GetTransform(&start, 0.0f);
        sweep.GetTransform(&end, 1.0f);
        const float rounding = 1.0e-6f * (sweep.c0.Length() + sweep.c.Length() + 20.0f * size);
        const AABB swept = SweptBox(*any.shape, sweep, end);
        for (int i = 0; i <= 16; ++i) {
            Transform between;
            sweep.GetTransform(&between, static_cast<float>(i) / 16.0f);
            AABB box;
            any.shape->ComputeAABB(&box, between);
            ASSERT_TRUE(Contains(swept, box, rounding)) << round << ' ' << i;
        }
        AABB first;
        any.shape->ComputeAABB(&first, start);
        const float margin = random.Size(1.0e-4f, 0.05f);
        const QuickSweep quick(sweep.c0, sweep.c, sweep.a - sweep.a0, margin);
        ASSERT_TRUE(Contains(quick.Cover(first), swept, rounding)) << round;
        // A box that lags behind by less than the margin does as well.
        const Vec2 lag = 0.5f * margin * random.Direction();
        const AABB late{first.lowerBound + lag, first.upperBound + lag};
        ASSERT_TRUE(Contains(quick.Cover(late), swept, rounding)) << round;
    }
}

}  // namespace
}  // namespace scree::test
