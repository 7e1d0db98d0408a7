// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A search of PATH, as the shell does it.

#include "testbed/base/tool.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

namespace testbed {

bool IsInstalled(std::string_view program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

}  // namespace testbed
