// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A run recorded into a track that appears whole or not at all.

#pragma once

#include <filesystem>
#include <functional>

#include "testbed/engines/engine_run.h"

namespace testbed {

/// Records the steps that `play` makes, with contacts and what is asked for. Throws FileError with the reason if the
/// file cannot be written, before the first step where that is known, and what `play` and InteractiveRun::Record throw.
void RecordTrack(const std::filesystem::path& path, const TrackContents& contents, InteractiveRun& run,
                 const std::function<void()>& play);

}  // namespace testbed
