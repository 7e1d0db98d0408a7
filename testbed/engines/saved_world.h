// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Files that our engine writes: images of worlds (scree/snapshot.h) and recordings of calls (scree/recording.h). What
// they hold becomes a scene, which any engine runs, beside the exact world, which ours goes on with; and a recording
// becomes a track.

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/track_contents.h"

namespace testbed {

using WorldImage = std::vector<std::byte>;

/// A world of our engine at one moment.
struct SavedWorld {
    std::shared_ptr<const WorldImage> image;
    scenes::Scene scene;   ///< the same moment, as far as a scene can say it; bodies and fixtures in the same order
    std::string settings;  ///< with which our engine goes on in it, as PrintSettings writes them
    std::vector<std::string> losses{};  ///< what `scene` cannot say, a line per kind
};

/// Versions of both formats that this program writes, and the only ones that it reads.
[[nodiscard]] int GetImageVersion();
[[nodiscard]] int GetRecordingVersion();

/// The world in an image. Throws FileError, naming `source`, with the reason and the cure for what is none.
[[nodiscard]] SavedWorld ReadWorldImage(std::string_view bytes, std::string_view source);

/// What a replay of a recording came to.
struct Replayed {
    int calls = 0;
    int steps = 0;
    scenes::Scene start;  ///< the world as recording began; mostly empty, since a program records from the beginning
    /// Why it ended before the end of the file ("replays differently from step 7 on"), or nothing.
    std::string damage;
    std::optional<SavedWorld> world;  ///< after the step that was asked for
    std::string track;                ///< the motion as the bytes of a track, if it was asked for
};

struct ReplayRequest {
    std::optional<int> worldAt{};  ///< a step; 0: as recording began
    bool wantsTrack = false;       ///< with contacts
    TrackContents contents{};      ///< of that track, beyond
};

/// Makes all calls of a recording. Throws FileError, naming `source`, with the cure for what is none, and UsageError
/// for a step that it does not have.
[[nodiscard]] Replayed ReplayRecording(std::string_view bytes, std::string_view source, const ReplayRequest& request);

}  // namespace testbed
