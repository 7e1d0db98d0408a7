// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A whole world as a block of bytes, and back. A restored world goes on bit for bit as the saved one would have:
// bodies, fixtures with shapes, contacts with impulses, joints, lists, free slots, settings, pending edits and a
// sub-stepped step that is not over yet are all in the image.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scree/api.h"
#include "scree/world.h"

namespace scree {

/// Grows with every change of the layout; LoadWorld reads its own version only.
inline constexpr uint32_t snapshotVersion = 10;

/// Why an image was refused.
enum class SnapshotError : uint8_t {
    ok,
    notASnapshot,    ///< it does not begin like an image
    wrongVersion,    ///< of another version of this library
    wrongSize,       ///< cut off, or something was appended
    wrongChecksum,   ///< bytes were changed
    badContent,      ///< the bytes are whole but describe no possible world
    refused,         ///< the world is locked or recorded, or may not use what the image uses
    wrongByteOrder,  ///< written on a machine that keeps the bytes of a number in the other order
};

constexpr const char* GetName(SnapshotError error) {
    switch (error) {
        case SnapshotError::ok:
            return "ok";
        case SnapshotError::notASnapshot:
            return "not a snapshot";
        case SnapshotError::wrongVersion:
            return "wrong version";
        case SnapshotError::wrongSize:
            return "wrong size";
        case SnapshotError::wrongChecksum:
            return "wrong checksum";
        case SnapshotError::badContent:
            return "bad content";
        case SnapshotError::refused:
            return "refused";
        case SnapshotError::wrongByteOrder:
            return "wrong byte order";
    }
    return "unknown";
}

/// The image of a world. Equal worlds give equal bytes. Not in it: listeners, the filter, the error handler, the
/// drawer, the last report. User data is saved as the number it holds. Refused (empty) while the world is locked.
/// O(size of the world).
[[nodiscard]] SCREE_API std::vector<std::byte> SaveWorld(const World& world);

/// A new world from an image; its objects have the indices and ids of the saved ones. Null for a bad image, and `error`
/// (if given) says why: no image, however damaged, does more than that. O(size of the world).
[[nodiscard]] SCREE_API std::unique_ptr<World> LoadWorld(std::span<const std::byte> image,
                                                         SnapshotError* error = nullptr);

/// Puts a world back to the state of an image, which may be of this world or of any other. It keeps its listeners,
/// filter, workers and features, and its handles: the body, fixture or joint with an index of the image has the handle
/// that had this index before, so pointers to what is in the image are valid, also where it had been destroyed since.
/// What is not in the image is dead. Not kept: ids of contacts, and pointers that GetShape gave. A bad image changes
/// nothing. O(size of the world).
SCREE_API SnapshotError RestoreWorld(World& world, std::span<const std::byte> image);

}  // namespace scree
