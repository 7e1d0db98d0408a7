// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a program in pixels replaces: the length unit, LENGTH_UNITS of them in a metre. The rest is as Box2D has it.

#pragma once

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define b2_lengthUnitsPerMeter LENGTH_UNITS
#define b2_maxPolygonVertices 8

struct b2BodyUserData {
    uintptr_t pointer = 0;
};
struct b2FixtureUserData {
    uintptr_t pointer = 0;
};
struct b2JointUserData {
    uintptr_t pointer = 0;
};

inline void* b2Alloc(int size) { return malloc(static_cast<size_t>(size)); }
inline void b2Free(void* mem) { free(mem); }
inline void b2Log(const char* string, ...) {
    va_list args;
    va_start(args, string);
    vprintf(string, args);
    va_end(args);
}
