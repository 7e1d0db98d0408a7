// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Most of a game's level sleeps. A step in which nothing is awake passes its stages over, so that its cost is that of
// asking, whatever there is.

#pragma once

#include "world/step.h"

namespace scree {

/// Nothing is awake or about to begin or end, and what the last step left behind is empty: no stage has anything to do.
/// Asked when pairs of edits have been found.
bool IsStill(const WorldState& state, const StepRequest& request);
/// What the stages of such a step come to.
void StandStill(WorldState& state, const StepRequest& request, StepResults& results);

}  // namespace scree
