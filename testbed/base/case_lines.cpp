// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Results of a command with many cases as JSON lines.

#include "testbed/base/case_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/json_lines.h"
#include "testbed/base/json_print.h"
#include "testbed/base/new_file.h"
#include "testbed/base/text.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

/// The lines of one case and the file that they came from.
struct CaseText {
    const CaseFile* file;
    std::string text;
    std::set<std::string> told;  ///< lines without what differs from run to run
};

struct Merger {
    std::string command;
    std::size_t caseCount = 0;
    std::size_t last = 0;  ///< the case of the line before
    std::map<std::size_t, CaseText> cases;
    std::vector<Json> made;  ///< each once

    void Add(const CaseFile& file, std::size_t lineNumber, std::string_view line);
    void AddMade(const CaseFile& file, std::size_t lineNumber, const Json& own);
};

/// In what two builds differ, empty if in nothing.
std::string FindOtherBuild(const Json& own, const Json& before) {
    for (const char* key : {"commit", "compiler", "flags", "versions"}) {
        const Json a = own.value(key, Json()), b = before.value(key, Json());
        if (a != b) return fmt::format("{} {}, before it {}", key, PrintJson(a), PrintJson(b));
    }
    return "";
}

/// All of a line that is the same in every run.
std::string WithoutTimes(Json line) {
    for (const char* key : {"ms", "made"}) line.erase(key);
    return PrintJson(line);
}

[[noreturn]] void Refuse(const CaseFile& file, std::size_t lineNumber, const std::string& problem) {
    throw FileError(fmt::format("{}:{}: {}", file.name, lineNumber, problem));
}

void Merger::AddMade(const CaseFile& file, std::size_t lineNumber, const Json& own) {
    if (!own.is_object()) Refuse(file, lineNumber, "\"made\" is not an object");
    if (std::ranges::find(made, own) != made.end()) return;
    const std::string problem = made.empty() ? "" : FindOtherBuild(own, made.front());
    if (!problem.empty()) {
        Refuse(file, lineNumber, fmt::format("of another build: {}; measure both with one build", problem));
    }
    made.push_back(own);
}

void Merger::Add(const CaseFile& file, std::size_t lineNumber, std::string_view line) {
    const Json object = Json::parse(line, nullptr, false);
    const auto isCount = [&](const char* key) { return object.contains(key) && object[key].is_number_unsigned(); };
    if (!object.is_object() || !object.contains("command") || !object["command"].is_string() || !isCount("case") ||
        !isCount("cases")) {
        Refuse(file, lineNumber, "not a line that `--json` wrote: an object with command, case and cases");
    }
    const auto ownCommand = object["command"].get<std::string>();
    const auto number = object["case"].get<std::size_t>(), count = object["cases"].get<std::size_t>();
    if (caseCount == 0) {
        command = ownCommand;
        caseCount = count;
    }
    if (ownCommand != command || count != caseCount) {
        Refuse(file, lineNumber,
               fmt::format("from another run: `{}` with {} cases, before it `{}` with {}; merge the shards of one run",
                           ownCommand, count, command, caseCount));
    }
    if (number >= count) Refuse(file, lineNumber, fmt::format("case {} of {}: numbers begin at 0", number, count));
    const auto [place, isNew] = cases.try_emplace(number, CaseText{&file, {}, {}});
    if (!isNew && place->second.file != &file) {
        Refuse(file, lineNumber,
               fmt::format("case {} is also in {}; give every shard once", number, place->second.file->name));
    }
    if (!isNew && number != last) {
        Refuse(file, lineNumber, fmt::format("case {} is in this file twice; give every shard once", number));
    }
    last = number;
    if (!place->second.told.insert(WithoutTimes(object)).second) {
        Refuse(file, lineNumber, fmt::format("case {} is in this file twice; give every shard once", number));
    }
    if (object.contains("made")) AddMade(file, lineNumber, object["made"]);
    place->second.text.append(line) += "\n";
}

}  // namespace

CaseLines::CaseLines(std::string command, std::size_t caseCount, Json made)
    : m_command(std::move(command)), m_caseCount(caseCount), m_made(std::move(made)) {}

