// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Runs the built `scree` in a folder of its own.

#include "tests/testbed/program.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace testbed {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "scree-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    m_path = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

ProgramResult ScratchFolder::Run(const std::string& arguments, const std::string& before) const {
    const std::string command =
        "cd '" + m_path.string() + "' && " + before + " '" SCREE_PROGRAM "' " + arguments + " 2>&1 </dev/null";
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
    ProgramResult result;
    char buffer[4096];
    for (std::size_t count = 0; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) {
        result.output.append(buffer, count);
    }
    const int status = pclose(pipe);
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

ProgramResult ScratchFolder::RunOnFullDisk(const std::string& arguments, int blocks) const {
    // The limit also cuts what a program built for test coverage counts. That goes elsewhere, lest other tests read it.
    const ScratchFolder counts;
    const std::string limit = "ulimit -f " + std::to_string(blocks) + "; ";
    return Run(arguments, limit + "GCOV_PREFIX='" + counts.GetPath().string() + "'");
}

std::string ScratchFolder::Read(const fs::path& relative) const {
    std::ifstream stream(m_path / relative, std::ios::binary);
    if (!stream) throw std::runtime_error("no file " + relative.string());
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool ScratchFolder::Has(const fs::path& relative) const { return fs::exists(m_path / relative); }

std::set<std::string> FilesBelow(const std::filesystem::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.insert(std::filesystem::relative(entry.path(), folder).generic_string());
    }
    return files;
}

}  // namespace testbed
