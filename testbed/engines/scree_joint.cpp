// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of scree_joint.h: the names of our engine for joint_maker.h.

#include "testbed/engines/scree_joint.h"

#include "scree/distance_joint.h"
#include "scree/friction_joint.h"
#include "scree/gear_joint.h"
#include "scree/motor_joint.h"
#include "scree/mouse_joint.h"
#include "scree/prismatic_joint.h"
#include "scree/pulley_joint.h"
#include "scree/revolute_joint.h"
#include "scree/weld_joint.h"
#include "scree/wheel_joint.h"

#include "testbed/engines/joint_maker.h"
#include "testbed/engines/scree_shape.h"

namespace testbed {
namespace {

/// For joint_maker.h.
struct ScreeJointNames {
    using World = scree::World;
    using Body = scree::Body;
    using Joint = scree::Joint;
    using Mouse = scree::MouseJoint;
    using RevoluteDef = scree::RevoluteJointDef;
    using DistanceDef = scree::DistanceJointDef;
    using FrictionDef = scree::FrictionJointDef;
    using MotorDef = scree::MotorJointDef;
    using PrismaticDef = scree::PrismaticJointDef;
    using PulleyDef = scree::PulleyJointDef;
    using WeldDef = scree::WeldJointDef;
    using WheelDef = scree::WheelJointDef;
    using GearDef = scree::GearJointDef;
    using MouseDef = scree::MouseJointDef;

    static scree::Vec2 ToOwn(scenes::Vec2 v) { return ToScree(v); }
};

}  // namespace

scree::Joint* CreateScreeJoint(scree::World& world, const scenes::Joint& joint, const ScreeBodies& bodies,
                               const ScreeJoints& joints) {
    return JointMaker<ScreeJointNames>::Create(world, joint, bodies, joints);
}

}  // namespace testbed
