// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The support functions that scenes use, by name: a file can say "lens" where it cannot hold code.

#pragma once

#include <span>
#include <string_view>

#include "scenes/scene.h"

namespace scenes {

struct NamedSupport {
    std::string_view name;
    SupportFunction function = nullptr;
};

/// All of them. A shape of ShapeType::supported uses one of these, or it cannot be written to a file.
[[nodiscard]] std::span<const NamedSupport> SupportFunctions();

/// Where two disks of radius 1 with centres at (0, ±0.6) overlap: tips at (±0.8, 0), arcs between them.
[[nodiscard]] Vec2 LensSupport(Vec2 direction);

}  // namespace scenes
