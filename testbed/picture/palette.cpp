// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Colour tables. Heat runs from the background through violet, red and orange to pale yellow with steadily rising
// lightness; on a light background the lightness falls. Differences are red and blue, which the common forms of colour
// blindness keep apart.

#include "testbed/picture/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace testbed {

namespace {

constexpr Color layerColor{255, 0, 0, 255};

constexpr std::array<Color, 7> heatStops{backgroundColor,          Color{84, 56, 148, 255},  Color{152, 46, 128, 255},
                                         Color{203, 48, 66, 255},  Color{240, 105, 28, 255}, Color{250, 178, 44, 255},
                                         Color{252, 255, 190, 255}};

constexpr Color lightBackground{250, 250, 250, 255};
constexpr std::array<Color, 7> lightHeatStops{
    lightBackground,         Color{250, 226, 132, 255}, Color{248, 176, 60, 255}, Color{232, 104, 36, 255},
    Color{196, 44, 66, 255}, Color{128, 32, 112, 255},  Color{44, 22, 84, 255}};

/// Bands repeat this order; neighbours differ in lightness as well as in hue.
constexpr std::array<Color, 8> bandColors{Color{44, 62, 132, 255},  Color{62, 140, 196, 255}, Color{40, 106, 90, 255},
                                          Color{118, 186, 92, 255}, Color{186, 120, 30, 255}, Color{246, 206, 72, 255},
                                          Color{172, 44, 44, 255},  Color{250, 196, 186, 255}};

constexpr std::array<Color, 3> negativeStops{backgroundColor, Color{49, 106, 196, 255}, Color{170, 214, 255, 255}};
constexpr std::array<Color, 3> positiveStops{backgroundColor, Color{200, 52, 42, 255}, Color{255, 206, 170, 255}};
constexpr std::array<Color, 3> lightNegativeStops{lightBackground, Color{64, 132, 220, 255}, Color{8, 36, 104, 255}};
constexpr std::array<Color, 3> lightPositiveStops{lightBackground, Color{226, 84, 62, 255}, Color{104, 14, 10, 255}};

uint8_t Mix(uint8_t from, uint8_t to, double share) {
    return static_cast<uint8_t>(from + (static_cast<double>(to) - from) * share + 0.5);
}

Color Mix(const Color& from, const Color& to, double share) {
    return {Mix(from.r, to.r, share), Mix(from.g, to.g, share), Mix(from.b, to.b, share), 255};
}

/// Colour at `position` 0…1 of evenly spaced stops.
template <size_t count>
Color Interpolate(const std::array<Color, count>& stops, double position) {
    const double scaled = std::clamp(position, 0.0, 1.0) * static_cast<double>(count - 1);
    const size_t index = std::min(static_cast<size_t>(scaled), count - 2);
    return Mix(stops[index], stops[index + 1], scaled - static_cast<double>(index));
}

/// log2 of x ≥ 1, linear between powers of two: near enough for colours, and exact arithmetic on every machine.
double ApproximateLog2(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);  // 0.5 … 1
    return (exponent - 1) + (mantissa * 2 - 1);
}

Color GetBandColor(uint32_t count, uint32_t scaleMax, const Color& background) {
    if (count == 0) return background;
    // Up to 8 bands of equal width over 1…scaleMax.
    const uint64_t bands = std::min<uint64_t>(bandColors.size(), scaleMax);
    return bandColors[static_cast<size_t>((static_cast<uint64_t>(count) - 1) * bands / scaleMax)];
}

}  // namespace

Style ParseStyle(std::string_view text) {
    for (const Style style : {Style::alpha, Style::heat, Style::bands, Style::log}) {
        if (text == GetStyleName(style)) return style;
    }
    throw std::invalid_argument("unknown style '" + std::string(text) + "': use alpha, heat, bands or log");
}

const char* GetStyleName(Style style) {
    switch (style) {
        case Style::alpha:
            return "alpha";
        case Style::heat:
            return "heat";
        case Style::bands:
            return "bands";
        case Style::log:
            return "log";
    }
    return "";
}

std::vector<Color> MakePalette(Style style, double opacity, uint32_t scaleMax, Theme theme) {
    scaleMax = std::max(scaleMax, 1u);
    const Color& background = GetTheme(theme).background;
    const auto& stops = theme == Theme::dark ? heatStops : lightHeatStops;
    std::vector<Color> palette;
    palette.reserve(static_cast<size_t>(scaleMax) + 1);
    double uncovered = 1.0;  // (1 − a)^n by repeated products: std::pow may differ in the last bit between libraries
    for (uint64_t count = 0; count <= scaleMax; ++count) {
        const double share = static_cast<double>(count) / scaleMax;
        switch (style) {
            case Style::alpha:
                palette.push_back(Mix(layerColor, background, uncovered));
                break;
            case Style::heat:
                palette.push_back(Interpolate(stops, share));
                break;
            case Style::bands:
                palette.push_back(GetBandColor(static_cast<uint32_t>(count), scaleMax, background));
                break;
            case Style::log:
                palette.push_back(Interpolate(stops, GetScalePosition(style, static_cast<double>(count), scaleMax)));
                break;
        }
        uncovered *= 1.0 - opacity;
    }
    return palette;
}

double GetScalePosition(Style style, double count, uint32_t scaleMax) {
    const double end = std::max(scaleMax, 1u);
    const double clamped = std::clamp(count, 0.0, end);
    return style == Style::log ? ApproximateLog2(clamped + 1) / ApproximateLog2(end + 1) : clamped / end;
}

Color GetDifferenceColor(int64_t value, int64_t scaleMax, Theme theme) {
    const double share =
        static_cast<double>(value < 0 ? -value : value) / static_cast<double>(std::max<int64_t>(scaleMax, 1));
    const bool isDark = theme == Theme::dark;
    if (value < 0) return Interpolate(isDark ? negativeStops : lightNegativeStops, share);
    return Interpolate(isDark ? positiveStops : lightPositiveStops, share);
}

Image ColorCounts(const CountImage& counts, const std::vector<Color>& palette) {
    Image image(counts.width, counts.height, backgroundColor);
    const size_t last = palette.size() - 1;
    std::transform(counts.counts.begin(), counts.counts.end(), image.pixels.begin(),
                   [&palette, last](uint32_t count) { return palette[std::min<size_t>(count, last)]; });
    return image;
}

Image ColorDifference(const CountImage& first, const CountImage& second, int64_t scaleMax, Theme theme) {
    if (first.width != second.width || first.height != second.height) {
        throw std::invalid_argument("pictures of different sizes have no difference");
    }
    // The scale is cut off at its ends, so a table of one colour per value in between serves all pixels.
    scaleMax = std::max<int64_t>(scaleMax, 1);
    std::vector<Color> table;
    for (int64_t value = -scaleMax; value <= scaleMax; ++value)
        table.push_back(GetDifferenceColor(value, scaleMax, theme));
    Image image(first.width, first.height, backgroundColor);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const int64_t value = static_cast<int64_t>(first.counts[i]) - static_cast<int64_t>(second.counts[i]);
        image.pixels[i] = table[static_cast<size_t>(std::clamp(value, -scaleMax, scaleMax) + scaleMax)];
    }
    return image;
}

}  // namespace testbed
