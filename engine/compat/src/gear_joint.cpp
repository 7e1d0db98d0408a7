// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2GearJoint.

#include "../box2d/b2_gear_joint.h"

#include "joint_handle.h"

using namespace scree::box2d;

void b2GearJoint::SetRatio(float ratio) { As<scree::GearJoint>(m_handle).SetRatio(ratio); }
float b2GearJoint::GetRatio() const { return As<scree::GearJoint>(m_handle).GetRatio(); }
