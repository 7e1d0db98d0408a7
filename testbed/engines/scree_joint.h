// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene's joint as a joint of ours: joint and the world's bodies and joints by scene index in, new joint out.

#pragma once

#include <vector>

#include "scenes/scene.h"
#include "scree/world.h"

namespace testbed {

using ScreeBodies = std::vector<scree::Body*>;
using ScreeJoints = std::vector<scree::Joint*>;

/// Null if the world refuses it. `joints` holds those that a gear couples.
[[nodiscard]] scree::Joint* CreateScreeJoint(scree::World& world, const scenes::Joint& joint, const ScreeBodies& bodies,
                                             const ScreeJoints& joints);

}  // namespace testbed
