// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Moments of one world, in memory, for programs that go back a few steps in every frame: rollback over a network,
// looking ahead, undo. A moment holds only what has changed since an image of the whole world (scree/snapshot.h), which
// many moments share. Going back gives the same bits as the image of that moment would have.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "scree/api.h"
#include "scree/snapshot.h"
#include "scree/world.h"

namespace scree {

/// Keeps the newest moments of a world. Save and Restore cost O(size of the world) with a small factor: about what it
/// takes to read the poses, velocities, contacts and joints once.
///
/// The first Save after a program has created, changed or destroyed an object takes an image of the whole world.
/// Restore across such a call costs as much. Calls that only move things do not count: transforms, velocities, forces,
/// impulses, sleep, and the settings of joints. A shape that was asked for by the non-const GetShape may change at any
/// time: from then on, and with the broad phase `fatTree`, each Save takes an image.
///
/// Not to be used by several threads at once, nor while the world steps. The world must outlive it.
class SCREE_API Rollback {
public:
    /// Keeps at most so many moments (at least 1) and forgets the oldest ones.
    explicit Rollback(World& world, int mostMoments = 16);
    ~Rollback();
    Rollback(const Rollback&) = delete;
    Rollback& operator=(const Rollback&) = delete;

    /// Keeps the world as it is. Returns the number of the moment: 0, 1, 2, …; −1 while the world is locked.
    int64_t Save();
    /// Gives the world the state of a moment; no moment is forgotten. The same holds as for RestoreWorld: the world
    /// keeps its listeners, filter, workers, features and handles, and ids of contacts may become invalid. Refused
    /// while the world is locked or recorded, while it lacks a feature that it had at the moment, and for a moment that
    /// is not kept; then nothing changes.
    SnapshotError Restore(int64_t moment);
    /// Whether the moment can be restored.
    [[nodiscard]] bool Has(int64_t moment) const;
    /// Bytes that this moment alone holds; 0 without it.
    [[nodiscard]] size_t GetBytes(int64_t moment) const;
    /// Bytes of everything, images included.
    [[nodiscard]] size_t GetMemoryBytes() const;

private:
    struct Base;
    struct Moment;
    struct Kept;
    std::unique_ptr<Kept> m_kept;
};

}  // namespace scree
