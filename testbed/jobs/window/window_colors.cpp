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
    .more = {Pack(120, 220, 170), Pack(224, 150, 200), Pack(200, 210, 90)},
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
    .more = {Pack(0, 112, 80), Pack(150, 50, 110), Pack(95, 95, 0)},
};

}  // namespace

const WindowColors& GetWindowColors(Theme theme) { return theme == Theme::dark ? darkColors : lightColors; }

PackedColor GetPaneColor(const Viewer& viewer, size_t choice) {
    const WindowColors& colors = GetWindowColors(viewer.look.theme);
    size_t further = 0;
    for (size_t i = 0; i <= choice; ++i) {
        const auto isSame = [&](size_t j) {
            return viewer.choices[j].pane.spec.engine == viewer.choices[i].pane.spec.engine;
        };
        bool isFirst = true;
        for (size_t j = 0; j < i; ++j) isFirst = isFirst && !isSame(j);
        if (i == choice && isFirst) return viewer.choices[i].pane.spec.engine == "box2d" ? colors.box2d : colors.scree;
        further += isFirst ? 0 : 1;
    }
    return colors.more[(further - 1) % colors.more.size()];
}

}  // namespace testbed