void CaseLines::Keep(const std::filesystem::path& file, bool resume) {
    m_file = file;
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(file, ignored);
    const bool isPlace = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
    if (file.empty() || file == "-" || isPlace) return;
    m_part = file;
    m_part += ".part";
    if (!resume || !std::filesystem::exists(m_part)) return WriteTextFile(m_part, "");
    std::string text = ReadText(m_part, "run without --resume");
    text.resize(text.rfind('\n') + 1);  // a line that was cut
    const CaseFile own{m_part.string(), text};
    const MergedLines merged = MergeCaseLines(std::span(&own, 1));
    const std::string cure = "; give the same options, or run without --resume";
    if (merged.caseCount != 0 && (merged.command != m_command || merged.caseCount != m_caseCount)) {
        throw FileError(fmt::format("{}: of `{}` with {} cases, not of `{}` with {}{}", own.name, merged.command,
                                    merged.caseCount, m_command, m_caseCount, cure));
    }
    for (const Json& made : merged.made) {
        if (const std::string problem = FindOtherBuild(made, m_made); !problem.empty()) {
            throw FileError(fmt::format("{}: of another build: {}{}", own.name, problem, cure));
        }
    }
    std::set<std::size_t> missing(merged.missing.begin(), merged.missing.end());
    for (std::size_t i = 0; i < merged.caseCount; ++i) {
        if (!missing.contains(i)) m_cases.insert(i);
    }
    m_text = merged.text;
    WriteTextFile(m_part, m_text);
}

void CaseLines::Add(std::size_t caseNumber, const Json& fields) {
    Json line = {{"command", m_command}, {"case", caseNumber}, {"cases", m_caseCount}};
    for (const auto& [key, value] : fields.items()) line[key] = value;
    if (!m_made.is_null()) line["made"] = m_made;
    if (caseNumber != m_last) AppendPending();
    m_last = caseNumber;
    m_cases.insert(caseNumber);
    m_pending += PrintJson(line) + "\n";
}

void CaseLines::AppendPending() {
    m_text += m_pending;
    if (!m_part.empty()) {
        std::ofstream stream(m_part, std::ios::binary | std::ios::app);
        stream << m_pending;
        stream.close();
        if (!stream) throw FileError(fmt::format("cannot write {}: is the disk full?", m_part.string()));
    }
    m_pending.clear();
}

std::string CaseLines::GetText() const {
    const CaseFile all{m_command, m_text + m_pending};
    return MergeCaseLines(std::span(&all, 1)).text;
}

void CaseLines::Finish() {
    if (m_file.empty()) return;
    WriteTextFile(m_file, GetText());
    std::error_code ignored;
    if (!m_part.empty()) std::filesystem::remove(m_part, ignored);
}

MergedLines MergeCaseLines(std::span<const CaseFile> files) {
    Merger merger;
    for (const CaseFile& file : files) {
        ForEachLine(file.text, [&](std::size_t number, std::string_view line) { merger.Add(file, number, line); });
    }
    MergedLines merged;
    merged.command = merger.command;
    merged.made = merger.made;
    merged.caseCount = merger.caseCount;
    for (std::size_t number = 0; number < merger.caseCount; ++number) {
        const auto place = merger.cases.find(number);
        if (place == merger.cases.end()) {
            merged.missing.push_back(number);
        } else {
            merged.text += place->second.text;
        }
    }
    return merged;
}

MergedLines ReadCaseText(const std::filesystem::path& path, std::string_view command) {
    const std::string cure = fmt::format("give one that `scree {} --json` or `scree merge` wrote", command);
    const CaseFile file{path.string(), ReadText(path, cure)};
    MergedLines merged = MergeCaseLines(std::span(&file, 1));
    if (merged.caseCount == 0) throw FileError(fmt::format("{}: there is no line in it; {}", file.name, cure));
    if (merged.command != command) {
        throw FileError(fmt::format("{}: of `scree {}`, not of `scree {}`", file.name, merged.command, command));
    }
    if (!merged.missing.empty()) {
        throw FileError(
            fmt::format("{}: {} of {} cases are missing, the first is case {}; join the files of all "
                        "shards with `scree merge`",
                        file.name, merged.missing.size(), merged.caseCount, merged.missing.front()));
    }
    merged.text = file.text;  // in its own order, so that numbers of lines are the file's
    return merged;
}

std::vector<Json> ReadCaseLines(const std::filesystem::path& file, std::string_view command,
                                const std::function<void(const Json& object)>& read) {
    MergedLines merged = ReadCaseText(file, command);
    ParseJsonLines(file.string(), merged.text, command, read);
    return std::move(merged.made);
}

}  // namespace testbed
