// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of file_kind.h.

#include "testbed/input/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"

namespace testbed {

namespace {

constexpr std::array kinds{
    FileKindInfo{FileKind::scene, "scene", ".scene.json", "{", "a world at one moment"},
    FileKindInfo{FileKind::track, "track", ".track", "\x89TRACK\r\n", "a world and its motion"},
    FileKindInfo{FileKind::image, "image", ".world", "screewld", "a saved world of our engine"},
    FileKindInfo{FileKind::recording, "recording", ".recording", "screrec", "a program's calls of our engine"},
};

}  // namespace

std::span<const FileKindInfo> FileKinds() { return kinds; }

const FileKindInfo& GetInfo(FileKind kind) { return *std::ranges::find(kinds, kind, &FileKindInfo::kind); }

std::optional<FileKind> KindOfEnding(std::string_view path) {
    for (const FileKindInfo& info : kinds) {
        if (path.size() > info.ending.size() && path.ends_with(info.ending)) return info.kind;
    }
    return std::nullopt;
}

std::optional<FileKind> KindOfBytes(std::string_view bytes) {
    for (const FileKindInfo& info : kinds) {
        if (bytes.starts_with(info.beginning)) return info.kind;
    }
    return std::nullopt;
}

FileKind ParseFileKind(std::string_view name) {
    const auto found = std::ranges::find(kinds, name, &FileKindInfo::name);
    if (found != kinds.end()) return found->kind;
    std::vector<std::string_view> names;
    for (const FileKindInfo& info : kinds) names.push_back(info.name);
    throw UsageError(DescribeUnknown("--format", name, names));
}

bool LooksLikeFile(std::string_view word) { return word.find('/') != std::string_view::npos || KindOfEnding(word); }

std::string DescribeFileKinds() {
    std::string text;
    for (const FileKindInfo& info : kinds) {
        text += fmt::format("{}*{} ({})", text.empty() ? "" : ", ", info.ending, info.what);
    }
    return text;
}

}  // namespace testbed
