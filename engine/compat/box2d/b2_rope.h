// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Box2D 2.4 has a rope of particles here (b2Rope). It is no part of the rigid-body world and is not provided; chains
// of bodies with b2RevoluteJoint and b2DistanceJoint are.

#pragma once

#include "b2_api.h"
#include "b2_math.h"
