// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The checkout as the architecture tests see it: files, their lines and their includes.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace architecture {

struct SourceFile {
    std::string path;  ///< from the checkout's root, with slashes
    std::vector<std::string> lines;

    /// The names between quotes or angle brackets of its #include lines.
    [[nodiscard]] std::vector<std::string> Includes() const;
    [[nodiscard]] bool IsHeader() const { return path.ends_with(".h"); }
};

/// Root of the checkout.
[[nodiscard]] std::filesystem::path Root();

/// All files below engine, scenes, testbed, shaders, tests and .ci that people write as programs: C++, shaders, shell.
[[nodiscard]] const std::vector<SourceFile>& SourceFiles();

[[nodiscard]] SourceFile ReadSource(const std::filesystem::path& relative);

/// Files of `folder` (a path prefix such as "engine/src/") that include something `forbidden` says yes to, as
/// "path includes name" lines. Empty: the rule holds.
[[nodiscard]] std::vector<std::string> FindIncludes(std::string_view folder,
                                                    const std::function<bool(const std::string&)>& forbidden);

}  // namespace architecture
