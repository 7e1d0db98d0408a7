// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// SinCos and Atan2 against the correctly rounded values: within 1 ulp (SinCos below 1e9 rad, beyond on the unit
// circle). Pinned bits, so that a machine or compiler that rounds differently is found out.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/geometry/oracle.h"

namespace scree::test {
namespace {

/// Steps between two floats of equal sign; large if signs differ.
int64_t UlpDistance(float a, float b) {
    const auto ordered = [](float f) {
        const auto bits = std::bit_cast<int32_t>(f);
        return bits < 0 ? -static_cast<int64_t>(bits & 0x7fffffff) : static_cast<int64_t>(bits);
    };
    return std::llabs(ordered(a) - ordered(b));
}

/// The exact value rounded to float: a long double sine carries 40 more bits than are needed.
float RoundedSin(float angle) { return static_cast<float>(std::sin(static_cast<long double>(angle))); }
float RoundedCos(float angle) { return static_cast<float>(std::cos(static_cast<long double>(angle))); }

struct Errors {
    int64_t largest = 0;
    int wrong = 0;
    int count = 0;
    void Add(float angle) {
        const SinCosResult r = SinCos(angle);
        for (const int64_t d : {UlpDistance(r.sin, RoundedSin(angle)), UlpDistance(r.cos, RoundedCos(angle))}) {
            largest = std::max(largest, d);
            wrong += d != 0;
            ++count;
        }
    }
};

TEST(SinCos, IsWithinOneUlpOfTheRoundedValue) {
    Source source(21);
    for (const float range : {1.0f, 10.0f, 1.0e3f, 1.0e6f, 9.9e8f}) {
        Errors errors;
        for (int i = 0; i < 100000; ++i) errors.Add(source.Between(-range, range));
        std::cout << "|angle| < " << range << ": largest error " << errors.largest << " ulp, " << errors.wrong << " of "
                  << errors.count << " not correctly rounded\n";
        EXPECT_LE(errors.largest, 1);
        EXPECT_LT(errors.wrong, errors.count / 100);
    }
}

TEST(SinCos, IsWithinOneUlpNextToMultiplesOfAQuarterTurn) {
    // Here the reduction cancels most and one of the results is tiny.
    Errors errors;
    Source source(22);
    for (int i = 0; i < 200000; ++i) {
        const long double quadrant = i < 1000 ? i : static_cast<long double>(source.Between(0.0f, 6.3e8f));
        const auto angle = static_cast<float>(std::round(quadrant) * 1.57079632679489661923132169163975144L);
        errors.Add(angle);
        errors.Add(std::nextafter(angle, 0.0f));
        errors.Add(std::nextafter(-angle, -INFINITY));
    }
    EXPECT_LE(errors.largest, 1);
}

TEST(SinCos, IsWithinOneUlpAcrossAllMagnitudes) {
    Errors errors;
    for (uint32_t bits = 0; bits < std::bit_cast<uint32_t>(1.0e9f); bits += 5003)
        errors.Add(std::bit_cast<float>(bits));
    EXPECT_LE(errors.largest, 1);
}

TEST(SinCos, StaysAccurateForHugeAngles) {
    // The reduction is good to 2^-38 rad there, so the absolute error stays that of rounding to float.
    Source source(23);
    for (int i = 0; i < 100000; ++i) {
        const uint32_t bits = std::bit_cast<uint32_t>(1.0e9f) +
                              static_cast<uint32_t>(source.Below(0x7f800000 - std::bit_cast<int32_t>(1.0e9f)));
        const float angle = std::bit_cast<float>(bits) * (source.Chance(2) ? 1.0f : -1.0f);
        const SinCosResult r = SinCos(angle);
        EXPECT_NEAR(r.sin, std::sin(static_cast<double>(angle)), 7.0e-8) << angle;
        EXPECT_NEAR(r.cos, std::cos(static_cast<double>(angle)), 7.0e-8) << angle;
    }
}

TEST(SinCos, HasTheSymmetriesOfSineAndCosine) {
    Source source(24);
    for (int i = 0; i < 100000; ++i) {
        const float angle = source.Between(0.0f, 1.0e4f);
        const SinCosResult plus = SinCos(angle);
        const SinCosResult minus = SinCos(-angle);
        EXPECT_EQ(plus.sin, -minus.sin);
        EXPECT_EQ(plus.cos, minus.cos);
        // Two roundings to float of numbers below 1.
        EXPECT_NEAR(static_cast<double>(plus.sin) * plus.sin + static_cast<double>(plus.cos) * plus.cos, 1.0, 1.3e-7);
    }
}

TEST(SinCos, IsExactAtZeroAndNanForWhatIsNotAnAngle) {
    EXPECT_EQ(SinCos(0.0f).sin, 0.0f);
    EXPECT_EQ(SinCos(0.0f).cos, 1.0f);
    EXPECT_TRUE(std::signbit(SinCos(-0.0f).sin));
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        EXPECT_TRUE(std::isnan(SinCos(bad).sin));
        EXPECT_TRUE(std::isnan(SinCos(bad).cos));
    }
}

/// Bits of a million results, folded: equal on every machine or the determinism promise is broken.
TEST(SinCos, HasTheSameBitsEverywhere) {
    Source source(25);
    uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (int i = 0; i < 1000000; ++i) {
        const SinCosResult r = SinCos(source.Between(-1.0f, 1.0f) * (i % 3 == 0 ? 3.2f : i % 3 == 1 ? 1.0e4f : 2.0e9f));
        for (const float f : {r.sin, r.cos}) hash = (hash ^ std::bit_cast<uint32_t>(f)) * 0x100000001b3u;
    }
    EXPECT_EQ(hash, 0x9d4cc602d218ac41u) << std::hex << hash;
}

TEST(Atan2, IsWithinOneUlpOfTheRoundedValueInAllDirectionsAndSizes) {
    Source source(26);
    int64_t largest = 0;
    int wrong = 0;
    constexpr int count = 300000;
    for (int i = 0; i < count; ++i) {
        const float size = std::ldexp(1.0f, source.Below(60) - 30);
        const float x = source.Between(-1.0f, 1.0f) * size;
        const float y = source.Between(-1.0f, 1.0f) * (source.Chance(2) ? size : 1.0e-3f * size);
        const auto exact = static_cast<float>(std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
        const int64_t d = UlpDistance(Atan2(y, x), exact);
        largest = std::max(largest, d);
        wrong += d != 0;
    }
    EXPECT_LE(largest, 1);
    EXPECT_LT(wrong, count / 100);
}

TEST(Atan2, KeepsTheQuadrantsAndWhatIsSpecial) {
    const float infinity = INFINITY;
    for (const float y : {0.0f, -0.0f, 1.0f, -1.0f, infinity, -infinity, 1.0e-40f}) {
        for (const float x : {0.0f, -0.0f, 1.0f, -1.0f, infinity, -infinity, 1.0e-40f}) {
            const auto exact = static_cast<float>(std::atan2(static_cast<double>(y), static_cast<double>(x)));
            EXPECT_EQ(std::bit_cast<uint32_t>(Atan2(y, x)), std::bit_cast<uint32_t>(exact)) << y << ", " << x;
        }
    }
    EXPECT_TRUE(std::isnan(Atan2(NAN, 1.0f)));
    EXPECT_TRUE(std::isnan(Atan2(1.0f, NAN)));
    EXPECT_EQ(Rot(2.5f).GetAngle(), 2.5f);
}

TEST(Atan2, HasTheSameBitsEverywhere) {
    Source source(27);
    uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (int i = 0; i < 1000000; ++i) {
        const float y = source.Between(-1.0f, 1.0f), x = source.Between(-1.0f, 1.0f) * (i % 3 == 0 ? 1.0e-3f : 1.0f);
        hash = (hash ^ std::bit_cast<uint32_t>(Atan2(y, x))) * 0x100000001b3u;
    }
    EXPECT_EQ(hash, 0x62f7269c0ecea863u) << std::hex << hash;
}

}  // namespace
}  // namespace scree::test
