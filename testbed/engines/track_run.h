// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A recorded motion as a run: each step goes to the next one that was recorded. Nothing is simulated. The tree is that
// of the recorded engine, where the track has its nodes; other trees follow the motion (poses.h). Times are those of
// the engine that was recorded.

#pragma once

#include <memory>

#include "testbed/engines/engine_run.h"
#include "testbed/input/track_file.h"

namespace testbed {

/// The step at which a motion begins: 0, or the first that a flight recorder kept.
[[nodiscard]] int FirstStepOf(const TrackFile& track);

/// The motion from step `from` on, which must be 0 or recorded. Bodies and fixtures have the indices of
/// TrackFile::GetParts, and a capture has those that are there. Runs may share a track; they should go through it
/// together. Step throws std::out_of_range behind the last step.
[[nodiscard]] std::unique_ptr<EngineRun> MakeTrackRun(std::shared_ptr<TrackFile> track, int from);

}  // namespace testbed
