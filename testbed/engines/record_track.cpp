// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A run recorded into a track.

#include "testbed/engines/record_track.h"

#include <fmt/format.h>

#include <stdexcept>

#include "testbed/base/errors.h"
#include "testbed/base/new_file.h"

namespace testbed {

void RecordTrack(const std::filesystem::path& path, const TrackContents& contents, InteractiveRun& run,
                 const std::function<void()>& play) {
    NewFile file(path);
    file.Write("");  // tells at once, and by the name that was given, if it cannot be written
    run.Record(file.GetPlace().string(), contents);
    play();
    try {
        run.EndRecord();
    } catch (const std::runtime_error& error) {
        throw FileError(fmt::format("cannot write {}: {}", path.string(), error.what()));
    }
    file.Finish();
}

}  // namespace testbed
