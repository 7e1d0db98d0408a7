// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Results of a command with many cases as JSON lines.

#include "testbed/base/case_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/json_lines.h"
#include "testbed/base/text.h"

namespace testbed {

namespace {

using Json = nlohmann::ordered_json;

/// The lines of one case and the file that they came from.
struct CaseText {
    const CaseFile* file;
    std::string text;
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

[[noreturn]] void Refuse(const CaseFile& file, std::size_t lineNumber, const std::string& problem) {
    throw FileError(fmt::format("{}:{}: {}", file.name, lineNumber, problem));
}

void Merger::AddMade(const CaseFile& file, std::size_t lineNumber, const Json& own) {
    if (!own.is_object()) Refuse(file, lineNumber, "\"made\" is no object");
    if (std::ranges::find(made, own) != made.end()) return;
    for (const char* key : {"commit", "compiler", "flags", "versions"}) {
        if (made.empty() || own.value(key, Json()) == made.front().value(key, Json())) continue;
        Refuse(file, lineNumber,
               fmt::format("of another build: {} {}, before it {}; measure both with one build", key,
                           own.value(key, Json()).dump(), made.front().value(key, Json()).dump()));
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
    const auto [place, isNew] = cases.try_emplace(number, CaseText{&file, {}});
    if (!isNew && place->second.file != &file) {
        Refuse(file, lineNumber,
               fmt::format("case {} is also in {}; give every shard once", number, place->second.file->name));
    }
    if (!isNew && number != last) {
        Refuse(file, lineNumber, fmt::format("case {} is in this file twice; give every shard once", number));
    }
    last = number;
    if (object.contains("made")) AddMade(file, lineNumber, object["made"]);
    place->second.text.append(line) += "\n";
}

}  // namespace

CaseLines::CaseLines(std::string command, std::size_t caseCount, Json made)
    : m_command(std::move(command)), m_caseCount(caseCount), m_made(std::move(made)) {}

void CaseLines::Add(std::size_t caseNumber, const Json& fields) {
    Json line = {{"command", m_command}, {"case", caseNumber}, {"cases", m_caseCount}};
    for (const auto& [key, value] : fields.items()) line[key] = value;
    if (!m_made.is_null()) line["made"] = m_made;
    m_text += line.dump() + "\n";
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
