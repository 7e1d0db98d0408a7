// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a Box2D program may replace (B2_USER_SETTINGS): here larger polygon arrays, typed user data, its own memory and
// log.

#pragma once

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#if defined(REFUSED_LENGTH_UNITS)
#define b2_lengthUnitsPerMeter 1e7f
#define b2_maxPolygonVertices 8
#elif defined(REFUSED_POLYGON_VERTICES)
#define b2_lengthUnitsPerMeter 1.0f
#define b2_maxPolygonVertices 100
#else
#define b2_lengthUnitsPerMeter 1.0f
#define b2_maxPolygonVertices 12
#endif

struct b2BodyUserData {
    const char* name = "";
    int team = 0;
};
struct b2FixtureUserData {
    int material = 0;
};
struct b2JointUserData {
    int strength = 0;
};

inline void* b2Alloc(int size) { return malloc(static_cast<size_t>(size)); }
inline void b2Free(void* mem) { free(mem); }
inline void b2Log(const char* string, ...) {
    va_list args;
    va_start(args, string);
    vprintf(string, args);
    va_end(args);
}
