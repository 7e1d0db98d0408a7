// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Shapes in continuous picture pixels in, triangles of a DrawList out: clips to the picture, then rounds to the 1/256
// grid. Only +, −, ·, ÷ and square roots, which every machine computes alike.

#pragma once

#include <span>
#include <vector>

#include "testbed/picture/draw_list.h"

namespace testbed {

/// A point in continuous picture pixels, y down.
struct Point {
    double x, y;
};

class Canvas {
public:
    /// Appends to `list`, whose size and supersampling are set already.
    explicit Canvas(DrawList& list) : m_list(list) {}

    /// A convex polygon of at least 3 points, either winding. Points that are not finite: nothing is drawn.
    void FillConvex(std::span<const Point> points, Color color);
    /// A convex polygon with a border of `lineWidth` pixels inside its edges; thin polygons are all border.
    void DrawConvex(std::span<const Point> points, Color fill, Color border, double lineWidth);
    /// A circle as a regular polygon; `axis` of length 1 is its first direction, so that it turns with its body.
    void DrawCircle(Point center, double radius, Point axis, Color fill, Color border, double lineWidth);
    /// A segment with flat ends.
    void DrawLine(Point from, Point to, double width, Color color);
    /// A frame inside the rectangle's edges.
    void DrawFrame(Point lower, Point upper, double lineWidth, Color color);
    void DrawDisk(Point center, double radius, Color color);

private:
    DrawList& m_list;
    std::vector<Point> m_points, m_inner, m_clipped, m_scratch;
};

}  // namespace testbed
