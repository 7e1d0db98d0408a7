// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs the built `scree` in a folder of its own: arguments in, exit code and output out.

#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace testbed {

struct ProgramResult {
    int exitCode = -1;
    std::string output;  ///< stdout and stderr together
};

/// An empty folder, removed with the object.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& GetPath() const { return m_path; }
    /// `scree ARGUMENTS` (quoted for the shell by the caller) inside the folder; `before` goes in front, for example an
    /// environment variable.
    [[nodiscard]] ProgramResult Run(const std::string& arguments, const std::string& before = "") const;
    /// The same with a limit of file sizes, in blocks of 512 bytes, which stands for a disk that is full.
    [[nodiscard]] ProgramResult RunOnFullDisk(const std::string& arguments, int blocks) const;
    [[nodiscard]] std::string Read(const std::filesystem::path& relative) const;
    [[nodiscard]] bool Has(const std::filesystem::path& relative) const;

private:
    std::filesystem::path m_path;
};

/// The files in `folder` and below it, relative to it.
[[nodiscard]] std::set<std::string> FilesBelow(const std::filesystem::path& folder);

}  // namespace testbed
