// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The arrangement shared by the two mostly-static scenes: an n × n grid of unit cells. Static boxes are in those more
// than 3 off the diagonal. In each diagonal cell is a dynamic circle, which slides down the corridor. Size → a call per
// cell.

#pragma once

#include <cstdlib>

#include "scenes/build.h"

namespace scenes {

/// Half the side of a cell, m.
inline constexpr double gridHalfCell = 0.5;

/// How many static boxes a grid of n × n has: n² less the diagonal, less 2(n − k) for each k = 1, 2, 3.
[[nodiscard]] constexpr int StaticGridBoxes(int n) { return n > 3 ? (n - 3) * (n - 4) : 0; }

/// Calls addStatic(center) or addDynamic(center) for the cells in use, row by row.
template <typename AddStatic, typename AddDynamic>
void ForEachGridCell(int n, AddStatic addStatic, AddDynamic addDynamic) {
    constexpr double a = gridHalfCell;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const Vec2 center = Point(-n * a + 2.0 * a * i, -2.0 * a * j);
            if (std::abs(j - i) > 3) addStatic(center);
            if (i == j) addDynamic(center);
        }
    }
}

/// A circle of the diagonal, twice as wide as a cell.
inline void AddDiagonalCircle(Scene& scene, Vec2 center) {
    AddBody(scene, BodyType::dynamic, center);
    AddFixture(scene, Circle(2.0 * gridHalfCell), 1.0);
}

}  // namespace scenes
