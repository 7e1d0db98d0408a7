// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Overlap of two shapes, radii included: against Box2D 2.4.1 and brute force in double, in free poses and where the
// outlines barely touch.

#include <gtest/gtest.h>

#include "tests/geometry/convex_oracle.h"

namespace scree::test {
namespace {

constexpr int trials = 100000;

TEST(Overlap, AgreesWithBox2dAndBruteForce) {
    Source source(211);
    int overlapping = 0;
    int close = 0;
    for (int i = 0; i < trials; ++i) {
        const AnyShape a = AnyShape::Random(source);
        const AnyShape b = AnyShape::Random(source);
        Placement placement = RandomPlacement(source);
        if (source.Chance(2)) placement.b.p += source.InSquare(2.0f);
        const bool result = TestOverlap(&a.Ours(), 0, &b.Ours(), 0, placement.a, placement.b);
        const double distance = OutlineDistance(Place(ProxyOf(a), placement.a), Place(ProxyOf(b), placement.b));
        const double gap = distance - static_cast<double>(a.Ours().m_radius) - static_cast<double>(b.Ours().m_radius);
        overlapping += result;
        const bool isFar = Abs(placement.a.p.x) > 100.0f;
        // Within rounding of a bare touch either answer is right.
        if (std::fabs(gap) < 1.0e-5) {
            ++close;
            continue;
        }
        ASSERT_EQ(result, gap < 0.0) << i << " gap " << gap;
        if (isFar && std::fabs(gap) < 3.0e-4) continue;  // Box2D works in world coordinates
        ASSERT_EQ(result, b2TestOverlap(&a.Theirs(), 0, &b.Theirs(), 0, ToBox2d(placement.a), ToBox2d(placement.b)))
            << i;
    }
    EXPECT_GT(overlapping, trials / 4);
    EXPECT_LT(overlapping, trials * 9 / 10);
    EXPECT_LT(close, trials / 20);
}

TEST(Overlap, CountsATouchAndNotAGap) {
    const AnyShape ball = AnyShape::Circle(0.5f);
    Transform a, b;
    a.SetIdentity();
    b.Set({1.0f, 0.0f}, 0.0f);
    EXPECT_TRUE(TestOverlap(&ball.Ours(), 0, &ball.Ours(), 0, a, b));
    b.p.x = 1.0f + 1.0e-5f;
    EXPECT_FALSE(TestOverlap(&ball.Ours(), 0, &ball.Ours(), 0, a, b));
    b.p.x = std::nanf("");
    EXPECT_FALSE(TestOverlap(&ball.Ours(), 0, &ball.Ours(), 0, a, b));
}

}  // namespace
}  // namespace scree::test
