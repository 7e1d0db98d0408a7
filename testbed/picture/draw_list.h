// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a layer consists of, ready for any rasteriser: triangles on a fixed-point grid in drawing order, and text. A
// triangle replaces what lies under it, so that no arithmetic on colours, which drivers round differently, decides a
// pixel; blending with the background happens later in integers.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbed/picture/image.h"

namespace testbed {

inline constexpr int32_t fixedPointOne = 256;  ///< units per sample: the subpixel grid of Mesa's rasteriser

/// A position in 1/256 of a sample, y down; sample i spans 256·i … 256·(i + 1).
struct FixedPoint {
    int32_t x, y;
};

/// Either winding. Corners lie inside the picture, borders included: the builder clips.
struct Triangle {
    FixedPoint a, b, c;
    Color color;
};

/// A line of text, drawn after the triangles.
struct TextItem {
    int x, y;  ///< as DrawText takes them, in picture pixels
    int scale;
    Color color;
    std::string text;
};

struct DrawList {
    int width = 0, height = 0;  ///< picture, pixels
    int supersampling = 1;      ///< samples along a pixel's edge
    std::vector<Triangle> triangles;
    std::vector<TextItem> texts;
};

}  // namespace testbed
