// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Constants and macros of Box2D 2.4 with its values. They are macros there, so programs may test them with #ifdef, and
// macros they remain.

#pragma once

#include <assert.h>
#include <float.h>
#include <stddef.h>

#include "b2_settings.h"

#if !defined(NDEBUG)
#define b2DEBUG
#endif

#define B2_NOT_USED(x) ((void)(x))
/// For the program's own checks; the library itself never aborts.
#define b2Assert(A) assert(A)

#define b2_maxFloat FLT_MAX
#define b2_epsilon FLT_EPSILON
#define b2_pi 3.14159265359f

/// Most points of a manifold.
#define b2_maxManifoldPoints 2
/// Margin of boxes in b2DynamicTree, and how far ahead along its displacement a moved box is stretched.
#define b2_aabbExtension (0.1f * b2_lengthUnitsPerMeter)
#define b2_aabbMultiplier 4.0f
/// Overlap that is left alone, and the same for joint angles.
#define b2_linearSlop (0.005f * b2_lengthUnitsPerMeter)
#define b2_angularSlop (2.0f / 180.0f * b2_pi)
/// Skin of polygons and edges.
#define b2_polygonRadius (2.0f * b2_linearSlop)
/// Most sub-steps per contact in continuous collision, and contacts of a sub-step.
#define b2_maxSubSteps 8
#define b2_maxTOIContacts 32
/// Most that one position iteration corrects.
#define b2_maxLinearCorrection (0.2f * b2_lengthUnitsPerMeter)
#define b2_maxAngularCorrection (8.0f / 180.0f * b2_pi)
/// Most that a body moves and turns in one step.
#define b2_maxTranslation (2.0f * b2_lengthUnitsPerMeter)
#define b2_maxTranslationSquared (b2_maxTranslation * b2_maxTranslation)
#define b2_maxRotation (0.5f * b2_pi)
#define b2_maxRotationSquared (b2_maxRotation * b2_maxRotation)
/// Share of an overlap that one position iteration removes, in a step and in a sub-step.
#define b2_baumgarte 0.2f
#define b2_toiBaumgarte 0.75f
/// How long and how slow a body must rest before it sleeps.
#define b2_timeToSleep 0.5f
#define b2_linearSleepTolerance (0.01f * b2_lengthUnitsPerMeter)
#define b2_angularSleepTolerance (2.0f / 180.0f * b2_pi)

/// The text dump of Box2D: the file is opened, written and closed; worlds write nothing into it.
void b2OpenDump(const char* fileName);
void b2Dump(const char* string, ...);
void b2CloseDump();

/// The version whose interface this is.
struct b2Version {
    int32 major;
    int32 minor;
    int32 revision;
};

extern B2_API b2Version b2_version;
