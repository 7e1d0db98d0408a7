// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a user sees and changes of one object of a run: values for an inspector, by their names, and edits of a body.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace testbed {

/// A value as an inspector lists it, with its unit.
struct RunValue {
    std::string name, value;
};
using RunValues = std::vector<RunValue>;

/// What changes of a body; what is not there stays. Of a body that is moved or pushed, sleep ends.
struct BodyEdit {
    std::optional<scenes::BodyType> type{};
    std::optional<scenes::Vec2> position{};        ///< of its origin, m
    std::optional<float> angle{};                  ///< rad
    std::optional<scenes::Vec2> linearVelocity{};  ///< of its centre of mass, m/s
    std::optional<float> angularVelocity{};        ///< rad/s
    std::optional<float> density{};                ///< of all its fixtures, kg/m²
    std::optional<float> linearDamping{}, angularDamping{}, gravityScale{};
    std::optional<bool> awake{}, bullet{}, fixedRotation{}, allowSleep{};

    friend bool operator==(const BodyEdit&, const BodyEdit&) = default;
};

/// What is wrong with an edit, "position: give finite numbers"; empty: nothing.
[[nodiscard]] std::string FindProblem(const BodyEdit& edit);

}  // namespace testbed
