// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Joints of a scene for Box2D 3, which names their frames on both bodies and their springs by frequency.

#pragma once

#include <box2d/box2d.h>

#include <span>

#include "scenes/scene.h"

namespace testbed::box2d3 {

/// Throws std::invalid_argument for gears, pulleys and motor joints. `bodies` by index.
[[nodiscard]] b2JointId CreateJoint(b2WorldId world, const scenes::Joint& joint, std::span<const b2BodyId> bodies);

}  // namespace testbed::box2d3
