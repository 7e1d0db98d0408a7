// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Convex shapes: n rows of six bodies, one of each further shape, fall onto a floor between walls. The shapes are
// capsule, rounded box, polygon of twelve corners, ellipse, slice of a disk, and a lens given by its support function.
// Size → scene.

#include <array>

#include "scenes/build.h"
#include "scenes/support.h"

namespace scenes {

namespace {

Shape Twelve(Scene& scene) {
    std::array<Vec2, 12> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto [sin, cos] = SinCos(2.0 * pi * static_cast<double>(i) / 12.0);
        corners[i] = Point(0.7 * cos, 0.7 * sin);
    }
    return LargePolygon(scene, corners);
}

}  // namespace

Scene ConvexShapes(int n) {
    Scene scene;
    AddBody(scene, BodyType::isStatic, {});
    for (const Shape& shape :
         {Box(8.0, 0.5, {0.0f, -0.5f}), Box(0.5, 6.0, {-8.5f, 5.0f}), Box(0.5, 6.0, {8.5f, 5.0f})}) {
        AddFixture(scene, shape);
    }
    const std::array<Shape, 6> shapes{Capsule({-0.6f, 0.0f}, {0.6f, 0.0f}, 0.35),
                                      RoundedPolygon({{-0.5f, -0.4f}, {0.5f, -0.4f}, {0.5f, 0.4f}, {-0.5f, 0.4f}}, 0.2),
                                      Twelve(scene),
                                      Ellipse(0.9, 0.45),
                                      Sector(1.1, 1.2, {-0.5f, 0.0f}),
                                      Supported(LensSupport, 0.8)};
    for (int row = 0; row < n; ++row) {
        for (int i = 0; i < 6; ++i) {
            // Kinds change place from row to row, and odd rows stand aside.
            Body& body =
                AddBody(scene, BodyType::dynamic, Point(-6.25 + 2.4 * i + (row % 2 == 0 ? 0.0 : 0.5), 1.5 + 2.2 * row));
            body.angle = static_cast<float>(0.3 * (i - row));
            AddFixture(scene, shapes[static_cast<std::size_t>((i + row) % 6)], 1.0).friction = 0.4f;
        }
    }
    return scene;
}

}  // namespace scenes
