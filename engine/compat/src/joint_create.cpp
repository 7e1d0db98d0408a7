// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A b2JointDef of any kind to a joint of the engine and its b2Joint.

#include "convert.h"
#include "world_data.h"

using namespace scree::box2d;

namespace {

scree::Joint* Create(scree::World& engine, scree::JointDef& out, const b2JointDef& def) {
    out.bodyA = b2Bridge::Handle(def.bodyA);
    out.bodyB = b2Bridge::Handle(def.bodyB);
    out.collideConnected = def.collideConnected;
    return engine.CreateJoint(&out);
}

template <typename Out, typename Def>
void CopyAnchors(Out& out, const Def& def) {
    out.localAnchorA = ToScree(def.localAnchorA);
    out.localAnchorB = ToScree(def.localAnchorB);
}

scree::RevoluteJointDef Convert(const b2RevoluteJointDef& def) {
    scree::RevoluteJointDef out;
    CopyAnchors(out, def);
    out.referenceAngle = def.referenceAngle;
    out.enableLimit = def.enableLimit;
    out.lowerAngle = def.lowerAngle;
    out.upperAngle = def.upperAngle;
    out.enableMotor = def.enableMotor;
    out.motorSpeed = def.motorSpeed;
    out.maxMotorTorque = def.maxMotorTorque;
    return out;
}

scree::PrismaticJointDef Convert(const b2PrismaticJointDef& def) {
    scree::PrismaticJointDef out;
    CopyAnchors(out, def);
    out.localAxisA = ToScree(def.localAxisA);
    out.referenceAngle = def.referenceAngle;
    out.enableLimit = def.enableLimit;
    out.lowerTranslation = def.lowerTranslation;
    out.upperTranslation = def.upperTranslation;
    out.enableMotor = def.enableMotor;
    out.maxMotorForce = def.maxMotorForce;
    out.motorSpeed = def.motorSpeed;
    return out;
}

scree::DistanceJointDef Convert(const b2DistanceJointDef& def) {
    scree::DistanceJointDef out;
    CopyAnchors(out, def);
    out.length = def.length;
    out.minLength = def.minLength;
    out.maxLength = def.maxLength;
    out.stiffness = def.stiffness;
    out.damping = def.damping;
    return out;
}

scree::PulleyJointDef Convert(const b2PulleyJointDef& def) {
    scree::PulleyJointDef out;
    CopyAnchors(out, def);
    out.groundAnchorA = ToScree(def.groundAnchorA);
    out.groundAnchorB = ToScree(def.groundAnchorB);
    out.lengthA = def.lengthA;
    out.lengthB = def.lengthB;
    out.ratio = def.ratio;
    return out;
}

scree::MouseJointDef Convert(const b2MouseJointDef& def) {
    scree::MouseJointDef out;
    out.target = ToScree(def.target);
    out.maxForce = def.maxForce;
    out.stiffness = def.stiffness;
    out.damping = def.damping;
    return out;
}

scree::GearJointDef Convert(const b2GearJointDef& def) {
    scree::GearJointDef out;
    out.joint1 = b2Bridge::Handle(def.joint1);
    out.joint2 = b2Bridge::Handle(def.joint2);
    out.ratio = def.ratio;
    return out;
}

scree::WheelJointDef Convert(const b2WheelJointDef& def) {
    scree::WheelJointDef out;
    CopyAnchors(out, def);
    out.localAxisA = ToScree(def.localAxisA);
    out.enableLimit = def.enableLimit;
    out.lowerTranslation = def.lowerTranslation;
    out.upperTranslation = def.upperTranslation;
    out.enableMotor = def.enableMotor;
    out.maxMotorTorque = def.maxMotorTorque;
    out.motorSpeed = def.motorSpeed;
    out.stiffness = def.stiffness;
    out.damping = def.damping;
    return out;
}

scree::WeldJointDef Convert(const b2WeldJointDef& def) {
    scree::WeldJointDef out;
    CopyAnchors(out, def);
    out.referenceAngle = def.referenceAngle;
    out.stiffness = def.stiffness;
    out.damping = def.damping;
    return out;
}

scree::FrictionJointDef Convert(const b2FrictionJointDef& def) {
    scree::FrictionJointDef out;
    CopyAnchors(out, def);
    out.maxForce = def.maxForce;
    out.maxTorque = def.maxTorque;
    return out;
}

scree::MotorJointDef Convert(const b2MotorJointDef& def) {
    scree::MotorJointDef out;
    out.linearOffset = ToScree(def.linearOffset);
    out.angularOffset = def.angularOffset;
    out.maxForce = def.maxForce;
    out.maxTorque = def.maxTorque;
    out.correctionFactor = def.correctionFactor;
    return out;
}

/// Creates on the engine's side; null if refused.
template <typename Def>
scree::Joint* CreateAs(scree::World& engine, const b2JointDef& def) {
    auto converted = Convert(static_cast<const Def&>(def));
    return Create(engine, converted, def);
}

scree::Joint* CreateInEngine(scree::World& engine, const b2JointDef& def) {
    switch (def.type) {
        case e_revoluteJoint:
            return CreateAs<b2RevoluteJointDef>(engine, def);
        case e_prismaticJoint:
            return CreateAs<b2PrismaticJointDef>(engine, def);
        case e_distanceJoint:
            return CreateAs<b2DistanceJointDef>(engine, def);
        case e_pulleyJoint:
            return CreateAs<b2PulleyJointDef>(engine, def);
        case e_mouseJoint:
            return CreateAs<b2MouseJointDef>(engine, def);
        case e_gearJoint:
            return CreateAs<b2GearJointDef>(engine, def);
        case e_wheelJoint:
            return CreateAs<b2WheelJointDef>(engine, def);
        case e_weldJoint:
            return CreateAs<b2WeldJointDef>(engine, def);
        case e_frictionJoint:
            return CreateAs<b2FrictionJointDef>(engine, def);
        case e_motorJoint:
            return CreateAs<b2MotorJointDef>(engine, def);
        default:
            Complain("b2World::CreateJoint", "use the definition of one of the joints");
            return nullptr;
    }
}

}  // namespace

