// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Clipping is Sutherland and Hodgman, "Reentrant polygon clipping", 1974.

#include "testbed/view/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace testbed {

namespace {

constexpr int maxCircleCorners = 64;

/// Unit directions k·2π/64 by halving angles: cos and sin of the library may differ in the last bit between machines,
/// square roots may not.
std::array<Point, maxCircleCorners> MakeDirections() {
    std::array<Point, maxCircleCorners> directions{};
    directions[0] = {1, 0};
    directions[maxCircleCorners / 4] = {0, 1};
    for (int step = maxCircleCorners / 4; step > 1; step /= 2) {
        for (int k = 0; k < maxCircleCorners / 4; k += step) {
            const Point& a = directions[static_cast<size_t>(k)];
            const Point& b = directions[static_cast<size_t>(k + step)];
            const Point sum{a.x + b.x, a.y + b.y};
            const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y);
            directions[static_cast<size_t>(k + step / 2)] = {sum.x / length, sum.y / length};
        }
    }
    for (size_t k = maxCircleCorners / 4; k < maxCircleCorners; ++k) {
        const Point& quarterBefore = directions[k - maxCircleCorners / 4];
        directions[k] = {-quarterBefore.y, quarterBefore.x};
    }
    return directions;
}

/// Keeps the side of an axis-parallel line where sign·(coordinate − limit) ≥ 0.
void ClipSide(std::span<const Point> in, std::vector<Point>& out, double Point::*coordinate, double sign,
              double limit) {
    out.clear();
    for (size_t i = 0; i < in.size(); ++i) {
        const Point& from = in[i];
        const Point& to = in[(i + 1) % in.size()];
        const double fromDistance = sign * (from.*coordinate - limit);
        const double toDistance = sign * (to.*coordinate - limit);
        if (fromDistance >= 0) out.push_back(from);
        if ((fromDistance >= 0) != (toDistance >= 0)) {
            const double share = fromDistance / (fromDistance - toDistance);
            Point crossing{from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share};
            crossing.*coordinate = limit;
            out.push_back(crossing);
        }
    }
}

/// Corners for a circle whose polygon is at most about 1/8 sample inside it: 1 − cos(π/n) ≤ 1/(8r).
int GetCornerCount(double radiusInSamples) {
    if (radiusInSamples < 3) return 8;
    if (radiusInSamples < 12) return 16;
    if (radiusInSamples < 60) return 32;
    return maxCircleCorners;
}

/// The polygon whose edges lie `distance` inside those of a convex polygon; false when nothing is left.
bool InsetConvex(std::span<const Point> points, double distance, std::vector<Point>& inner) {
    double area = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const Point& p = points[i];
        const Point& q = points[(i + 1) % points.size()];
        area += p.x * q.y - p.y * q.x;
    }
    if (area == 0) return false;
    const double inward = area > 0 ? distance : -distance;
    inner.clear();
    for (size_t i = 0; i < points.size(); ++i) {
        const Point& before = points[(i + points.size() - 1) % points.size()];
        const Point& corner = points[i];
        const Point& after = points[(i + 1) % points.size()];
        Point u{corner.x - before.x, corner.y - before.y};
        Point v{after.x - corner.x, after.y - corner.y};
        const double uLength = std::sqrt(u.x * u.x + u.y * u.y);
        const double vLength = std::sqrt(v.x * v.x + v.y * v.y);
        if (uLength == 0 || vLength == 0) return false;
        u = {u.x / uLength, u.y / uLength};
        v = {v.x / vLength, v.y / vLength};
        const double sine = u.x * v.y - u.y * v.x;
        const double cosine = u.x * v.x + u.y * v.y;
        if (1 + cosine < 1e-6) return false;
        // Inward normals are (−uy, ux) and (−vy, vx); the new corner is at distance `inward` from both edges.
        const double along = inward * sine / (1 + cosine);
        inner.push_back({corner.x - u.y * inward - u.x * along, corner.y + u.x * inward - u.y * along});
    }
    // Once an edge runs backwards, the inset has passed the polygon's core.
    for (size_t i = 0; i < points.size(); ++i) {
        const size_t next = (i + 1) % points.size();
        const double forward = (points[next].x - points[i].x) * (inner[next].x - inner[i].x) +
                               (points[next].y - points[i].y) * (inner[next].y - inner[i].y);
        if (!(forward > 0)) return false;
    }
    return true;
}

}  // namespace

