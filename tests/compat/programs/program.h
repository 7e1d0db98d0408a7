// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A Box2D program of the comparison: it runs and says what happened. The same source is compiled against Box2D and
// against scree's compatibility library; programs.cpp lists all of them.

#pragma once

#include <box2d/box2d.h>

#include <string>

/// A line that must be the same on both sides, printf style.
void Say(const char* format, ...) __attribute__((format(printf, 1, 2)));
/// A number that may differ by `tolerance`.
void Number(const std::string& name, double value, double tolerance = 1e-3);
void Number(const std::string& name, const b2Vec2& value, double tolerance = 1e-3);
/// Position and angle: 1 mm, 1 mrad.
void Pose(const std::string& name, const b2Body* body, double tolerance = 1e-3);

/// A static body with a long two-sided edge at height y.
b2Body* MakeGround(b2World& world, float y = 0.0f);
/// A dynamic box by half widths.
b2Body* MakeBox(b2World& world, float x, float y, float hx, float hy, float density = 1.0f);
b2Body* MakeDisk(b2World& world, float x, float y, float radius, float density = 1.0f);
/// Steps at 60 Hz with 8 and 3 iterations.
void Run(b2World& world, int steps);

struct Program {
    const char* name;
    void (*run)();
};
