// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The folder that a command writes to.

#include "testbed/base/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iterator>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"

namespace testbed {

namespace fs = std::filesystem;

std::string FormatFiles(std::span<const std::string> files) {
    // Enough for the default run of two scenes; a long series is its first and last files.
    constexpr std::size_t most = 24, ends = 8;
    std::string text = fmt::format("{} files:\n", files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files.size() > most && i == ends) {
            text += "  …\n";
            i = files.size() - ends;
        }
        fmt::format_to(std::back_inserter(text), "  {}\n", files[i]);
    }
    return text;
}

OutputFolder::OutputFolder(fs::path root) : m_root(std::move(root)) {
    const fs::path probe = Prepare(fmt::format(".probe.{}", getpid()));
    WriteTextFile(probe, "");
    std::error_code ignored;
    fs::remove(probe, ignored);
}

fs::path OutputFolder::Prepare(const fs::path& relative) const {
    const fs::path path = m_root / relative;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
        throw FileError(fmt::format("cannot create the folder {}: {}; choose another with -o DIR",
                                    path.parent_path().string(), error.message()));
    }
    return path;
}

void OutputFolder::WriteText(const fs::path& relative, std::string_view text) {
    NewFile file = Begin(relative);
    file.Write(text);
    Finish(file);
}

void OutputFolder::WriteBy(const fs::path& relative, const std::function<void(const fs::path& place)>& write) {
    NewFile file = Begin(relative);
    write(file.GetPlace());
    Finish(file);
}

NewFile OutputFolder::Begin(const fs::path& relative) const { return NewFile(Prepare(relative)); }

void OutputFolder::Finish(NewFile& file) {
    file.Finish();
    m_files.push_back(file.GetPath().string());
}

}  // namespace testbed