void Canvas::FillConvex(std::span<const Point> points, Color color) {
    const double width = m_list.width, height = m_list.height;
    bool isInside = true;
    for (const Point& point : points) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) return;
        isInside = isInside && point.x >= 0 && point.x <= width && point.y >= 0 && point.y <= height;
    }
    std::span<const Point> visible = points;
    if (!isInside) {
        ClipSide(points, m_clipped, &Point::x, 1, 0);
        ClipSide(m_clipped, m_scratch, &Point::x, -1, width);
        ClipSide(m_scratch, m_clipped, &Point::y, 1, 0);
        ClipSide(m_clipped, m_scratch, &Point::y, -1, height);
        visible = m_scratch;
    }
    if (visible.size() < 3) return;
    const double scale = static_cast<double>(m_list.supersampling) * fixedPointOne;
    const auto snap = [scale](const Point& point) {
        return FixedPoint{static_cast<int32_t>(std::floor(point.x * scale + 0.5)),
                          static_cast<int32_t>(std::floor(point.y * scale + 0.5))};
    };
    const FixedPoint first = snap(visible[0]);
    FixedPoint last = snap(visible[1]);
    for (size_t i = 2; i < visible.size(); ++i) {
        const FixedPoint next = snap(visible[i]);
        m_list.triangles.push_back({first, last, next, color});
        last = next;
    }
}

void Canvas::DrawConvex(std::span<const Point> points, Color fill, Color border, double lineWidth) {
    FillConvex(points, border);
    if (InsetConvex(points, lineWidth, m_inner)) FillConvex(m_inner, fill);
}

void Canvas::DrawCircle(Point center, double radius, Point axis, Color fill, Color border, double lineWidth) {
    static const std::array<Point, maxCircleCorners> directions = MakeDirections();
    const int corners = GetCornerCount(radius * m_list.supersampling);
    const auto addRing = [&](double ringRadius) {
        m_points.clear();
        for (int k = 0; k < corners; ++k) {
            const Point& direction = directions[static_cast<size_t>(k * (maxCircleCorners / corners))];
            m_points.push_back({center.x + ringRadius * (axis.x * direction.x - axis.y * direction.y),
                                center.y + ringRadius * (axis.x * direction.y + axis.y * direction.x)});
        }
    };
    addRing(radius);
    FillConvex(m_points, border);
    if (radius <= lineWidth) return;
    addRing(radius - lineWidth);
    FillConvex(m_points, fill);
}

void Canvas::DrawLine(Point from, Point to, double width, Color color) {
    const Point along{to.x - from.x, to.y - from.y};
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    if (!(length > 0)) return;
    const Point side{-along.y / length * width * 0.5, along.x / length * width * 0.5};
    FillConvex(std::array<Point, 4>{Point{from.x + side.x, from.y + side.y}, Point{to.x + side.x, to.y + side.y},
                                    Point{to.x - side.x, to.y - side.y}, Point{from.x - side.x, from.y - side.y}},
               color);
}

void Canvas::DrawFrame(Point lower, Point upper, double lineWidth, Color color) {
    const double w = std::min({lineWidth, (upper.x - lower.x) * 0.5, (upper.y - lower.y) * 0.5});
    const auto fillRect = [this, color](double x0, double y0, double x1, double y1) {
        FillConvex(std::array<Point, 4>{Point{x0, y0}, Point{x1, y0}, Point{x1, y1}, Point{x0, y1}}, color);
    };
    fillRect(lower.x, lower.y, upper.x, lower.y + w);
    fillRect(lower.x, upper.y - w, upper.x, upper.y);
    fillRect(lower.x, lower.y, lower.x + w, upper.y);
    fillRect(upper.x - w, lower.y, upper.x, upper.y);
}

void Canvas::DrawDisk(Point center, double radius, Color color) {
    DrawCircle(center, radius, {1, 0}, color, color, radius);
}

}  // namespace testbed
