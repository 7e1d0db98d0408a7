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
    FileKindInfo{FileKind::rube, "rube", ".json", "{", "a world exported by the editor R.U.B.E."},
};

/// The keys of the outermost object of a JSON text, as far as they can be told of what may be damaged.
std::vector<std::string_view> KeysOfJson(std::string_view text) {
    std::vector<std::string_view> keys;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        depth += (c == '{' || c == '[') - (c == '}' || c == ']');
        if (c != '"') continue;
        const std::size_t begin = i + 1;
        for (++i; i < text.size() && text[i] != '"'; ++i) i += text[i] == '\\';
        const std::size_t next = text.find_first_not_of(" \t\r\n", i + 1);
        if (depth != 1 || next == std::string_view::npos || text[next] != ':') continue;
        keys.push_back(text.substr(begin, i - begin));
    }
    return keys;
}

std::optional<FileKind> KindOfJson(std::string_view text) {
    const std::vector<std::string_view> keys = KeysOfJson(text);
    const auto has = [&](std::string_view key) { return std::ranges::find(keys, key) != keys.end(); };
    if (has("format") || has("bodies")) return FileKind::scene;
    if (has("gravity") && (has("body") || has("stepsPerSecond"))) return FileKind::rube;
    return std::nullopt;
}

}  // namespace

std::span<const FileKindInfo> FileKinds() { return kinds; }

const FileKindInfo& GetInfo(FileKind kind) { return *std::ranges::find(kinds, kind, &FileKindInfo::kind); }

std::optional<FileKind> KindOfEnding(std::string_view path) {
    for (const FileKindInfo& info : kinds) {
        if (path == info.ending) return std::nullopt;  // not the shorter ending of a name either
        if (path.ends_with(info.ending)) return info.kind;
    }
    return std::nullopt;
}

std::optional<FileKind> KindOfBytes(std::string_view bytes) {
    if (const std::size_t first = bytes.find_first_not_of(" \t\r\n");
        first != std::string_view::npos && bytes[first] == '{') {
        return KindOfJson(bytes);
    }
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
