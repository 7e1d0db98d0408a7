// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The calls of a world in a file (scree/recording.h), for programs that were started with SCREE_RECORD=FILE: no line of
// them changes. The file is whole after every step, so that a crash loses one step at most.

#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>

#include "scree/recording.h"

namespace scree::box2d {

class CallFile {
public:
    /// Records from now on if SCREE_RECORD names a file; else null. Further worlds of the program write FILE-2, FILE-3
    /// … (before the ending). A file that cannot be written costs a line on stderr and nothing else.
    static std::unique_ptr<CallFile> OpenIfAsked(World& world);
    /// Writes the rest. The world must still be there.
    ~CallFile();
    CallFile(const CallFile&) = delete;
    CallFile& operator=(const CallFile&) = delete;

    /// Writes what was recorded since the last time.
    void Write();

private:
    CallFile(World& world, std::FILE* file);

    World& m_world;
    std::FILE* m_file;
    Recorder m_recorder;
    std::size_t m_written = 0;
};

}  // namespace scree::box2d
