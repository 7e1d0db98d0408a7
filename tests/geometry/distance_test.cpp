// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Distance of two convex shapes: against brute force in double and Box2D 2.4.1, with and without radii and caches, far
// from the origin and with degenerate input.

#include <gtest/gtest.h>

#include <limits>

#include "scree/chain_shape.h"
#include "tests/geometry/convex_oracle.h"

namespace scree::test {
namespace {

constexpr int trials = 100000;
// Coordinates up to 5 m carry roundings of 2e-7 each, a few of them add up, and transforms are float.
constexpr double rounding = 5.0e-6;

struct Trial {
    AnyShape shapeA, shapeB;
    DistanceInput input;
    b2DistanceInput twin;

    explicit Trial(Source& source) : shapeA(AnyShape::Random(source)), shapeB(AnyShape::Random(source)) {
        const Placement placement = RandomPlacement(source);
        const Vec2 far = source.Chance(2) ? source.InSquare(3.0f) : vec2Zero;
        Place(placement.a, {placement.b.p + far, placement.b.q});
        input.useRadii = twin.useRadii = source.Chance(2);
    }
    void Place(const Transform& a, const Transform& b) {
        input.proxyA = ProxyOf(shapeA);
        input.proxyB = ProxyOf(shapeB);
        input.transformA = a;
        input.transformB = b;
        twin.proxyA = TwinProxyOf(shapeA);
        twin.proxyB = TwinProxyOf(shapeB);
        twin.transformA = ToBox2d(a);
        twin.transformB = ToBox2d(b);
    }
    [[nodiscard]] double Brute() const {
        const double cores =
            OutlineDistance(test::Place(input.proxyA, input.transformA), test::Place(input.proxyB, input.transformB));
        const double radii = static_cast<double>(input.proxyA.m_radius) + static_cast<double>(input.proxyB.m_radius);
        return input.useRadii ? std::max(0.0, cores - radii) : cores;
    }
};

DistanceOutput Measure(const DistanceInput& input) {
    DistanceOutput output;
    SimplexCache cache;
    Distance(&output, &cache, &input);
    return output;
}

TEST(Distance, EqualsBruteForceInDouble) {
    Source source(201);
    int apart = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial trial(source);
        const DistanceOutput output = Measure(trial.input);
        const double expected = trial.Brute();
        apart += expected > 0.0;
        ASSERT_NEAR(output.distance, expected, rounding) << i;
        // The closest points are that far apart, up to the rounding of world coordinates (1 km: 6e-5).
        const double gap = Length(ToDouble(output.pointA) - ToDouble(output.pointB));
        const bool isFar = Abs(trial.input.transformA.p.x) > 100.0f;
        ASSERT_NEAR(gap, expected, isFar ? 3.0e-4 : rounding) << i;
    }
    EXPECT_GT(apart, trials / 4);
    EXPECT_LT(apart, trials * 9 / 10);
}

TEST(Distance, AgreesWithBox2d) {
    Source source(202);
    int sameIterations = 0;
    for (int i = 0; i < trials; ++i) {
        const Trial trial(source);
        const DistanceOutput output = Measure(trial.input);
        b2DistanceOutput expected;
        b2SimplexCache cache;
        cache.count = 0;
        b2Distance(&expected, &cache, &trial.twin);
        const bool isFar = Abs(trial.input.transformA.p.x) > 100.0f;
        ASSERT_NEAR(output.distance, expected.distance, isFar ? 3.0e-4f : 1.0e-5f) << i;
        sameIterations += output.iterations == expected.iterations;
    }
    EXPECT_GT(sameIterations, trials / 2);
}

TEST(Distance, IsKeptByWarmStarts) {
    Source source(203);
    int cold = 0;
    int warm = 0;
    for (int i = 0; i < trials / 10; ++i) {
        Trial trial(source);
        SimplexCache cache;
        for (int step = 0; step < 8; ++step) {
            DistanceOutput output;
            Distance(&output, &cache, &trial.input);
            warm += output.iterations;
            cold += Measure(trial.input).iterations;
            ASSERT_NEAR(output.distance, trial.Brute(), rounding) << i << " " << step;
            Transform moved = trial.input.transformB;
            moved.p += source.InSquare(0.1f);
            moved.q = Mul(moved.q, Rot(source.Between(-0.2f, 0.2f)));
            trial.Place(trial.input.transformA, moved);
        }
    }
    EXPECT_LT(warm, cold);
}

TEST(Distance, IgnoresCachesThatDoNotFit) {
    Source source(204);
    for (int i = 0; i < trials / 10; ++i) {
        const Trial trial(source);
        SimplexCache cache;
        cache.count = static_cast<uint16_t>(source.Below(6));
        cache.metric = source.Between(-1.0f, 1.0f);
        for (int k = 0; k < 3; ++k) {
            cache.indexA[k] = static_cast<uint8_t>(source.Below(source.Chance(2) ? 4 : 256));
            cache.indexB[k] = static_cast<uint8_t>(source.Below(source.Chance(2) ? 4 : 256));
        }
        DistanceOutput output;
        Distance(&output, &cache, &trial.input);
        ASSERT_NEAR(output.distance, trial.Brute(), rounding) << i;
    }
}

TEST(Distance, IsSymmetric) {
    Source source(205);
    for (int i = 0; i < trials / 10; ++i) {
        const Trial trial(source);
        DistanceInput swapped = trial.input;
        std::swap(swapped.proxyA, swapped.proxyB);
        std::swap(swapped.transformA, swapped.transformB);
        ASSERT_NEAR(Measure(trial.input).distance, Measure(swapped).distance, rounding);
    }
}

TEST(Distance, IsExactForGroundFarFromItsBody) {
    // Ground at 1e5 m in the coordinates of a body at the origin, where floats are 0.0078 m apart. The numbers given
    // are what counts, and no digit of their difference may be lost.
    const AnyShape ground = AnyShape::Edge({100000.0f, 0.0f}, {100002.0f, 0.0f});
    const AnyShape ball = AnyShape::Circle(0.25f);
    DistanceInput input{ProxyOf(ground), ProxyOf(ball), {}, {}, true};
    input.transformA.SetIdentity();
    input.transformB.Set({100001.0f, 0.5f}, 0.3f);
    EXPECT_NEAR(Measure(input).distance, 0.5 - 0.25 - polygonRadius, 1.0e-6);
}

TEST(Distance, ManyVerticesAreAllSeen) {
    Source source(206);
    std::vector<Vec2> ring;
    for (int i = 0; i < 255; ++i) {
        ring.push_back(2.0f * Rot(2.0f * pi * static_cast<float>(i) / 255.0f).GetXAxis());
    }
    for (int count : {9, 11, 12, 13, 16, 17, 64, 255}) {
        std::vector<Vec2> some;
        for (int i = 0; i < count; ++i) some.push_back(ring[static_cast<size_t>(i * 255 / count)]);
        DistanceInput input;
        input.proxyA.Set(some.data(), count, 0.0f);
        const AnyShape box = AnyShape::Box(0.5f, 0.25f);
        input.proxyB = ProxyOf(box);
        input.useRadii = false;
        for (int i = 0; i < 200; ++i) {
            input.transformA.Set(source.InSquare(1.0f), source.Between(-3.0f, 3.0f));
            input.transformB.Set(source.InSquare(5.0f), source.Between(-3.0f, 3.0f));
            const double expected =
                OutlineDistance(Place(input.proxyA, input.transformA), Place(input.proxyB, input.transformB));
            ASSERT_NEAR(Measure(input).distance, expected, rounding) << count;
        }
    }
}

TEST(Distance, DegenerateInputEnds) {
    const AnyShape box = AnyShape::Box(0.5f, 0.5f);
    const AnyShape point = AnyShape::Edge({1.0f, 1.0f}, {1.0f, 1.0f});
    DistanceInput input{ProxyOf(box), ProxyOf(box), {}, {}, false};
    input.transformA.SetIdentity();
    input.transformB.SetIdentity();
    EXPECT_EQ(Measure(input).distance, 0.0f) << "the same shape twice";

    input.proxyB = ProxyOf(point);
    EXPECT_NEAR(Measure(input).distance, std::sqrt(0.5), rounding) << "an edge without length";
    input.proxyA = ProxyOf(point);
    EXPECT_EQ(Measure(input).distance, 0.0f) << "two coincident points";

    const Vec2 line[3] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}};
    input.proxyA.Set(line, 3, 0.0f);
    input.transformB.Set({0.0f, 1.0f}, 0.0f);
    EXPECT_NEAR(Measure(input).distance, 2.0, rounding) << "a flat polygon";

    input.transformB.p.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(std::isnan(Measure(input).distance));
    input.transformB.p.x = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(std::isfinite(Measure(input).distance));

    input.proxyB = DistanceProxy{};
    EXPECT_TRUE(std::isinf(Measure(input).distance)) << "an empty proxy";
}

