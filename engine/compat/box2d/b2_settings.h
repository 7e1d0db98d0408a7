// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a program may replace by its own b2_user_settings.h (with B2_USER_SETTINGS): scale, polygon size, user data,
// memory and log. The library must then be built with the same file (engine/compat/README.md).

#pragma once

#include "b2_api.h"
#include "b2_types.h"

#ifdef B2_USER_SETTINGS

#include "b2_user_settings.h"

static_assert(
    b2_lengthUnitsPerMeter >= 1e-6f && b2_lengthUnitsPerMeter <= 1e6f,
    "scree::box2d takes 1e-6 to 1e6 length units a metre: set b2_lengthUnitsPerMeter so in b2_user_settings.h");
static_assert(
    b2_maxPolygonVertices >= 4 && b2_maxPolygonVertices <= 64,
    "scree::box2d has polygons of up to 64 vertices: set b2_maxPolygonVertices to 4…64 in b2_user_settings.h");

#else

#include <stdarg.h>
#include <stdint.h>

/// Length units of the program in one metre. Constants that are lengths are multiplied by it.
#define b2_lengthUnitsPerMeter 1.0f

/// Most vertices of a polygon.
#define b2_maxPolygonVertices 8

/// Application data of a body.
struct B2_API b2BodyUserData {
    b2BodyUserData() { pointer = 0; }

    uintptr_t pointer;
};

/// Application data of a fixture.
struct B2_API b2FixtureUserData {
    b2FixtureUserData() { pointer = 0; }

    uintptr_t pointer;
};

/// Application data of a joint.
struct B2_API b2JointUserData {
    b2JointUserData() { pointer = 0; }

    uintptr_t pointer;
};

B2_API void* b2Alloc_Default(int32 size);
B2_API void b2Free_Default(void* mem);

/// Memory of the compatibility objects.
inline void* b2Alloc(int32 size) { return b2Alloc_Default(size); }
inline void b2Free(void* mem) { b2Free_Default(mem); }

B2_API void b2Log_Default(const char* string, va_list args);

/// Writes like printf.
inline void b2Log(const char* string, ...) {
    va_list args;
    va_start(args, string);
    b2Log_Default(string, args);
    va_end(args);
}

#endif  // B2_USER_SETTINGS

#include "b2_common.h"
