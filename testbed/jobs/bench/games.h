// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree bench --games`: the second suite. Its cases are what games do: most of a level rests, a few things are made,
// moved and destroyed in each frame, characters walk, rays are cast.

#pragma once

#include "testbed/jobs/bench/plan.h"
#include "testbed/options/request.h"

namespace testbed {

/// Runs the cases whose names are among `arguments.scenes`, or all. Throws UsageError.
int RunGames(const BenchArguments& arguments, const Request& request);

}  // namespace testbed
