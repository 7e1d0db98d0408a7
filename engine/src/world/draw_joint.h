// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A joint → the calls of a Draw by which Box2D 2.4 shows it.

#pragma once

#include "scree/draw.h"
#include "scree/joint.h"

namespace scree {

void DrawJoint(const Joint& joint, Draw& draw);

}  // namespace scree
