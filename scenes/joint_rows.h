// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The rows of the joints: one classic per type of joint.

#pragma once

#include "scenes/catalog.h"

namespace scenes {

// Each is defined in the file of its name.
Scene JointDistance(int n);
Scene JointFriction(int n);
Scene JointGear(int n);
Scene JointMotor(int n);
Scene JointMouse(int n);
Scene JointPrismatic(int n);
Scene JointPulley(int n);
Scene JointRevolute(int n);
Scene JointWeld(int n);
Scene JointWheel(int n);

inline constexpr SceneInfo jointRows[] = {
    {.name = "joint-distance",
     .title = "boxes on a rod, a rope and three springs",
     .exercises = "distance joint: rod, limits, spring, damping",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 80,
     .build = JointDistance},
    {.name = "joint-friction",
     .title = "pucks braked by friction joints, seen from above",
     .exercises = "friction joint: largest force and torque",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 300,
     .showStep = 150,
     .build = JointFriction},
    {.name = "joint-gear",
     .title = "wheels coupled to wheels and to a rack",
     .exercises = "gear joint: both kinds of joints, either sign",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 90,
     .build = JointGear},
    {.name = "joint-motor",
     .title = "boxes driven to poses, with enough force and with too little",
     .exercises = "motor joint: offset, largest force and torque",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 60,
     .build = JointMotor},
    {.name = "joint-mouse",
     .title = "bodies pulled at a point",
     .exercises = "mouse joint: target, largest force",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 300,
     .showStep = 60,
     .build = JointMouse},
    {.name = "joint-prismatic",
     .title = "blocks on sliding axes",
     .exercises = "prismatic joint: axis, limit, motor",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 90,
     .build = JointPrismatic},
    {.name = "joint-pulley",
     .title = "three pairs of boxes on ropes",
     .exercises = "pulley joint: ratio, balance",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 300,
     .showStep = 120,
     .build = JointPulley},
    {.name = "joint-revolute",
     .title = "bars on hinges",
     .exercises = "revolute joint: limit, motor",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 70,
     .build = JointRevolute},
    {.name = "joint-weld",
     .title = "bars welded to a wall and to each other",
     .exercises = "weld joint: rigid, elastic",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 150,
     .build = JointWeld},
    {.name = "joint-wheel",
     .title = "carts on sprung wheels",
     .exercises = "wheel joint: spring, limit, motor",
     .folder = "joints",
     .isClassic = true,
     .hasSize = false,
     .defaultSize = 1,
     .maxSize = 1,
     .steps = 600,
     .showStep = 90,
     .build = JointWheel},
};

}  // namespace scenes
