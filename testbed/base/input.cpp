// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Files that people name.

#include "testbed/base/input.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "testbed/base/errors.h"
#include "testbed/base/output.h"

namespace testbed {

std::string ReadText(const std::filesystem::path& file, std::string_view cure) {
    if (std::filesystem::is_directory(file)) throw FileError(fmt::format("{}: a folder; {}", file.string(), cure));
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw FileError(fmt::format("{}: cannot be read; {}", file.string(), cure));
    return text;
}

nlohmann::ordered_json ReadJsonObject(const std::filesystem::path& file) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(ReadText(file, "check its path"), nullptr, false);
    if (!json.is_object()) throw FileError(fmt::format("{}: not a JSON object", file.string()));
    return json;
}

}  // namespace testbed
