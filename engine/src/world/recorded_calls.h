// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The recorded calls whose arguments are plain values: for what reads recordings (replay.cpp), and for the fuzzer of
// calls, which makes any of them.

#pragma once

#include "scree/scree.h"

// clang-format off
#define SCREE_RECORDED_CALLS(CALL) \
    CALL(World::SetAutoClearForces) \
    CALL(World::ClearForces) \
    CALL(World::SetGravity) \
    CALL(World::SetAllowSleeping) \
    CALL(World::SetWarmStarting) \
    CALL(World::SetContinuousPhysics) \
    CALL(World::SetSubStepping) \
    CALL(World::SetExactDrift) \
    CALL(World::ShiftOrigin) \
    CALL(Body::ResetMassData) \
    CALL(Body::SetTransform) \
    CALL(Body::SetTargetTransform) \
    CALL(Body::SetLinearVelocity) \
    CALL(Body::SetAngularVelocity) \
    CALL(Body::ApplyForce) \
    CALL(Body::ApplyForceToCenter) \
    CALL(Body::ApplyTorque) \
    CALL(Body::ApplyLinearImpulse) \
    CALL(Body::ApplyLinearImpulseToCenter) \
    CALL(Body::ApplyAngularImpulse) \
    CALL(Body::SetLinearDamping) \
    CALL(Body::SetAngularDamping) \
    CALL(Body::SetGravityScale) \
    CALL(Body::SetType) \
    CALL(Body::SetBullet) \
    CALL(Body::SetSleepingAllowed) \
    CALL(Body::SetAwake) \
    CALL(Body::SetEnabled) \
    CALL(Body::SetFixedRotation) \
    CALL(Body::SetMotionLocks) \
    CALL(Fixture::SetSensor) \
    CALL(Fixture::SetFilterData) \
    CALL(Fixture::Refilter) \
    CALL(Fixture::SetDensity) \
    CALL(Fixture::SetFriction) \
    CALL(Fixture::SetRestitution) \
    CALL(Fixture::SetRestitutionThreshold) \
    CALL(Fixture::SetTangentSpeed) \
    CALL(Fixture::SetRollingResistance) \
    CALL(Fixture::SetMixRules) \
    CALL(Fixture::SetMaterialId) \
    CALL(Fixture::SetReports) \
    CALL(Contact::SetManifold) \
    CALL(Contact::SetEnabled) \
    CALL(Contact::SetFriction) \
    CALL(Contact::ResetFriction) \
    CALL(Contact::SetRestitution) \
    CALL(Contact::ResetRestitution) \
    CALL(Contact::SetRestitutionThreshold) \
    CALL(Contact::ResetRestitutionThreshold) \
    CALL(Contact::SetTangentSpeed) \
    CALL(Joint::ShiftOrigin) \
    CALL(Joint::SetThresholds) \
    CALL(RevoluteJoint::EnableSpring) \
    CALL(RevoluteJoint::SetSpring) \
    CALL(RevoluteJoint::SetTargetAngle) \
    CALL(RevoluteJoint::SetMaxSpringTorque) \
    CALL(PrismaticJoint::EnableSpring) \
    CALL(PrismaticJoint::SetSpring) \
    CALL(PrismaticJoint::SetTargetTranslation) \
    CALL(PrismaticJoint::SetMaxSpringForce) \
    CALL(WheelJoint::SetMaxSpringForce) \
    CALL(DistanceJoint::SetMaxSpringForce) \
    CALL(RevoluteJoint::EnableLimit) \
    CALL(RevoluteJoint::SetLimits) \
    CALL(RevoluteJoint::EnableMotor) \
    CALL(RevoluteJoint::SetMotorSpeed) \
    CALL(RevoluteJoint::SetMaxMotorTorque) \
    CALL(PrismaticJoint::EnableLimit) \
    CALL(PrismaticJoint::SetLimits) \
    CALL(PrismaticJoint::EnableMotor) \
    CALL(PrismaticJoint::SetMotorSpeed) \
    CALL(PrismaticJoint::SetMaxMotorForce) \
    CALL(WheelJoint::EnableLimit) \
    CALL(WheelJoint::SetLimits) \
    CALL(WheelJoint::EnableMotor) \
    CALL(WheelJoint::SetMotorSpeed) \
    CALL(WheelJoint::SetMaxMotorTorque) \
    CALL(WheelJoint::SetStiffness) \
    CALL(WheelJoint::SetDamping) \
    CALL(DistanceJoint::SetLength) \
    CALL(DistanceJoint::SetMinLength) \
    CALL(DistanceJoint::SetMaxLength) \
    CALL(DistanceJoint::SetStiffness) \
    CALL(DistanceJoint::SetDamping) \
    CALL(WeldJoint::SetStiffness) \
    CALL(WeldJoint::SetDamping) \
    CALL(FrictionJoint::SetMaxForce) \
    CALL(FrictionJoint::SetMaxTorque) \
    CALL(GearJoint::SetRatio) \
    CALL(MotorJoint::SetLinearOffset) \
    CALL(MotorJoint::SetAngularOffset) \
    CALL(MotorJoint::SetMaxForce) \
    CALL(MotorJoint::SetMaxTorque) \
    CALL(MotorJoint::SetCorrectionFactor) \
    CALL(MouseJoint::SetTarget) \
    CALL(MouseJoint::SetMaxForce) \
    CALL(MouseJoint::SetStiffness) \
    CALL(MouseJoint::SetDamping)
// clang-format on