b2Joint* b2Bridge::MakeJoint(b2WorldData& data, const b2JointDef& def) {
    scree::Joint* handle = CreateInEngine(data.engine, def);
    if (handle == nullptr) return nullptr;
    b2Joint* joint = nullptr;
    switch (def.type) {
        case e_revoluteJoint:
            joint = new b2RevoluteJoint;
            break;
        case e_prismaticJoint:
            joint = new b2PrismaticJoint;
            break;
        case e_distanceJoint:
            joint = new b2DistanceJoint;
            break;
        case e_pulleyJoint:
            joint = new b2PulleyJoint;
            break;
        case e_mouseJoint:
            joint = new b2MouseJoint;
            break;
        case e_wheelJoint:
            joint = new b2WheelJoint;
            break;
        case e_weldJoint:
            joint = new b2WeldJoint;
            break;
        case e_frictionJoint:
            joint = new b2FrictionJoint;
            break;
        case e_motorJoint:
            joint = new b2MotorJoint;
            break;
        default: {
            auto* gear = new b2GearJoint;
            gear->m_joint1 = static_cast<const b2GearJointDef&>(def).joint1;
            gear->m_joint2 = static_cast<const b2GearJointDef&>(def).joint2;
            joint = gear;
        }
    }
    joint->m_handle = handle;
    joint->m_type = def.type;
    joint->m_userData = def.userData;
    joint->m_bodyA = BodyOf(handle->GetBodyA());
    joint->m_bodyB = BodyOf(handle->GetBodyB());
    joint->m_localAnchorA.SetZero();
    joint->m_localAnchorB.SetZero();
    joint->m_localAxisA.SetZero();
    handle->SetUserData({reinterpret_cast<uintptr_t>(joint)});
    CopyLocals(*joint, def);
    Link(data, joint);
    return joint;
}

namespace {

template <typename Def>
void ReadAnchors(const b2JointDef& def, b2Vec2& anchorA, b2Vec2& anchorB) {
    anchorA = static_cast<const Def&>(def).localAnchorA;
    anchorB = static_cast<const Def&>(def).localAnchorB;
}

}  // namespace

void b2Bridge::CopyLocals(b2Joint& joint, const b2JointDef& def) {
    b2Vec2& a = joint.m_localAnchorA;
    b2Vec2& b = joint.m_localAnchorB;
    switch (def.type) {
        case e_revoluteJoint:
            ReadAnchors<b2RevoluteJointDef>(def, a, b);
            break;
        case e_distanceJoint:
            ReadAnchors<b2DistanceJointDef>(def, a, b);
            break;
        case e_weldJoint:
            ReadAnchors<b2WeldJointDef>(def, a, b);
            break;
        case e_frictionJoint:
            ReadAnchors<b2FrictionJointDef>(def, a, b);
            break;
        case e_prismaticJoint:
            ReadAnchors<b2PrismaticJointDef>(def, a, b);
            joint.m_localAxisA = ToBox2d(static_cast<scree::PrismaticJoint*>(joint.m_handle)->GetLocalAxisA());
            break;
        case e_wheelJoint:
            ReadAnchors<b2WheelJointDef>(def, a, b);
            joint.m_localAxisA = ToBox2d(static_cast<scree::WheelJoint*>(joint.m_handle)->GetLocalAxisA());
            break;
        default:
            break;
    }
}
