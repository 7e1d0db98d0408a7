// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A whole world as a block of bytes, and back. A restored world continues bit for bit as the saved one would have. The
// image contains bodies, fixtures with shapes, contacts with impulses, joints, lists, free slots, settings, pending
// edits, and a sub-stepped step that is not over yet.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scree/api.h"
#include "scree/world.h"

namespace scree {

/// Increases with every change of the format; LoadWorld reads only its own version.
inline constexpr uint32_t snapshotVersion = 11;

/// Why an image was refused.
enum class SnapshotError : uint8_t {
    ok,
    notASnapshot,    ///< the bytes do not begin like an image
    wrongVersion,    ///< the image is of another version of the format
    wrongSize,       ///< the image was cut off, or something was appended
    wrongChecksum,   ///< bytes were changed
    badContent,      ///< the bytes are complete, but describe no possible world
    refused,         ///< the world is locked or recorded, or lacks features that the image needs
    wrongByteOrder,  ///< the image was written on a machine with the other byte order
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

/// Returns the image of a world. Equal worlds give equal bytes. An image does not contain listeners, the filter, the
/// error handler, the debug draw or the last report. User data is saved as a number. While the world is locked the
/// result is empty. O(size of the world).
[[nodiscard]] SCREE_API std::vector<std::byte> SaveWorld(const World& world);

/// Creates a world from an image; its objects have the indices and ids of the saved ones. Returns null for a bad image,
/// however damaged, and `error` (if given) gets the reason. O(size of the world).
[[nodiscard]] SCREE_API std::unique_ptr<World> LoadWorld(std::span<const std::byte> image,
                                                         SnapshotError* error = nullptr);

/// Gives a world the state of an image, which may be of this world or of another. It keeps its listeners, filter,
/// workers, features and handles. An object of the image gets the handle that had its index before. So pointers to
/// objects of the image are valid, even if these were destroyed since, and all others are dead. Ids of contacts and
/// pointers from GetShape become invalid. A bad image changes nothing.
/// O(size of the world).
SCREE_API SnapshotError RestoreWorld(World& world, std::span<const std::byte> image);

}  // namespace scree
