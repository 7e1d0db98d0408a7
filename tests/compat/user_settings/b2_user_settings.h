// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a Box2D program may replace (B2_USER_SETTINGS): here larger polygon arrays, typed user data, its own memory and
// log; on the command line also the length unit.

#pragma once

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef LENGTH_UNITS
#define LENGTH_UNITS 1.0f
#endif
#ifndef POLYGON_VERTICES
#define POLYGON_VERTICES 12
#endif
#define b2_lengthUnitsPerMeter LENGTH_UNITS
#define b2_maxPolygonVertices POLYGON_VERTICES

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
