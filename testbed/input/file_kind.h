// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The kinds of files that can be given in place of a scene, and which of them a path is. The ending decides.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace testbed {

enum class FileKind : std::uint8_t { scene, track, image, recording, rube };

struct FileKindInfo {
    FileKind kind = FileKind::scene;
    std::string_view name;       ///< what --format takes
    std::string_view ending;     ///< of its files' names
    std::string_view beginning;  ///< of their bytes; JSON, which has no more of it than "{", is told by its keys
    std::string_view what;
};

/// All of them, each with an ending of its own; a longer ending stands before one that it ends in.
[[nodiscard]] std::span<const FileKindInfo> FileKinds();

[[nodiscard]] const FileKindInfo& GetInfo(FileKind kind);

/// The kind whose ending a path has.
[[nodiscard]] std::optional<FileKind> KindOfEnding(std::string_view path);

/// The kind that bytes begin like; of JSON, that whose keys the outermost object has.
[[nodiscard]] std::optional<FileKind> KindOfBytes(std::string_view bytes);

/// The kind of that name. Throws UsageError with the nearest one.
[[nodiscard]] FileKind ParseFileKind(std::string_view name);

/// Whether a word means a file and no scene of the catalogue: it has a folder or a known ending.
[[nodiscard]] bool LooksLikeFile(std::string_view word);

/// "*.scene.json (a world at one moment), …"
[[nodiscard]] std::string DescribeFileKinds();

}  // namespace testbed
