// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A folder of a name that is free, removed with the object.

#pragma once

#include <filesystem>
#include <string_view>

namespace testbed {

class TemporaryFolder {
public:
    /// Its name begins with `name`. Throws FileError if it cannot be made.
    explicit TemporaryFolder(std::string_view name);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& GetPath() const { return m_path; }

private:
    std::filesystem::path m_path;
};

}  // namespace testbed
