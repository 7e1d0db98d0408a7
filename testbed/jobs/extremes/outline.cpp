// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of outline.h.

#include "testbed/jobs/extremes/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

namespace testbed {

namespace {

constexpr double width = 320.0, height = 240.0;  ///< of the picture, pixels
constexpr std::size_t mostBodies = 1500;

/// World → pixels.
struct View {
    Point centre;
    double scale = 1.0;  ///< pixels per m

    [[nodiscard]] Point At(Point p) const {
        return {0.5 * width + scale * (p.x - centre.x), 0.5 * height - scale * (p.y - centre.y)};
    }
    [[nodiscard]] bool Shows(Point p, double reach) const {
        const Point at = At(p);
        const double r = scale * reach;
        return at.x > -r && at.x < width + r && at.y > -r && at.y < height + r;
    }
};

double ReachOf(const scenes::Shape& shape) {
    switch (shape.type) {
        case scenes::ShapeType::circle:
            return std::hypot(shape.center.x, shape.center.y) + double{shape.radius};
        case scenes::ShapeType::box:
            return std::hypot(shape.center.x, shape.center.y) + std::hypot(shape.halfExtents.x, shape.halfExtents.y);
        default: {
            double reach = 0.0;
            for (const scenes::Vec2 v : shape.Vertices()) reach = std::max(reach, double{std::hypot(v.x, v.y)});
            return reach;
        }
    }
}

/// The middle share of the values.
std::pair<double, double> MiddleRange(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t cut = values.size() / 20;
    return {values[cut], values[values.size() - 1 - cut]};
}

View FitView(const scenes::Scene& scene, std::span<const BodyReading> bodies) {
    std::vector<double> x, y;
    double reach = 0.0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (scene.bodies[i].type == scenes::BodyType::isStatic || !bodies[i].IsFinite()) continue;
        x.push_back(bodies[i].centre.x);
        y.push_back(bodies[i].centre.y);
        double own = 0.0;
        for (const scenes::Fixture& f : scene.FixturesOf(static_cast<int>(i))) own = std::max(own, ReachOf(f.shape));
        reach = std::max(reach, own);
    }
    if (x.empty()) return {{}, 1.0};
    const auto [left, right] = MiddleRange(x);
    const auto [low, high] = MiddleRange(y);
    const double margin = 1.3 * std::max(reach, 1e-6);
    return {{0.5 * (left + right), 0.5 * (low + high)},
            std::min(width / (right - left + 2.0 * margin), height / (high - low + 2.0 * margin))};
}

void DrawShape(std::string& svg, const View& view, const BodyReading& body, const scenes::Shape& shape,
               std::string_view look) {
    const auto place = [&](Point local) { return view.At(body.ToWorld(local)); };
    if (shape.type == scenes::ShapeType::circle) {
        const Point at = place({shape.center.x, shape.center.y});
        const Point rim = place({shape.center.x + shape.radius, shape.center.y});
        fmt::format_to(
            std::back_inserter(svg),
            "<circle cx='{0:.1f}' cy='{1:.1f}' r='{2:.1f}' {3}/><line x1='{0:.1f}' y1='{1:.1f}' x2='{4:.1f}' "
            "y2='{5:.1f}' {3}/>\n",
            at.x, at.y, view.scale * double{shape.radius}, look, rim.x, rim.y);
        return;
    }
    std::vector<Point> corners;
    if (shape.type == scenes::ShapeType::box) {
        const double c = std::cos(double{shape.angle}), s = std::sin(double{shape.angle});
        for (const auto& [sx, sy] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
            const double x = sx * double{shape.halfExtents.x}, y = sy * double{shape.halfExtents.y};
            corners.push_back({shape.center.x + c * x - s * y, shape.center.y + s * x + c * y});
        }
    } else {
        for (const scenes::Vec2 v : shape.Vertices()) corners.push_back({v.x, v.y});
    }
    if (corners.empty()) return;
    svg += "<polygon points='";
    for (const Point corner : corners) {
        const Point at = place(corner);
        // Far corners of a long floor are cut where they no longer matter, so that the text stays short.
        fmt::format_to(std::back_inserter(svg), "{:.1f},{:.1f} ", std::clamp(at.x, -1e5, 1e5),
                       std::clamp(at.y, -1e5, 1e5));
    }
    fmt::format_to(std::back_inserter(svg), "' {}/>\n", look);
}

}  // namespace

std::string DrawOutline(const scenes::Scene& scene, std::span<const BodyReading> bodies) {
    const View view = FitView(scene, bodies);
    std::string svg = fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}'>\n<rect width='{0}' "
        "height='{1}' fill='#ffffff'/>\n",
        width, height);
    // Of many bodies every second, third … so that the whole of a large pile shows; all that do not move.
    const std::size_t stride = 1 + bodies.size() / mostBodies;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < bodies.size() && drawn < mostBodies; ++i) {
        const bool moving = scene.bodies[i].type != scenes::BodyType::isStatic;
        if (!bodies[i].IsFinite() || (moving && i % stride != 0)) continue;
        for (const scenes::Fixture& fixture : scene.FixturesOf(static_cast<int>(i))) {
            if (!view.Shows(bodies[i].origin, ReachOf(fixture.shape))) continue;
            DrawShape(svg, view, bodies[i], fixture.shape,
                      moving ? "fill='#cc000033' stroke='#cc0000' stroke-width='0.6'"
                             : "fill='#55555533' stroke='#555555' stroke-width='0.6'");
            if (++drawn >= mostBodies) break;
        }
    }
    return svg + "</svg>\n";
}

}  // namespace testbed
