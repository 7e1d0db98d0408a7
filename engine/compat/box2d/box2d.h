// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D 2.4's public interface over scree: the header that programs include.

#pragma once

#include "b2_block_allocator.h"
#include "b2_body.h"
#include "b2_broad_phase.h"
#include "b2_chain_shape.h"
#include "b2_circle_shape.h"
#include "b2_contact.h"
#include "b2_contact_manager.h"
#include "b2_distance.h"
#include "b2_distance_joint.h"
#include "b2_draw.h"
#include "b2_dynamic_tree.h"
#include "b2_edge_shape.h"
#include "b2_fixture.h"
#include "b2_friction_joint.h"
#include "b2_gear_joint.h"
#include "b2_motor_joint.h"
#include "b2_mouse_joint.h"
#include "b2_polygon_shape.h"
#include "b2_prismatic_joint.h"
#include "b2_pulley_joint.h"
#include "b2_revolute_joint.h"
#include "b2_settings.h"
#include "b2_stack_allocator.h"
#include "b2_time_of_impact.h"
#include "b2_time_step.h"
#include "b2_timer.h"
#include "b2_weld_joint.h"
#include "b2_wheel_joint.h"
#include "b2_world.h"
#include "b2_world_callbacks.h"
