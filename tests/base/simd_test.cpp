// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The vocabulary of vectors against plain numbers, lane by lane and to the bit, on random numbers and on those where
// instructions differ: −0, denormals, infinities, not a number. Masks are no numbers: mixing them up must not compile.

#include "base/simd.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/simd_math.h"
#include "scree/math.h"

namespace scree {
namespace {

template <typename A, typename B>
concept CanAnd8 = requires(A a, B b) {
    And8(a, b);
};
template <typename A, typename B>
concept CanOr8 = requires(A a, B b) {
    Or8(a, b);
};
template <typename Mask, typename A>
concept CanKeep8 = requires(Mask m, A a) {
    Keep8(m, a);
};
template <typename Mask, typename A, typename B>
concept CanSelect8 = requires(Mask m, A a, B b) {
    Select8(m, a, b);
};
template <typename A, typename B>
concept CanAdd = requires(A a, B b) {
    a + b;
};

static_assert(CanAnd8<Mask8, Mask8> && !CanAnd8<Mask8, F8> && !CanAnd8<F8, Mask8> && !CanAnd8<F8, F8>);
static_assert(CanOr8<Mask8, Mask8> && !CanOr8<Mask8, F8> && !CanOr8<F8, F8>);
static_assert(CanKeep8<Mask8, F8> && !CanKeep8<F8, F8> && !CanKeep8<Mask8, Mask8>);
static_assert(CanSelect8<Mask8, F8, F8> && !CanSelect8<F8, F8, F8> && !CanSelect8<Mask8, F8, Mask8>);
static_assert(CanAdd<F8, F8> && !CanAdd<Mask8, Mask8> && !CanAdd<Mask8, F8> && !CanAdd<Mask4, Mask4>);

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
constexpr float special[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-42f, -1e-42f, inf, -inf, nan, FLT_MAX, 3.0f, 0.1f};

/// Eight numbers as they lie in memory, for both widths.
struct Eight {
    alignas(32) float v[8];

    [[nodiscard]] F8 Wide() const { return Load8(v); }
    [[nodiscard]] F4 Four() const { return Load4(v); }
};

/// Random numbers, every third of them a special one.
std::vector<Eight> Numbers() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-10.0f, 10.0f);
    std::vector<Eight> out(400);
    for (Eight& e : out) {
        for (float& x : e.v) x = random() % 3 == 0 ? special[random() % std::size(special)] : any(random);
    }
    return out;
}

/// The same bits; of what is not a number only that it is none.
bool IsSame(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) || std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b);
}

template <typename Lane>
void Expect8(F8 actual, const Lane& expected, const char* what) {
    alignas(32) float lanes[8];
    Store8(lanes, actual);
    for (int i = 0; i < 8; ++i) EXPECT_TRUE(IsSame(lanes[i], expected(i))) << what << ", lane " << i;
}
template <typename Lane>
void Expect4(F4 actual, const Lane& expected, const char* what) {
    float lanes[4];
    Store4(lanes, actual);
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(IsSame(lanes[i], expected(i))) << what << ", lane " << i;
}
template <typename Lane>
uint32_t BitsOf(int lanes, const Lane& isSet) {
    uint32_t bits = 0;
    for (int i = 0; i < lanes; ++i) bits |= isSet(i) ? 1u << i : 0u;
    return bits;
}

TEST(Simd, ArithmeticIsThatOfNumbers) {
    const std::vector<Eight> numbers = Numbers();
    for (size_t n = 0; n + 1 < numbers.size(); ++n) {
        const Eight &x = numbers[n], &y = numbers[n + 1];
        const F8 a = x.Wide(), b = y.Wide();
        const F4 c = x.Four(), d = y.Four();
        const auto both = [](F8 wide, F4 four, auto&& lane, const char* what) {
            Expect8(wide, lane, what);
            Expect4(four, lane, what);
        };
        both(
            a + b, c + d, [&](int i) { return x.v[i] + y.v[i]; }, "sum");
        both(
            a - b, c - d, [&](int i) { return x.v[i] - y.v[i]; }, "difference");
        both(
            a * b, c * d, [&](int i) { return x.v[i] * y.v[i]; }, "product");
        both(
            a / b, c / d, [&](int i) { return x.v[i] / y.v[i]; }, "quotient");
        both(
            Min8(a, b), Min4(c, d), [&](int i) { return x.v[i] < y.v[i] ? x.v[i] : y.v[i]; }, "minimum");
        both(
            Max8(a, b), Max4(c, d), [&](int i) { return x.v[i] > y.v[i] ? x.v[i] : y.v[i]; }, "maximum");
        both(
            Sqrt8(a), Sqrt4(c), [&](int i) { return std::sqrt(x.v[i]); }, "square root");
        Expect4(
            Abs4(c), [&](int i) { return std::fabs(x.v[i]); }, "absolute");
        Expect4(
            Negate4(c), [&](int i) { return -x.v[i]; }, "negated");
        Expect4(
            NegateUpper4(c), [&](int i) { return i < 2 ? x.v[i] : -x.v[i]; }, "upper half negated");
        if (HasFailure()) return;
    }
}

