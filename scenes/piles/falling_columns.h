// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The arrangement shared by falling-squares and falling-circles: 15 columns of bodies over a 200 m wide ground; column
// i has n − i bodies of size a = 0.5 + i/15 · 2.5. Size → ground bodies in the scene, and a call per falling body.

#pragma once

#include <algorithm>
#include <cmath>

#include "scenes/build.h"

namespace scenes {

/// Sizes above this one repeat this block instead of growing it, because its density of bodies is what the scene is
/// for.
inline constexpr int fallingBlockSize = 300;
inline constexpr int fallingColumns = 15;

/// How many blocks a size stands for: 1 up to 300, then n / 300 rounded up to whole blocks.
[[nodiscard]] constexpr int FallingBlocks(int n) { return std::max(1, (n + fallingBlockSize - 1) / fallingBlockSize); }

/// Builds ground and columns; `addFalling(i, j, n, a, origin)` adds the body of column i and row j for a block at
/// `origin`. Blocks stand on a grid of pitch 210 m × 1800 m (a block is 200 m × 1720 m). The grid is about as wide as
/// it is high so that coordinates stay small. One block always has its origin at (0, 0).
template <typename AddFalling>
void BuildFallingColumns(Scene& scene, int n, AddFalling addFalling) {
    const int blocks = FallingBlocks(n);
    const int rowsOfBlocks = std::max(1, static_cast<int>(std::lround(std::sqrt(blocks * 210.0 / 1800.0))));
    const int blocksPerRow = (blocks + rowsOfBlocks - 1) / rowsOfBlocks;
    const int perBlock = std::min(n, fallingBlockSize);
    Reserve(scene, blocks * (1 + fallingColumns * perBlock), blocks * (1 + fallingColumns * perBlock));
    for (int block = 0; block < blocks; ++block) {
        const Vec2 origin = Point(210.0 * (block % blocksPerRow - blocksPerRow / 2),
                                  1800.0 * (block / blocksPerRow - rowsOfBlocks / 2));
        AddBody(scene, BodyType::isStatic, Point(origin.x, origin.y - 10.0));
        AddFixture(scene, Box(100.0, 3.0));
        for (int i = 0; i < fallingColumns; ++i) {
            const double a = 0.5 + i / 15.0 * 2.5;
            for (int j = i; j < perBlock; ++j) addFalling(i, j, perBlock, a, origin);
        }
    }
}

}  // namespace scenes
