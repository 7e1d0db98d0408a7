// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The two tables of the window's colours.

#include "testbed/jobs/window/window_colors.h"

namespace testbed {

namespace {

constexpr PackedColor Pack(unsigned red, unsigned green, unsigned blue, unsigned alpha = 255) {
    return red | green << 8 | blue << 16 | alpha << 24;
}

constexpr WindowColors darkColors{
    .gap = {27, 28, 32, 255},
    .query = Pack(255, 226, 64),
    .visitedNode = Pack(255, 226, 64, 110),
    .leaf = Pack(90, 235, 170, 90),
    .path = Pack(255, 255, 255),
    .pathAbove = Pack(255, 255, 255, 90),
    .drag = Pack(120, 255, 160),
    .titleStrip = Pack(18, 19, 22, 215),
    .titleText = Pack(210, 212, 216),
    .plot = Pack(20, 21, 24),
    .plotLine = Pack(70, 72, 80),
    .plotText = Pack(220, 220, 224),
    .plotEnd = Pack(150, 152, 160),
    .scree = Pack(104, 190, 240),
    .box2d = Pack(240, 176, 40),
};

constexpr WindowColors lightColors{
    .gap = {206, 208, 212, 255},
    .query = Pack(150, 90, 0),
    .visitedNode = Pack(150, 90, 0, 130),
    .leaf = Pack(0, 158, 115, 80),
    .path = Pack(0, 0, 0),
    .pathAbove = Pack(0, 0, 0, 100),
    .drag = Pack(0, 122, 88),
    .titleStrip = Pack(228, 229, 232, 225),
    .titleText = Pack(50, 52, 58),
    .plot = Pack(252, 252, 252),
    .plotLine = Pack(190, 192, 198),
    .plotText = Pack(30, 30, 34),
    .plotEnd = Pack(96, 98, 104),
    .scree = Pack(0, 92, 160),
    .box2d = Pack(160, 84, 0),
};

}  // namespace

const WindowColors& GetWindowColors(Theme theme) { return theme == Theme::dark ? darkColors : lightColors; }

}  // namespace testbed