TEST(Simd, MasksAnswerPerLane) {
    const std::vector<Eight> numbers = Numbers();
    for (size_t n = 0; n + 1 < numbers.size(); ++n) {
        const Eight &x = numbers[n], &y = numbers[n + 1];
        const auto greater = [&](int i) { return x.v[i] > y.v[i]; };
        const auto greaterEqual = [&](int i) { return x.v[i] >= y.v[i]; };
        const Mask8 a = Greater8(x.Wide(), y.Wide()), b = GreaterEqual8(y.Wide(), x.Wide());
        const auto yes = [&](int i) { return x.v[i] > y.v[i]; };
        const auto other = [&](int i) { return y.v[i] >= x.v[i]; };
        EXPECT_EQ(Bits8(a), BitsOf(8, greater));
        EXPECT_EQ(Bits8(And8(a, b)), BitsOf(8, [&](int i) { return yes(i) && other(i); }));
        EXPECT_EQ(Bits8(Or8(a, b)), BitsOf(8, [&](int i) { return yes(i) || other(i); }));
        EXPECT_EQ(Bits8(Not8(a)), BitsOf(8, [&](int i) { return !yes(i); }));
        EXPECT_EQ(Bits8(Select8(a, b, Not8(b))), BitsOf(8, [&](int i) { return yes(i) ? other(i) : !other(i); }));
        EXPECT_EQ(AnySet8(a), Bits8(a) != 0);
        EXPECT_EQ(AllSet8(a), Bits8(a) == 255);
        Expect8(
            Select8(a, x.Wide(), y.Wide()), [&](int i) { return yes(i) ? x.v[i] : y.v[i]; }, "selected");
        Expect8(
            Keep8(a, x.Wide()), [&](int i) { return yes(i) ? x.v[i] : 0.0f; }, "kept");

        const F4 c = x.Four(), d = y.Four();
        EXPECT_EQ(Bits4(Greater4(c, d)), BitsOf(4, greater));
        EXPECT_EQ(Bits4(GreaterEqual4(c, d)), BitsOf(4, greaterEqual));
        EXPECT_EQ(Bits4(Less4(c, d)), BitsOf(4, [&](int i) { return x.v[i] < y.v[i]; }));
        EXPECT_EQ(Bits4(LessEqual4(c, d)), BitsOf(4, [&](int i) { return x.v[i] <= y.v[i]; }));
        EXPECT_EQ(Bits4(Equal4(c, d)), BitsOf(4, [&](int i) { return x.v[i] == y.v[i]; }));
        EXPECT_EQ(Bits4(Not4(Greater4(c, d))), BitsOf(4, [&](int i) { return !yes(i); }));
        Expect4(
            Select4(Greater4(c, d), c, d), [&](int i) { return yes(i) ? x.v[i] : y.v[i]; }, "selected");
        Expect4(
            Keep4(Greater4(c, d), c), [&](int i) { return yes(i) ? x.v[i] : 0.0f; }, "kept");
        if (HasFailure()) return;
    }
    EXPECT_EQ(Bits8(None8()), 0u);
    EXPECT_EQ(Bits8(Not8(None8())), 255u);
    EXPECT_EQ(Bits4(None4()), 0u);
}

TEST(Simd, LanesMove) {
    const Eight x{{1, 2, 3, 4, 5, 6, 7, 8}};
    const F4 a = x.Four(), b = Load4(x.v + 4);
    const auto lanes = [](std::array<float, 4> v) { return [v](int i) { return v[static_cast<size_t>(i)]; }; };
    Expect4(Shuffle4<3, 0, 1, 2>(a, b), lanes({4, 1, 6, 7}), "shuffled");
    Expect4(SwapHalves4(a), lanes({3, 4, 1, 2}), "halves");
    Expect4(SplatLane4<2>(a), lanes({3, 3, 3, 3}), "splat");
    Expect4(Set4(4, 3, 2, 1), lanes({4, 3, 2, 1}), "set");
    for (int count = 0; count <= 4; ++count) {
        Expect4(
            FirstLanes4(count, a, b), [&](int i) { return x.v[i < count ? i : i + 4]; }, "first lanes");
    }
    EXPECT_EQ(GetLane4<0>(a), 1.0f);
    EXPECT_EQ(GetLane4<1>(a), 2.0f);
    EXPECT_EQ(GetLane4<3>(a), 4.0f);
    F4 rows[] = {a, b, Splat4(9.0f), Set4(10, 11, 12, 13)};
    Transpose4(rows[0], rows[1], rows[2], rows[3]);
    Expect4(rows[0], lanes({1, 5, 9, 10}), "column 0");
    Expect4(rows[1], lanes({2, 6, 9, 11}), "column 1");
    Expect4(rows[2], lanes({3, 7, 9, 12}), "column 2");
    Expect4(rows[3], lanes({4, 8, 9, 13}), "column 3");
}