TEST(DistanceProxy, SupportIsTheFarthestVertex) {
    Source source(207);
    for (int i = 0; i < trials / 10; ++i) {
        const AnyShape shape = AnyShape::Random(source);
        const DistanceProxy proxy = ProxyOf(shape);
        const b2DistanceProxy twin = TwinProxyOf(shape);
        const Vec2 d = source.InSquare(1.0f);
        ASSERT_EQ(proxy.GetVertexCount(), twin.GetVertexCount());
        ASSERT_EQ(proxy.m_radius, twin.m_radius);
        ASSERT_EQ(proxy.GetSupport(d), twin.GetSupport(ToBox2d(d)));
        ASSERT_TRUE(SameBits(proxy.GetSupportVertex(d), twin.GetSupportVertex(ToBox2d(d))));
    }
}

TEST(DistanceProxy, OfAChainIsOneSegment) {
    ChainShape chain;
    const Vec2 points[3] = {{0.0f, 0.0f}, {4.0f, 0.0f}, {0.0f, 3.0f}};
    ASSERT_TRUE(chain.CreateLoop(points, 3));
    for (int i = 0; i < 3; ++i) {
        DistanceProxy proxy;
        proxy.Set(&chain, i);
        ASSERT_EQ(proxy.GetVertexCount(), 2);
        EXPECT_EQ(proxy.GetVertex(0), points[i]);
        EXPECT_EQ(proxy.GetVertex(1), points[(i + 1) % 3]);
        EXPECT_EQ(proxy.m_radius, polygonRadius);
    }
    for (int i : {-1, 3}) {
        DistanceProxy proxy;
        proxy.Set(&chain, i);
        EXPECT_EQ(proxy.GetVertexCount(), 0);
    }
}

}  // namespace
}  // namespace scree::test
