// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A scene's joint as a Box2D joint: joint and the world's bodies and joints by scene index in, new joint out.

#pragma once

#include <vector>

#include "scenes/scene.h"

class b2Body;
class b2Joint;
class b2World;

namespace testbed {

using Box2dBodies = std::vector<b2Body*>;
using Box2dJoints = std::vector<b2Joint*>;

/// `joints` holds those that a gear couples.
[[nodiscard]] b2Joint* CreateBox2dJoint(b2World& world, const scenes::Joint& joint, const Box2dBodies& bodies,
                                        const Box2dJoints& joints);

}  // namespace testbed
