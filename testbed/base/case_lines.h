// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Results of a command with many cases as JSON lines, one object a line, each beginning with
//     {"command": "snapshot check", "case": 17, "cases": 172, …
// `case` is the case's number in the whole, unsharded run, and `cases` is how many there are. So the files of all
// shards can be joined in the order of an unsharded run, and what is missing or twice is seen. A case may have several
// lines; they keep their order. Wall times belong into one field named "ms", for all else is the same in every run.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace testbed {

/// Lines as they are collected.
class CaseLines {
public:
    /// `command` without options; `caseCount` of the whole run, not of the shard.
    /// `made` says where measurements come from (engines/provenance.h) and stands in every line; null for results that
    /// are the same everywhere.
    CaseLines(std::string command, std::size_t caseCount, nlohmann::ordered_json made = {});

    /// What is added from here on is also kept in `file` + ".part", each case when the next one begins: a run that is
    /// stopped loses the case under way alone. With `resume` the cases of such a file are taken over. Empty names,
    /// devices and "-" have no such file. Throws FileError, also for lines of another run or build.
    void Keep(const std::filesystem::path& file, bool resume);

    /// `fields` is an object; its fields follow the common ones. `caseNumber` < caseCount. Throws FileError.
    void Add(std::size_t caseNumber, const nlohmann::ordered_json& fields);
    /// Whether the case was added or taken over.
    [[nodiscard]] bool Has(std::size_t caseNumber) const { return m_cases.contains(caseNumber); }
    /// In the order of cases.
    [[nodiscard]] std::string GetText() const;
    /// Writes the kept file whole and removes its part. Nothing without Keep or for an empty name.
    void Finish();

private:
    void AppendPending();

    std::string m_command;
    std::size_t m_caseCount;
    nlohmann::ordered_json m_made;
    std::string m_text;
    std::set<std::size_t> m_cases;
    std::filesystem::path m_file, m_part;
    std::string m_pending;   ///< of the case under way
    std::size_t m_last = 0;  ///< the case of the last line
};

/// The content of one file of lines.
struct CaseFile {
    std::string name;  ///< for messages
    std::string text;
};

struct MergedLines {
    std::string command;                       ///< empty: no line
    std::string text;                          ///< all lines by case, as an unsharded run writes them
    std::size_t caseCount = 0;                 ///< of the whole run
    std::vector<std::size_t> missing;          ///< numbers of the cases that no file has
    std::vector<nlohmann::ordered_json> made;  ///< what the lines say of where they come from, each once
};

/// Joins the files of the shards of one run, which are all of one build: of one commit, compiler, flags and versions.
/// The order of the files does not matter. Throws FileError naming file and
/// line for a line that is no such object, another command or case count, or a case that is there twice.
[[nodiscard]] MergedLines MergeCaseLines(std::span<const CaseFile> files);

/// The lines of a whole run of `command`. Throws FileError that names the file for one that has none, for lines of
/// another command, cases that are missing or there twice, and all that MergeCaseLines refuses.
[[nodiscard]] MergedLines ReadCaseText(const std::filesystem::path& file, std::string_view command);
/// Calls `read` with the object of each of these lines; what `read` throws becomes a FileError that names the line.
/// Returns MergedLines::made.
std::vector<nlohmann::ordered_json> ReadCaseLines(
    const std::filesystem::path& file, std::string_view command,
    const std::function<void(const nlohmann::ordered_json& object)>& read);

}  // namespace testbed