TEST(Simd, RowsAreGatheredAndTheFirstOfEqualOnesIsWrittenLast) {
    alignas(16) float rows[6 * 4];
    for (int i = 0; i < 24; ++i) rows[i] = static_cast<float>(i);
    const int32_t index[8] = {5, 0, 3, 2, 3, 1, 0, 4};
    F8 x, y, z, w;
    Gather8(rows, index, x, y, z, w);
    Expect8(
        x, [&](int i) { return rows[4 * index[i]]; }, "x");
    Expect8(
        y, [&](int i) { return rows[4 * index[i] + 1]; }, "y");
    Expect8(
        z, [&](int i) { return rows[4 * index[i] + 2]; }, "z");
    Expect8(
        w, [&](int i) { return rows[4 * index[i] + 3]; }, "w");

    const Eight lane{{0, 1, 2, 3, 4, 5, 6, 7}};
    Scatter8(rows, index, lane.Wide(), Splat8(100.0f) + lane.Wide(), Splat8(200.0f));
    const float first[6] = {1, 5, 3, 2, 7, 0};  // lane that each row keeps
    for (int row = 0; row < 6; ++row) {
        EXPECT_EQ(rows[4 * row], first[row]);
        EXPECT_EQ(rows[4 * row + 1], 100.0f + first[row]);
        EXPECT_EQ(rows[4 * row + 2], 200.0f);
        EXPECT_EQ(rows[4 * row + 3], 0.0f);
    }
}

TEST(Simd, IntegersAddAndCompare) {
    const uint32_t in[4] = {0, 7, 0xFFFFFFFFu, 5};
    uint32_t out[4];
    StoreU4(out, LoadU4(in) + SplatU4(3));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(out[i], in[i] + 3);

    const int16_t keys[8] = {3, -9, 100, 0, -32768, 8, 32767, 1};
    int16_t two[2];
    StoreFirstTwoS8(two, MinS8(LoadS8(keys), UpperHalfS8(LoadS8(keys))));
    EXPECT_EQ(two[0], -32768);
    EXPECT_EQ(two[1], -9);
    StoreFirstTwoS8(two, MaxS8(LoadTwiceS8(keys + 2), SplatS8(50)));
    EXPECT_EQ(two[0], 100);
    EXPECT_EQ(two[1], 50);
    StoreFirstTwoS8(two, UpperHalfS8(LoadTwiceS8(keys)));
    EXPECT_EQ(two[0], 3);
    EXPECT_EQ(two[1], -9);
}

TEST(Simd, DoublesAreThoseOfNumbers) {
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double odd[] = {0.0, -0.0, 1.0, 5e-324, infinite, -infinite, notANumber, DBL_MAX, 0.1};
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-10.0, 10.0);
    const auto isSame = [](double x, double y) {
        return (std::isnan(x) && std::isnan(y)) || std::bit_cast<uint64_t>(x) == std::bit_cast<uint64_t>(y);
    };
    for (int n = 0; n < 400; ++n) {
        alignas(32) double x[4], y[4], out[4];
        for (double* p : {x, y}) {
            for (int i = 0; i < 4; ++i) p[i] = random() % 3 == 0 ? odd[random() % std::size(odd)] : any(random);
        }
        const D4 a = LoadD4(x), b = LoadD4(y);
        const auto expect = [&](D4 actual, auto&& lane, const char* what) {
            StoreD4(out, actual);
            for (int i = 0; i < 4; ++i) EXPECT_TRUE(isSame(out[i], lane(i))) << what << ", lane " << i;
        };
        expect(
            a + b, [&](int i) { return x[i] + y[i]; }, "sum");
        expect(
            a - b, [&](int i) { return x[i] - y[i]; }, "difference");
        expect(
            a * b, [&](int i) { return x[i] * y[i]; }, "product");
        expect(
            a / b, [&](int i) { return x[i] / y[i]; }, "quotient");
        expect(
            KeepD4(GreaterD4(a, b), a), [&](int i) { return x[i] > y[i] ? x[i] : 0.0; }, "kept");
        uint32_t bits = 0;
        for (uint32_t i = 0; i < 4; ++i) bits |= x[i] > y[i] ? 1u << i : 0u;
        EXPECT_EQ(BitsD4(GreaterD4(a, b)), bits);
        if (HasFailure()) return;
    }
}

