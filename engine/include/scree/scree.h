// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Everything a program needs to simulate.

#pragma once

#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "Scree needs C++20: compile with -std=c++20."
#endif

#include "scree/accuracy.h"
#include "scree/body.h"
#include "scree/broad_phase_kind.h"
#include "scree/chain_shape.h"
#include "scree/collision.h"
#include "scree/contact.h"
#include "scree/convex_shape.h"
#include "scree/distance.h"
#include "scree/distance_joint.h"
#include "scree/draw.h"
#include "scree/dynamic_tree.h"
#include "scree/errors.h"
#include "scree/events.h"
#include "scree/far_position.h"
#include "scree/features.h"
#include "scree/fixed_world.h"
#include "scree/fixture.h"
#include "scree/forces.h"
#include "scree/friction_joint.h"
#include "scree/gear_joint.h"
#include "scree/ids.h"
#include "scree/joint.h"
#include "scree/math.h"
#include "scree/motor_joint.h"
#include "scree/mouse_joint.h"
#include "scree/mover.h"
#include "scree/prismatic_joint.h"
#include "scree/profile.h"
#include "scree/pulley_joint.h"
#include "scree/queries.h"
#include "scree/recording.h"
#include "scree/revolute_joint.h"
#include "scree/settings.h"
#include "scree/shape.h"
#include "scree/snapshot.h"
#include "scree/time_of_impact.h"
#include "scree/weld_joint.h"
#include "scree/wheel_joint.h"
#include "scree/world.h"
#include "scree/world_callbacks.h"
