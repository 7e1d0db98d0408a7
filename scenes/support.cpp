// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Support functions, and their names.

#include "scenes/support.h"

#include <array>
#include <cmath>

#include "scenes/build.h"

namespace scenes {

Vec2 LensSupport(Vec2 direction) {
    constexpr double centre = 0.6, tip = 0.8;
    const double x = direction.x, y = direction.y;
    if (std::abs(y) < centre) return Point(x > 0.0 ? tip : -tip, 0.0);
    return Point(x, y > 0.0 ? y - centre : y + centre);
}

std::span<const NamedSupport> SupportFunctions() {
    static constexpr std::array<NamedSupport, 1> functions{{{"lens", LensSupport}}};
    return functions;
}

}  // namespace scenes
