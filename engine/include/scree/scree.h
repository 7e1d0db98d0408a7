// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Everything a program needs to simulate.

#pragma once

#include "scree/body.h"
#include "scree/broad_phase_kind.h"
#include "scree/collision.h"
#include "scree/contact.h"
#include "scree/errors.h"
#include "scree/fixture.h"
#include "scree/joint.h"
#include "scree/math.h"
#include "scree/profile.h"
#include "scree/revolute_joint.h"
#include "scree/settings.h"
#include "scree/shape.h"
#include "scree/world.h"
#include "scree/world_callbacks.h"
