// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The two tables of colours.

#include "testbed/picture/theme.h"

#include <stdexcept>
#include <string>

#include "testbed/picture/palette.h"

namespace testbed {

namespace {

constexpr Color orange{230, 159, 0}, skyBlue{86, 180, 233}, green{0, 158, 115}, yellow{240, 228, 66}, blue{0, 114, 178},
    vermilion{213, 94, 0}, purple{204, 121, 167};
// Blue, green and vermilion are too dark for lines on dark grey, yellow too pale for lines on white.
constexpr Color lightBlue{60, 120, 220}, lightGreen{36, 196, 150}, lightVermilion{240, 120, 48}, darkYellow{100, 96, 0};

constexpr Color WithAlpha(const Color& color, uint8_t alpha) { return {color.r, color.g, color.b, alpha}; }

/// `fill` and `border` are opacities.
constexpr Look MakeLook(const Color& color, uint8_t fill, uint8_t border) {
    return {WithAlpha(color, fill), WithAlpha(color, border)};
}

constexpr ThemeColors darkColors{
    .background = backgroundColor,
    .strip = {24, 24, 24},
    .text = {232, 232, 232},
    .faintText = {170, 170, 170},
    .awake = MakeLook(skyBlue, 96, 190),
    .sleeping = MakeLook({120, 120, 120}, 80, 190),
    .isStatic = MakeLook(lightGreen, 72, 150),
    .kinematic = MakeLook(purple, 96, 200),
    .bullet = MakeLook(orange, 130, 235),
    .sensor = MakeLook(yellow, 36, 170),
    .contact = yellow,
    .normal = {235, 235, 235},
    .impulse = lightVermilion,
    .joint = WithAlpha({228, 150, 196}, 220),
    .velocity = WithAlpha(lightGreen, 235),
    .tightBox = {225, 225, 225, 150},
    .sweptBox = WithAlpha(yellow, 160),
    .fattenedBox = WithAlpha(orange, 160),
    .label = {255, 255, 255},
    .cycle = {orange, skyBlue, lightGreen, yellow, lightBlue, lightVermilion, purple},
};

constexpr ThemeColors lightColors{
    .background = {250, 250, 250},
    .strip = {228, 228, 228},
    .text = {20, 20, 20},
    .faintText = {80, 80, 80},
    .awake = MakeLook(skyBlue, 120, 255),
    .sleeping = MakeLook({105, 105, 105}, 50, 170),
    .isStatic = MakeLook(green, 80, 190),
    .kinematic = MakeLook(purple, 110, 230),
    .bullet = MakeLook(orange, 150, 255),
    .sensor = MakeLook(yellow, 70, 255),
    .contact = {0, 0, 0},
    .normal = blue,
    .impulse = vermilion,
    .joint = WithAlpha({168, 70, 124}, 220),
    .velocity = WithAlpha({0, 122, 88}, 235),
    .tightBox = {60, 60, 60, 150},
    .sweptBox = WithAlpha(darkYellow, 190),
    .fattenedBox = WithAlpha(vermilion, 160),
    .label = {0, 0, 0},
    .cycle = {orange, skyBlue, green, darkYellow, blue, vermilion, purple},
};

}  // namespace

Theme ParseTheme(std::string_view text) {
    if (text == "dark") return Theme::dark;
    if (text == "light") return Theme::light;
    throw std::invalid_argument("unknown theme '" + std::string(text) + "': use dark or light");
}

const char* GetThemeName(Theme theme) { return theme == Theme::dark ? "dark" : "light"; }

const ThemeColors& GetTheme(Theme theme) { return theme == Theme::dark ? darkColors : lightColors; }

}  // namespace testbed
