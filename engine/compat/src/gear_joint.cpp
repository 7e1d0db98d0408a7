// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// b2GearJoint.

#include "../box2d/b2_gear_joint.h"

#include "joint_handle.h"

using namespace scree::box2d;
using Engine = scree::GearJoint;

void b2GearJoint::SetRatio(float ratio) { As<Engine>(m_handle).SetRatio(ratio); }
float b2GearJoint::GetRatio() const { return As<Engine>(m_handle).GetRatio(); }
