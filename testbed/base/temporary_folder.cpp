// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of temporary_folder.h.

#include "testbed/base/temporary_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>

#include "testbed/base/errors.h"

namespace testbed {

TemporaryFolder::TemporaryFolder(std::string_view name) {
    std::string path = (std::filesystem::temp_directory_path() / fmt::format("{}-XXXXXX", name)).string();
    if (mkdtemp(path.data()) == nullptr) throw FileError(fmt::format("{}: cannot make this folder", path));
    m_path = path;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

}  // namespace testbed
