// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Adds to Box2D's exported counters of distance and time-of-impact work. They are process-wide there, so they are
// here; like there, they are not synchronised between threads.

#pragma once

#include "scree/time_of_impact.h"

namespace scree::box2d {

void CountDistance(int calls, int iterations, int maxIterations);
/// `time`: ms spent on it. Within a step that is the whole stage, whose single calls no clock looks at.
void CountToi(const TOIStats& stats, float time);

}  // namespace scree::box2d
