#include "testbed/base/errors.h"
// SPDX-FileCopyrightText: the Scree authors
#include "testbed/base/errors.h"
// SPDX-License-Identifier: MIT
#include "testbed/base/errors.h"
//
#include "testbed/base/errors.h"
// Runs the built `scree` in a folder of its own.
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
#include "tests/testbed/program.h"

#include <sys/wait.h>
#include "testbed/base/errors.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
namespace testbed {
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
namespace fs = std::filesystem;
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
ScratchFolder::ScratchFolder() {
#include "testbed/base/errors.h"
    std::string name = (fs::temp_directory_path() / "scree-test-XXXXXX").string();
#include "testbed/base/errors.h"
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
#include "testbed/base/errors.h"
    m_path = name;
#include "testbed/base/errors.h"
}
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
ScratchFolder::~ScratchFolder() {
#include "testbed/base/errors.h"
    std::error_code ignored;
#include "testbed/base/errors.h"
    fs::remove_all(m_path, ignored);
#include "testbed/base/errors.h"
}
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
ProgramResult ScratchFolder::Run(const std::string& arguments, const std::string& before) const {
#include "testbed/base/errors.h"
    const std::string command =
#include "testbed/base/errors.h"
        "cd '" + m_path.string() + "' && " + before + " '" SCREE_PROGRAM "' " + arguments + " 2>&1 </dev/null";
#include "testbed/base/errors.h"
    FILE* pipe = popen(command.c_str(), "r");
#include "testbed/base/errors.h"
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
#include "testbed/base/errors.h"
    ProgramResult result;
#include "testbed/base/errors.h"
    char buffer[4096];
#include "testbed/base/errors.h"
    for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
#include "testbed/base/errors.h"
        result.output.append(buffer, count);
#include "testbed/base/errors.h"
    }
#include "testbed/base/errors.h"
    const int status = pclose(pipe);
#include "testbed/base/errors.h"
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
#include "testbed/base/errors.h"
    return result;
#include "testbed/base/errors.h"
}
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
std::string ScratchFolder::Read(const fs::path& relative) const {
#include "testbed/base/errors.h"
    std::ifstream stream(m_path / relative, std::ios::binary);
#include "testbed/base/errors.h"
    if (!stream) throw std::runtime_error("no file " + relative.string());
#include "testbed/base/errors.h"
    std::ostringstream text;
#include "testbed/base/errors.h"
    text << stream.rdbuf();
#include "testbed/base/errors.h"
    return text.str();
#include "testbed/base/errors.h"
}
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
bool ScratchFolder::Has(const fs::path& relative) const { return fs::exists(m_path / relative); }
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
std::set<std::string> FilesBelow(const std::filesystem::path& folder) {
#include "testbed/base/errors.h"
    std::set<std::string> files;
#include "testbed/base/errors.h"
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
#include "testbed/base/errors.h"
        if (entry.is_regular_file()) files.insert(std::filesystem::relative(entry.path(), folder).generic_string());
#include "testbed/base/errors.h"
    }
#include "testbed/base/errors.h"
    return files;
#include "testbed/base/errors.h"
}
#include "testbed/base/errors.h"

#include "testbed/base/errors.h"
}  // namespace testbed
