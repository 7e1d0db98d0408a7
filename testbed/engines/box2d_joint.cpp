// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of box2d_joint.h: the names of Box2D for joint_maker.h.

#include "testbed/engines/box2d_joint.h"

#include <box2d/box2d.h>

#include "testbed/engines/box2d_shape.h"
#include "testbed/engines/joint_maker.h"

namespace testbed {
namespace {

/// For joint_maker.h.
struct Box2dJointNames {
    using World = b2World;
    using Body = b2Body;
    using Joint = b2Joint;
    using Mouse = b2MouseJoint;
    using RevoluteDef = b2RevoluteJointDef;
    using DistanceDef = b2DistanceJointDef;
    using FrictionDef = b2FrictionJointDef;
    using MotorDef = b2MotorJointDef;
    using PrismaticDef = b2PrismaticJointDef;
    using PulleyDef = b2PulleyJointDef;
    using WeldDef = b2WeldJointDef;
    using WheelDef = b2WheelJointDef;
    using GearDef = b2GearJointDef;
    using MouseDef = b2MouseJointDef;

    static b2Vec2 ToOwn(scenes::Vec2 v) { return ToB2(v); }
};

}  // namespace

b2Joint* CreateBox2dJoint(b2World& world, const scenes::Joint& joint, const Box2dBodies& bodies,
                          const Box2dJoints& joints) {
    return JointMaker<Box2dJointNames>::Create(world, joint, bodies, joints);
}

}  // namespace testbed
