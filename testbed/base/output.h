// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The folder that a command writes to: checked before the long run, every file replaced whole, and a list
// kept of what was written.

#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "testbed/base/new_file.h"

namespace testbed {

/// "files:" and the paths, one a line; of many files the first and the last ones.
[[nodiscard]] std::string FormatFiles(std::span<const std::string> files);

class OutputFolder {
public:
    /// Creates the folder and writes and removes a file in it. Throws FileError, so that an unwritable place is known
    /// before any work is done.
    explicit OutputFolder(std::filesystem::path root);

    /// Path of a file below the folder; creates the folders between. Throws FileError.
    [[nodiscard]] std::filesystem::path Prepare(const std::filesystem::path& relative) const;

    void WriteText(const std::filesystem::path& relative, std::string_view text);
    /// Lets `write` write a file at the place that it is given; what `write` throws passes through.
    void WriteBy(const std::filesystem::path& relative,
                 const std::function<void(const std::filesystem::path& place)>& write);

    /// A file that grows for a while. Throws FileError.
    [[nodiscard]] NewFile Begin(const std::filesystem::path& relative) const;
    /// Finishes one that was begun.
    void Finish(NewFile& file);

    /// Everything written so far, in order: the folder as it was given, then the relative path.
    [[nodiscard]] const std::vector<std::string>& GetFiles() const { return m_files; }

private:
    std::filesystem::path m_root;
    std::vector<std::string> m_files;
};

}  // namespace testbed
