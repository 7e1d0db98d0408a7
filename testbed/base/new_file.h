// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A file that appears whole under its name or not at all: it grows under a temporary name in the same folder and takes
// its own when it is done. What is no regular file, such as a device or a pipe, is written in place and stays what it
// is; of a link the target is written. "-" is standard output.
//
//     NewFile file("out/plot.svg");
//     DrawPlot(plot, "svg", file.GetPlace());
//     file.Finish();

#pragma once

#include <filesystem>
#include <string_view>

namespace testbed {

class NewFile {
public:
    /// Writes nothing yet.
    explicit NewFile(std::filesystem::path path);
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&& other) = delete;
    /// Removes what was not finished.
    ~NewFile();

    /// The name as it was given.
    [[nodiscard]] const std::filesystem::path& GetPath() const { return m_path; }
    /// Where to write until it is finished: a name that no other process uses.
    [[nodiscard]] const std::filesystem::path& GetPlace() const { return m_place; }

    /// Writes all of `content` to the place. Throws FileError with the reason.
    void Write(std::string_view content);
    /// Gives the file its name. Throws FileError with the reason.
    void Finish();

private:
    std::filesystem::path m_path;
    std::filesystem::path m_target;  ///< m_path behind its links
    std::filesystem::path m_place;
    bool m_isInPlace;      ///< the target is no regular file: its bytes are copied into it
    int m_entry = -1;      ///< of the list of files that a signal removes; −1: none
    bool m_isOpen = true;  ///< neither finished nor moved away
};

/// Throws FileError if a file of this name could not be written, so that it is known before a long run. The empty name
/// is no file.
void CheckCanWrite(const std::filesystem::path& path);

/// Writes a whole file by a NewFile. Throws FileError.
void WriteTextFile(const std::filesystem::path& path, std::string_view text);

/// From here on a file named "-" is what standard output was, and all that is printed goes to standard error.
void GiveStandardOutputToFiles();

/// Removes unfinished files when Ctrl-C or another signal ends the program; it then ends as it would without this.
/// Writes to a pipe without a reader, and beyond a limit of file sizes, become errors instead of signals.
void RemoveUnfinishedFilesOnSignals();
/// A standard output or error that is closed fails every write. Without this the next file that is opened would become
/// it.
void HoldStandardFiles();
/// Throws FileError with the reason if something that was printed did not reach standard output.
void CheckStandardOutput();

}  // namespace testbed
