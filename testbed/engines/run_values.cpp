// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of run_values.h.

#include "testbed/engines/run_values.h"

#include <cmath>
#include <utility>

namespace testbed {

std::string FindProblem(const BodyEdit& edit) {
    constexpr float most = 1e9f;
    const auto isNumber = [](float value) { return std::abs(value) <= most; };
    const auto isVector = [&](const std::optional<scenes::Vec2>& v) {
        return !v || (isNumber(v->x) && isNumber(v->y));
    };
    if (!isVector(edit.position)) return "position: give numbers up to 1e9";
    if (!isVector(edit.linearVelocity)) return "velocity: give numbers up to 1e9";
    for (const auto& [name, value] : {std::pair{"angle", edit.angle}, std::pair{"spin", edit.angularVelocity},
                                      std::pair{"gravity scale", edit.gravityScale}}) {
        if (value && !isNumber(*value)) return std::string(name) + ": give a number up to 1e9";
    }
    for (const auto& [name, value] : {std::pair{"density", edit.density}, std::pair{"damping", edit.linearDamping},
                                      std::pair{"angular damping", edit.angularDamping}}) {
        if (value && !(*value >= 0.0f && *value <= most)) return std::string(name) + ": give 0 to 1e9";
    }
    return {};
}

}  // namespace testbed
