// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Themes: colours that must be told apart stay apart for people who do not see red, green or blue. That is simulated by
// Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision deficiency", 2009.

#include "testbed/picture/theme.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace testbed {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

constexpr std::array<Matrix, 4> sights{{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
}};

Row Multiply(const Matrix& m, const Row& v) {
    Row result{};
    for (size_t i = 0; i < 3; ++i) {
        for (size_t k = 0; k < 3; ++k) result[i] += m[i][k] * v[k];
    }
    return result;
}

/// CIE L*a*b* (D65) of an sRGB colour as seen with `sight`.
Row SeeAsLab(const Color& color, const Matrix& sight) {
    const auto linear = [](uint8_t value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    Row rgb = Multiply(sight, {linear(color.r), linear(color.g), linear(color.b)});
    for (double& value : rgb) value = std::min(1.0, std::max(0.0, value));
    constexpr Matrix toXyz{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
    const Row xyz = Multiply(toXyz, rgb);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The least distance of any two colours in L*a*b*, over all sights.
double FindLeastDistance(const std::vector<Color>& colors) {
    double least = 1e9;
    for (const Matrix& sight : sights) {
        for (size_t i = 0; i < colors.size(); ++i) {
            for (size_t j = 0; j < i; ++j) {
                const Row a = SeeAsLab(colors[i], sight), b = SeeAsLab(colors[j], sight);
                least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
            }
        }
    }
    return least;
}

/// About ten times the difference that is just noticed side by side.
constexpr double clearDistance = 10;

TEST(Theme, ColoursStayApartForAllSights) {
    // The measure itself: red and green of equal lightness are apart for normal sight, not for all.
    EXPECT_LT(FindLeastDistance({{200, 60, 0}, {110, 105, 0}}), clearDistance);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const ThemeColors& colors = GetTheme(theme);
        const std::vector<Color> states{colors.background,      colors.awake.border,     colors.sleeping.border,
                                        colors.isStatic.border, colors.kinematic.border, colors.bullet.border,
                                        colors.sensor.border};
        EXPECT_GT(FindLeastDistance(states), clearDistance) << GetThemeName(theme);
        std::vector<Color> cycle(colors.cycle.begin(), colors.cycle.end());
        cycle.push_back(colors.background);
        EXPECT_GT(FindLeastDistance(cycle), clearDistance) << GetThemeName(theme);
        EXPECT_GT(FindLeastDistance({colors.background, colors.tightBox, colors.sweptBox, colors.fattenedBox}),
                  clearDistance)
            << GetThemeName(theme);
        EXPECT_GT(FindLeastDistance({colors.background, colors.contact, colors.normal, colors.impulse, colors.joint,
                                     colors.velocity}),
                  clearDistance)
            << GetThemeName(theme);
    }
}

TEST(Theme, WordsAreReadable) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const ThemeColors& colors = GetTheme(theme);
        // WCAG asks for a contrast of 4.5, about 45 in L*.
        for (const Color& text : {colors.text, colors.faintText}) {
            EXPECT_GT(std::abs(SeeAsLab(text, sights[0])[0] - SeeAsLab(colors.strip, sights[0])[0]), 45);
        }
    }
}

TEST(Theme, NamesLeadThereAndBack) {
    EXPECT_EQ(ParseTheme("dark"), Theme::dark);
    EXPECT_EQ(ParseTheme(GetThemeName(Theme::light)), Theme::light);
    EXPECT_THROW((void)ParseTheme("grey"), std::invalid_argument);
}

}  // namespace
}  // namespace testbed
