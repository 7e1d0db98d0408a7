// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The checkout as the architecture tests see it.

#include "source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace architecture {

namespace fs = std::filesystem;

namespace {

bool IsSource(const fs::path& path) {
    static constexpr std::array<std::string_view, 8> endings = {".h",    ".cpp",  ".inc", ".in",
                                                                ".vert", ".frag", ".sh",  ".py"};
    const std::string ending = path.extension().string();
    return path.filename() == "run" || (std::find(endings.begin(), endings.end(), ending) != endings.end() &&
                                        path.extension() != ".pc.in" && !path.string().ends_with(".pc.in"));
}

std::vector<SourceFile> ReadAll() {
    std::vector<SourceFile> files;
    for (const char* folder : {"engine", "scenes", "testbed", "shaders", "tests", ".ci"}) {
        if (!fs::exists(Root() / folder)) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(Root() / folder)) {
            if (!entry.is_regular_file() || !IsSource(entry.path())) continue;
            files.push_back(ReadSource(fs::relative(entry.path(), Root())));
        }
    }
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

}  // namespace

std::vector<std::string> SourceFile::Includes() const {
    static const std::regex pattern(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
    std::vector<std::string> names;
    for (const std::string& line : lines) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) names.push_back(match[1]);
    }
    return names;
}

fs::path Root() { return SCREE_SOURCE_DIR; }

const std::vector<SourceFile>& SourceFiles() {
    static const std::vector<SourceFile> files = ReadAll();
    return files;
}

SourceFile ReadSource(const fs::path& relative) {
    SourceFile file{relative.generic_string(), {}};
    std::ifstream stream(Root() / relative);
    if (!stream) throw std::runtime_error("cannot read " + file.path);
    for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
    return file;
}

std::vector<std::string> FindIncludes(std::string_view folder,
                                      const std::function<bool(const std::string&)>& forbidden) {
    std::vector<std::string> found;
    for (const SourceFile& file : SourceFiles()) {
        if (!file.path.starts_with(folder)) continue;
        for (const std::string& name : file.Includes()) {
            if (forbidden(name)) found.push_back(file.path + " includes " + name);
        }
    }
    return found;
}

}  // namespace architecture
