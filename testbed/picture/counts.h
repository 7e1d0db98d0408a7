// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Overlap counts on the CPU: rectangles in, the number that cover each pixel out. A 2D difference array does it: four
// corner updates a rectangle, then prefix sums along rows and columns (Crow, "Summed-area tables", 1984, run
// backwards). This is the path without OpenGL, and the oracle of the path with it. So the rule by which a rectangle
// becomes whole pixels is written twice: SnapRect serves OpenGL, CountRects has its own.

#pragma once

#include <span>

#include "testbed/picture/image.h"

namespace testbed {

/// A rectangle in continuous pixel coordinates, y down: pixel i spans i…i+1, its centre is i + 0.5.
struct PixelRect {
    double x0, y0, x1, y1;
};

/// The pixels of a width × height picture whose centres lie in the rectangle, half-open: x0 ≤ centre < x1, y likewise.
/// The result is {0, 0, 0, 0} when there are none, also for reversed rectangles and NaN.
[[nodiscard]] PixelBox SnapRect(const PixelRect& rect, int width, int height);

/// How many rectangles cover each pixel's centre, by the same rule. O(rectangles + pixels).
[[nodiscard]] CountImage CountRects(std::span<const PixelRect> rects, int width, int height);

}  // namespace testbed