TEST(Simd, FloatsBecomeDoublesAndBackRounded) {
    for (const Eight& numbers : Numbers()) {
        alignas(32) double low[4], high[4];
        D4 lower, upper;
        SplitF8(numbers.Wide(), lower, upper);
        StoreD4(low, lower), StoreD4(high, upper);
        const auto doubleAt = [&](int i) { return i < 4 ? low[i] : high[i - 4]; };
        for (int i = 0; i < 8; ++i) {
            EXPECT_TRUE(IsSame(static_cast<float>(doubleAt(i)), numbers.v[i])) << "lane " << i;
        }
        const D4 third = SplatD4(1.0 / 3.0);
        Expect8(
            JoinF8(lower * third, upper * third), [&](int i) { return static_cast<float>(doubleAt(i) * (1.0 / 3.0)); },
            "joined");
        if (HasFailure()) return;
    }
}

TEST(Simd, SinesAndCosinesAreThoseOfTheScalarHeader) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> exponent(-40.0f, 29.8f), mantissa(1.0f, 2.0f), anyExponent(-40.0f, 127.9f);
    const auto compare = [](const Eight& angles) {
        const Rotation8 q = SinCos8(angles.Wide());
        Expect8(
            q.s, [&](int i) { return SinCos(angles.v[i]).sin; }, "sine");
        Expect8(
            q.c, [&](int i) { return SinCos(angles.v[i]).cos; }, "cosine");
    };
    constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    compare({{0.0f, -0.0f, 1e-42f, -1e-42f, 9.9e8f, -9.9e8f, pi, -pi}});
    compare({{0.0f, infinity, 1.0f, -infinity, nan, 1e30f, pi, -pi}});
    for (int n = 0; n < 200000 && !testing::Test::HasFailure(); ++n) {
        Eight angles;
        const bool areAny = random() % 4 == 0;
        for (float& a : angles.v) {
            const float size =
                std::ldexp(mantissa(random), static_cast<int>(areAny ? anyExponent(random) : exponent(random)));
            a = random() % 2 == 0 ? size : -size;
            if (random() % 4 == 0) a = 0.5f * pi * static_cast<float>(static_cast<int>(random() % 64) - 32);
            if (!areAny && std::fabs(a) >= sin_cos::largestDirect) a = 1.0f;
        }
        compare(angles);
    }
}

TEST(Simd, RowsOfDoublesAreGatheredAndScattered) {
    alignas(32) double rows[6][4], copy[6][4] = {};
    for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 4; ++c) rows[r][c] = 10.0 * r + c;
    }
    const int32_t index[4] = {4, 0, 5, 2};
    D4 column[4];
    GatherD4(rows[0], index, column[0], column[1], column[2], column[3]);
    for (int c = 0; c < 4; ++c) {
        alignas(32) double lanes[4];
        StoreD4(lanes, column[c]);
        for (int i = 0; i < 4; ++i) EXPECT_EQ(lanes[i], rows[index[i]][c]);
    }
    ScatterD4(copy[0], index, column[0], column[1], column[2], column[3]);
    for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 4; ++c) EXPECT_EQ(copy[r][c], r == 1 || r == 3 ? 0.0 : rows[r][c]);
    }
}

TEST(Simd, VectorsAndPlacementsAreThoseOfTheScalarHeader) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-10.0f, 10.0f);
    for (int n = 0; n < 200; ++n) {
        Vec2 v[4];
        for (Vec2& p : v) p = {any(random), any(random)};
        const Transform t({any(random), any(random)}, Rot(any(random)));
        const Placement4 four{SplatVector4(t.p.x, t.p.y), {Splat4(t.q.s), Splat4(t.q.c)}};
        const Vector4 placed = Mul4(four, LoadVectors4(&v[0].x));
        Expect4(
            placed.x, [&](int i) { return Mul(t, v[i]).x; }, "x");
        Expect4(
            placed.y, [&](int i) { return Mul(t, v[i]).y; }, "y");
        Expect4(
            Dot4(placed, SplatLane4<1>(placed)), [&](int i) { return Dot(Mul(t, v[i]), Mul(t, v[1])); }, "dot");
    }
}

}  // namespace
}  // namespace scree
